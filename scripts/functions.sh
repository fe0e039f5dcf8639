# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Shared by the scripts, which source it: where things are, building, and the count of passed and
# failed checks.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

parallel_jobs=${VFC_JOBS:-$(nproc)}

say() { printf '\n== %s\n' "$*"; }

die() {
  echo "$*" >&2
  exit 1
}

# configure DIRECTORY [OPTION...]
configure() {
  local directory=$1
  shift
  cmake -S . -B "$directory" -G Ninja -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON "$@"
}

# build DIRECTORY [TARGET...]; goes on after an error, so that one run shows them all.
build() {
  local directory=$1
  shift
  cmake --build "$directory" -j "$parallel_jobs" --target "${@:-all}" -- -k 0
}

# clang++ spends a fifth of its time in malloc(). With jemalloc it takes a sixth less: 268 instead of
# 324 s for a unit of tests. g++ has its own allocator and gains nothing. Where jemalloc is missing,
# ld.so complains and goes on without.
clang=(-DCMAKE_CXX_COMPILER=clang++ "-DCMAKE_CXX_COMPILER_LAUNCHER=env;LD_PRELOAD=libjemalloc.so.2")

# Options of builds with sanitizers. Without -g1, which takes a twelfth of the time to compile:
# reports name functions, and lines if behaviour is undefined.
with_assertions=(-DVFC_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Debug
  -DCMAKE_CXX_FLAGS_DEBUG="-O2 -D_GLIBCXX_ASSERTIONS")
sanitized=("${with_assertions[@]}" -DVFC_SANITIZE=address,undefined "${clang[@]}")

# --- The count. Checks are lines "passed|failed|skipped <tab> name <tab> reason" of a file, which
# --- a script shares with the scripts that it calls.

begin_count() {
  if [[ -z ${VFC_RESULTS:-} ]]; then
    VFC_RESULTS=$(mktemp)
    export VFC_RESULTS
  fi
  failed_before=$(grep -c ^failed "$VFC_RESULTS" || true)
}

# record passed|failed|skipped NAME [REASON]
record() { printf '%s\t%s\t%s\n' "$1" "$2" "${3:-}" >>"$VFC_RESULTS"; }

# check NAME COMMAND...: runs the command, records whether it succeeded and returns that.
check() {
  local name=$1 start=$SECONDS
  shift
  say "$name"
  if "$@"; then
    record passed "$name"
    echo "$name: passed in $((SECONDS - start)) s"
  else
    record failed "$name"
    echo "$name: FAILED after $((SECONDS - start)) s"
    return 1
  fi
}

# Prints what was skipped and what failed, then the count as the last line. Fails if a check has
# failed since begin_count, so that a script is not blamed for those of the scripts before it.
end_count() {
  awk -F '\t' -v failed_before="$failed_before" '
    { count[$1]++ }
    $1 == "failed"  { failed = failed "  " $2 "\n" }
    $1 == "skipped" { names[$3] = names[$3] " " $2 }
    END {
      for (reason in names) printf "Skipped (%s):%s\n", reason, names[reason]
      if (failed) printf "Failed:\n%s", failed
      if (count["skipped"]) printf "%d skipped\n", count["skipped"]
      printf "%d passed, %d failed\n", count["passed"], count["failed"]
      exit count["failed"] > failed_before || !count["passed"]
    }' "$VFC_RESULTS"
}
