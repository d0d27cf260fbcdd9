// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// On a surface of revolution one extremality is 0. Fitted, it is an error; but the standard error that residuals
// imply says little of that: they are mostly truncation, which is no noise. What C changes by when the radius grows
// measures truncation. Measured with a factor of 1.4, |e| against the change, medians: tori 0.1 to 0.25, spheroids
// 0.04 to 0.1; a torus bent a little 1.4 to 6, ellipsoids 1 to 70; noise 0.7 to 2.
#include "change_with_radius.h"

#include "../differential/vector.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Complex = std::complex<double>;

/// tells whether an extremality is of the size that errors of the fit have, by the standard error and by the order of
/// truncation, k² (kR)² for a radius R.
bool may_be_degenerate(const Local_shape& s, const Fit_quality& quality) {
  constexpr double standard_errors = 3, bent = 0.5;
  if (quality.state != Fit_state::fitted)
    return false;
  const Principal_quantities q = principal_quantities(s);
  const double k = std::max(std::abs(q.k1), std::abs(q.k2)), kR = std::min(k * quality.radius, bent);
  const double e = std::min(std::abs(q.e1), std::abs(q.e2));
  return e <= standard_errors * quality.C_error && e <= k * k * kR * kR;
}

/// the root of the mean square of the differences of A1 and A3.
double difference_of_C(const Local_shape& a, const Local_shape& b) {
  const Vector u = transport(b.n, a.n, b.u);
  const Complex turn(dot(u, a.u), dot(u, a.v())); // e^{iα}, α from a's basis to b's
  return std::sqrt((std::norm(b.A1 * turn - a.A1) + std::norm(b.A3 * turn * turn * turn - a.A3)) / 2);
}

} // namespace

void find_change_with_radius(const Fit_input& input, Thread_pool& pool, Vertex_shapes& shapes) {
  constexpr double wider = 1.4;
  constexpr std::size_t block = 256;
  std::vector<std::uint32_t> candidates;
  for (std::uint32_t v = 0; v < shapes.shapes.size(); ++v)
    if (may_be_degenerate(shapes.shapes[v], shapes.quality[v]))
      candidates.push_back(v);
  if (candidates.empty())
    return;
  tbb::enumerable_thread_specific<Jet_fitter> fitters(
      [&] { return Jet_fitter(input.vertices, input.adjacency, input.rounding); });
  pool.for_each((candidates.size() + block - 1) / block, 1, [&](std::size_t b) {
    Jet_fitter& fitter = fitters.local();
    const std::span of_block = std::span(candidates).subspan(b * block, std::min(block, candidates.size() - b * block));
    Vertex_shapes wide;
    wide.shapes.resize(of_block.size());
    wide.fourth.resize(of_block.size());
    wide.quality.resize(of_block.size());
    for (std::uint32_t i = 0; i < of_block.size(); ++i)
      fitter.fit(of_block[i], {wider * shapes.quality[of_block[i]].radius, 0}, wide, i);
    fitter.finish(wide);
    for (std::uint32_t i = 0; i < of_block.size(); ++i) {
      const std::uint32_t v = of_block[i];
      if (wide.quality[i].state == Fit_state::fitted && dot(shapes.shapes[v].n, wide.shapes[i].n) > 0)
        shapes.quality[v].C_change = difference_of_C(shapes.shapes[v], wide.shapes[i]);
    }
  });
}

} // namespace CGAL::Extremal_mesh_3
