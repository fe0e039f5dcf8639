# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# apt for other packages than this machine's: with lists and archives of its own, so that nothing is
# installed and the machine's stay as they are. Sourced after functions.sh.

# begin_private_apt FOLDER deb|deb-src SUITE: reads the suite's lists from the machine's mirror.
begin_private_apt() {
  local keyring=/usr/share/keyrings/debian-archive-keyring.gpg site
  private_apt_folder=$1
  command -v apt-get >/dev/null || return
  site=$(debian_mirror)
  [[ -n $site ]] || { apt-get update && site=$(debian_mirror) && [[ -n $site ]]; } || return
  mkdir -p "$1/lists/partial" "$1/archives/archives/partial"
  echo "$2 [signed-by=$keyring] $site $3 main" >"$1/sources.list"
  private_apt update
}

# The mirror that this machine's apt uses for Debian itself.
debian_mirror() {
  # shellcheck disable=SC2016 # apt expands these
  apt-get indextargets --format '$(LABEL) $(REPO_URI)' 'Created-By: Packages' |
    awk '$1 == "Debian" && !site { site = $2 } END { print site }'
}

private_apt() {
  local folder=$private_apt_folder
  apt-get -o Dir::Etc::SourceList="$folder/sources.list" -o Dir::Etc::SourceParts=/dev/null \
    -o Dir::State::Lists="$folder/lists" -o Dir::Cache="$folder/archives" \
    -o Acquire::Languages=none -o APT::Sandbox::User=root \
    -o Acquire::Retries=3 -o Acquire::http::Timeout=30 "$@" </dev/null
}
