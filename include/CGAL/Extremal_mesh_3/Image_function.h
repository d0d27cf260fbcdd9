// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IMAGE_FUNCTION_H
#define CGAL_EXTREMAL_MESH_3_IMAGE_FUNCTION_H

#include <CGAL/Extremal_mesh_3/Function_3.h>
#include <CGAL/Extremal_mesh_3/Image.h>

#include <memory>

namespace CGAL::Extremal_mesh_3 {

struct Image_function_options {
  double iso = 0;   ///< the surface is where the smoothed image has this value
  double sigma = 0; ///< width of the Gaussian in mm; 0: the size of the largest side of a voxel
  int threads = 0;  ///< 0: as many as there are cores
  Progress progress;
};

/// A smoothed 3D image as a C⁴ function of R³ whose derivatives up to order 4 are exact:
/// `f(x) = iso − Σ c_i β⁵(x − i)`, c being the image convolved with a Gaussian of variance σ² − ½ (in voxels; the
/// quintic B-spline adds the ½). Negative inside bright regions, so normals point out of them.
/// Outside the lattice the image is continued by its border values.
class Image_function : public Function_3 {
public:
  /// \throws std::invalid_argument if sigma is negative or not finite, or below 0.9 voxels on an axis (the spline alone
  ///         smooths by √½; the message names the smallest σ that works)
  /// \throws Extraction_error if iso is outside the range of the image's values
  Image_function(const Image& image, const Image_function_options& options);
  ~Image_function() override;
  Image_function(Image_function&&) noexcept;

  double value(const Point& p) const override;
  void derivatives(const Point& p, int order, Derivatives& d) const override;
  void lattice_values(const Lattice& lattice, std::size_t k, double* out) const override;

  /// the image's own lattice, the natural one for `make_implicit_cells()`.
  const Lattice& lattice() const;
  double sigma() const; ///< the σ used, in mm

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IMAGE_FUNCTION_H
