// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Solving P d = -g: sparse Cholesky against conjugate gradients preconditioned with the tridiagonal
// part, on curves whose strands hardly touch yet and on tight ones. internal::Direction_solver
// takes the faster one.

#include "Flow_sample.h"

#include <CGAL/Volume_filling_curves/internal/flow/Contact_stiffness.h>
#include <CGAL/Volume_filling_curves/internal/flow/Direction_solver.h>

#include <Eigen/SparseCholesky>

namespace {

using namespace vfc_benchmark;
using vfc::internal::Sparse_matrix;

using Sample = const Flow_sample& (*)(std::int64_t);

void cholesky(benchmark::State& state, Sample make_sample)
{
  const Flow_sample& sample = make_sample(state.range(0));
  const Sparse_matrix p = sample.preconditioner();
  const Eigen::Matrix<double, Eigen::Dynamic, 3> b = -sample.gradient;
  Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Lower> factorization;
  for(auto _ : state) {
    factorization.compute(p);
    const Vector_field d = factorization.solve(b);
    benchmark::DoNotOptimize(d.data());
  }
  state.counters["entries_per_row"] =
      static_cast<double>(p.nonZeros()) / static_cast<double>(p.rows());
  count_nodes(state, sample);
}

void conjugate_gradients(benchmark::State& state, Sample make_sample)
{
  const Flow_sample& sample = make_sample(state.range(0));
  const Sparse_matrix p = sample.preconditioner();
  const Vector_field b = -sample.gradient;
  const vfc::internal::Contact_stiffness no_contacts;
  const double tolerance = 1e-4;
  vfc::internal::Tridiagonal_conjugate_gradients solve;
  for(auto _ : state) {
    const Vector_field d = solve(p, no_contacts, b, {}, tolerance);
    benchmark::DoNotOptimize(d.data());
  }
  state.counters["entries_per_row"] =
      static_cast<double>(p.nonZeros()) / static_cast<double>(p.rows());
  count_nodes(state, sample);
}
void tight_sizes(benchmark::internal::Benchmark* benchmark)
{
  for(int p : {2, 3, 5, 8, 13, 21}) benchmark->Arg(p);
}

BENCHMARK_CAPTURE(cholesky, tight, tight_torus_knot)->Apply(tight_sizes);
BENCHMARK_CAPTURE(conjugate_gradients, tight, tight_torus_knot)->Apply(tight_sizes);
BENCHMARK_CAPTURE(cholesky, tangled, tangled_unknot)->Arg(32)->Arg(700);
BENCHMARK_CAPTURE(conjugate_gradients, tangled, tangled_unknot)->Arg(32)->Arg(700)->Arg(100000);

} // namespace
