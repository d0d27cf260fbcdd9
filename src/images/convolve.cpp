// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each pass copies a strip of lines into a small buffer with its border values repeated, and writes the filtered strip
// back over the original. All three passes filter several neighbouring results at once, in the lanes of a vector; the
// sum of each result is always taken in the same order, so that neither threads nor the vector unit can change a bit.

#include "../cells/parallel.h"
#include "lanes.h"
#include "smoothing.h"

#include <CGAL/Extremal_mesh_3/errors.h>

#include <algorithm>
#include <cstring>
#include <mutex>

namespace CGAL::Extremal_mesh_3 {
namespace {

constexpr std::size_t lanes = 16;       // of a vector of floats
constexpr std::size_t strip_width = 64; // a few cache lines, so that a strip of 256 lines stays in the first caches

std::size_t rounded_up_to_lanes(std::size_t n) {
  return (n + lanes - 1) / lanes * lanes;
}

// out[x] = Σ_j k[j] (in[x − j·stride] + in[x + j·stride]), for x up to n rounded up to lanes; from the small weights
// outside to the large ones inside, for the least rounding.
[[gnu::always_inline]] inline void filter(const float* in, std::size_t stride, const Half_kernel& k, float* out,
                                          std::size_t n) {
  const auto add = [](const float* p, Sixteen_floats& sum) __attribute__((always_inline)) {
    Sixteen_floats v;
    std::memcpy(&v, p, sizeof v);
    sum += v;
  };
  for (std::size_t x = 0; x < n; x += lanes) {
    Sixteen_floats sum{};
    for (std::size_t j = k.size() - 1; j > 0; --j) {
      Sixteen_floats both{};
      add(in + x - j * stride, both);
      add(in + x + j * stride, both);
      sum += k[j] * both;
    }
    Sixteen_floats middle{};
    add(in + x, middle);
    sum += k[0] * middle;
    std::memcpy(out + x, &sum, sizeof sum);
  }
}

// Filters one line whose values are next to each other.
void filter_row(float* row, std::size_t n, const Half_kernel& k, std::vector<float>& buffer) {
  const std::size_t radius = k.size() - 1;
  const std::size_t padded = rounded_up_to_lanes(n);
  buffer.resize(2 * padded + 2 * radius);
  float* const in = buffer.data();
  std::fill_n(in, radius, row[0]);
  std::copy_n(row, n, in + radius);
  std::fill_n(in + radius + n, radius + padded - n, row[n - 1]);
  float* const out = in + 2 * radius + padded;
  internal::on_widest_vectors([&]() __attribute__((always_inline)) { filter(in + radius, 1, k, out, n); });
  std::copy_n(out, n, row);
}

// Filters `width` lines side by side, each of `n` values that are `stride` apart.
void filter_strip(float* first, std::size_t stride, std::size_t n, std::size_t width, const Half_kernel& k,
                  std::vector<float>& buffer) {
  const std::size_t radius = k.size() - 1;
  const std::size_t padded = rounded_up_to_lanes(width);
  buffer.resize((n + 2 * radius + 1) * padded);
  float* line = buffer.data();
  for (std::size_t i = 0; i < n + 2 * radius; ++i, line += padded)
    std::copy_n(first + stride * (std::clamp(i, radius, radius + n - 1) - radius), width, line);
  internal::on_widest_vectors([&]() __attribute__((always_inline)) {
    for (std::size_t i = 0; i < n; ++i) {
      filter(buffer.data() + (i + radius) * padded, padded, k, line, width);
      std::memcpy(first + i * stride, line, width * sizeof(float));
    }
  });
}

// Turns finished pieces of work into calls of the user's function, one at a time.
class Reporter {
public:
  Reporter(const Progress& progress, std::size_t pieces) : progress_(progress), pieces_(pieces) {}

  void finished(std::size_t pieces) {
    if (!progress_)
      return;
    const std::scoped_lock lock(mutex_);
    done_ += pieces;
    if (cancelled_ || !progress_(static_cast<double>(done_) / static_cast<double>(pieces_))) {
      cancelled_ = true;
      throw Cancelled();
    }
  }

private:
  const Progress& progress_;
  std::size_t pieces_, done_ = 0;
  bool cancelled_ = false;
  std::mutex mutex_;
};

} // namespace

void convolve(std::span<float> voxels, const std::array<std::size_t, 3>& size,
              const std::array<Half_kernel, 3>& kernels, int threads, const Progress& progress) {
  const auto [nx, ny, nz] = size;
  const std::size_t slice_size = nx * ny;
  const std::size_t strips = (slice_size + strip_width - 1) / strip_width;
  Reporter reporter(progress, nz + strips);

  Thread_pool pool(threads);
  pool.for_ranges(nz, 1, [&, nx = nx, ny = ny](std::size_t begin, std::size_t end) {
    std::vector<float> buffer;
    for (std::size_t k = begin; k < end; ++k) {
      float* const slice = voxels.data() + k * slice_size;
      for (std::size_t j = 0; j < ny; ++j)
        filter_row(slice + j * nx, nx, kernels[0], buffer);
      for (std::size_t x = 0; x < nx; x += strip_width)
        filter_strip(slice + x, nx, ny, std::min(strip_width, nx - x), kernels[1], buffer);
    }
    reporter.finished(end - begin);
  });
  pool.for_ranges(strips, 8, [&, nz = nz](std::size_t begin, std::size_t end) {
    std::vector<float> buffer;
    for (std::size_t s = begin; s < end; ++s) {
      const std::size_t first = s * strip_width;
      filter_strip(voxels.data() + first, slice_size, nz, std::min(strip_width, slice_size - first), kernels[2],
                   buffer);
    }
    reporter.finished(end - begin);
  });
}

} // namespace CGAL::Extremal_mesh_3
