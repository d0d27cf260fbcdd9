// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "halve_spacing.h"

#include "../cells/parallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// the coefficients of the cubic spline through values, in place: the inverse of (1, 4, 1)/6, which has the pole √3 − 2.
void prefilter(std::vector<double>& c) {
  const double z = std::sqrt(3.0) - 2;
  c.front() /= 1 - z; // before the first, and after the last, all are the same
  for (std::size_t i = 1; i < c.size(); ++i)
    c[i] += z * c[i - 1];
  c.back() /= 1 - z;
  for (std::size_t i = c.size() - 1; i-- > 0;)
    c[i] += z * c[i + 1];
  for (double& x : c)
    x *= (1 - z) * (1 - z);
}

} // namespace

void halve_spacing(Image& image, std::size_t axis, int threads) {
  const auto old_size = image.lattice.size;
  auto size = old_size;
  const std::size_t n = old_size[axis];
  size[axis] = 2 * n - 1;
  for (double& x : image.lattice.step[axis])
    x /= 2;
  image.lattice.size = size;
  Voxels voxels(size[0] * size[1] * size[2], image.voxels.get_allocator());
  const auto stride_in = [&](const auto& s) { return axis == 0 ? 1 : axis == 1 ? s[0] : s[0] * s[1]; };
  const std::size_t in_stride = stride_in(old_size), out_stride = stride_in(size);
  const std::size_t lines = image.voxels.size() / n;
  constexpr std::size_t margin = 24; // (2 − √3)^24 < 2e-14
  Thread_pool(threads).for_ranges(lines, 256, [&](std::size_t begin, std::size_t end) {
    std::vector<double> c(n + 2 * margin);
    for (std::size_t line = begin; line < end; ++line) {
      // Lines are numbered along the axes before this one, then along those after it.
      const std::size_t within = line % in_stride, block = line / in_stride;
      const float* const in = image.voxels.data() + block * in_stride * n + within;
      float* const out = voxels.data() + block * out_stride * size[axis] + within;
      for (std::size_t i = 0; i < c.size(); ++i)
        c[i] = in[(std::clamp(i, margin, margin + n - 1) - margin) * in_stride];
      prefilter(c);
      for (std::size_t i = 0; i < n; ++i) {
        out[2 * i * out_stride] = in[i * in_stride];
        const double* const k = c.data() + margin + i;
        if (i + 1 < n)
          out[(2 * i + 1) * out_stride] = float((k[-1] + 23 * k[0] + 23 * k[1] + k[2]) / 48);
      }
    }
  });
  image.voxels = std::move(voxels);
}

} // namespace CGAL::Extremal_mesh_3
