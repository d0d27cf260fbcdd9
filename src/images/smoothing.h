// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SMOOTHING_H
#define CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SMOOTHING_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

/// One half of a symmetric kernel: `k[0]` is its centre, `k[j]` the weight of both neighbours at distance j.
using Half_kernel = std::vector<float>;

/// makes the kernel whose convolution with samples gives the coefficients of a B-spline of `degree` 5 or 7 which at the
/// nodes equals the samples convolved with a Gaussian: the sampled Gaussian, divided by the B-spline's samples.
/// \param sigma  width of the Gaussian, in samples
/// \return weights of sum 1; what is cut off at both ends has absolute sum below 1e-7, about float's rounding
Half_kernel gaussian_spline_kernel(double sigma, int degree);

/// convolves a volume with one kernel per axis, in place. Values beyond the border are those at the border.
/// The result has the same bits for any number of threads.
/// \param voxels  `size[0]·size[1]·size[2]` values, the first axis fastest
/// \param threads  0: as many as there are cores
/// \throws Cancelled when progress asks for it; `voxels` is then useless
void convolve(std::span<float> voxels, const std::array<std::size_t, 3>& size,
              const std::array<Half_kernel, 3>& kernels, int threads, const Progress& progress);

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_SRC_IMAGES_SMOOTHING_H
