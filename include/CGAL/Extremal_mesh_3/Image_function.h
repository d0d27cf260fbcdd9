// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_IMAGE_FUNCTION_H
#define CGAL_EXTREMAL_MESH_3_IMAGE_FUNCTION_H

#include <CGAL/Extremal_mesh_3/Function_3.h>
#include <CGAL/Extremal_mesh_3/Image.h>

#include <memory>

namespace CGAL::Extremal_mesh_3 {

/// How an image becomes a function.
struct Image_function_options {
  double iso = 0;   ///< the surface is where the smoothed image has this value
  double sigma = 0; ///< width of the Gaussian in mm; 0: the size of the largest side of a voxel
  /// of the spline: 5, or 7, whose derivatives are closer to the Gaussian's but cost twice as much.
  /// 0: 7 if sigma is below 1.2 voxels on an axis, 5 otherwise
  int degree = 0;
  int threads = 0;   ///< 0: as many as there are cores
  Progress progress; ///< told how far the work is; may stop it
};

/// A smoothed 3D image as a smooth function of R³ whose derivatives up to order 4 are exact:
/// `f(x) = iso − Σ c_i β(x − i)`, a tensor-product B-spline of degree 5 (C⁴) or 7 (C⁶) that at the lattice's nodes
/// equals the image convolved with the Gaussian of width σ. Negative inside bright regions, so normals point out of
/// them.
///
/// Between the nodes f follows the image convolved with the continuous Gaussian; its third derivatives differ from that
/// one's by (degree 5; 7) 10 %; 6 % for edges at σ = 1 voxel, 2 %; 0.3 % at 1.5, and 0.6 %; 0.04 % at 2.
/// On an axis with σ below 0.9 voxels, where the lattice is too coarse for derivatives of such a Gaussian, the image is
/// first given nodes half way between the voxels, by the cubic spline through them.
/// The image is continued by its border values, and so is the spline by its coefficients: closer than about 3 voxels
/// to the border f is a blend of both. σ is the same in mm along the three axes of the lattice; it is isotropic if they
/// are perpendicular, as they are in medical images. Values are stored as float, which limits them to about 7 digits.
class Image_function : public Function_3 {
public:
  /// \throws std::invalid_argument if an option or the image is not as it should be: sizes that do not agree, a voxel
  /// or a step that is not
  ///         finite, dependent steps; σ below 0.45 voxels on an axis (the surface would show the interpolation, not the
  ///         image; the message names the smallest σ that works), larger than the image or than 10000 voxels on an axis
  /// \throws Extraction_error if iso is outside the range of the image's values
  /// \throws Cancelled when progress asks for it
  /// \param image  the voxels
  /// \param options  the value on the surface, and how to smooth
  Image_function(const Image& image, const Image_function_options& options);
  /// smooths the voxels of `image` in place: no second volume is needed, unless σ asks for nodes between the voxels.
  /// \param image  the voxels; empty afterwards
  /// \param options  the value on the surface, and how to smooth
  Image_function(Image&& image, const Image_function_options& options);
  ~Image_function() override;
  Image_function(Image_function&&) noexcept; ///< takes over what another one holds

  /// \copydoc Function_3::value()
  double value(const Point& p) const override;
  void derivatives(const Point& p, int order, Derivatives& d) const override;
  using Function_3::lattice_values;
  /// \copydoc Function_3::lattice_values(const Lattice&,std::size_t,double*)const
  /// On `lattice()` this takes a few ns per node.
  void lattice_values(const Lattice& lattice, std::size_t k, double* out) const override;

  /// \copydoc Function_3::half_step_values()
  /// On `lattice()` this takes little time, and so does `root_on_edge()`.
  bool half_step_values(const Lattice& lattice, const std::array<std::size_t, 3>& cube,
                        std::array<double, 27>& out) const override;
  std::optional<double> root_on_edge(const Lattice& lattice, const std::array<std::size_t, 3>& node, std::size_t axis,
                                     double v0, double v1) const override;

  /// \copydoc Function_3::bounds_cost()
  Bounds_cost bounds_cost() const override { return Bounds_cost::high; }
  /// bounds of the spline's value and gradient; derivatives above are not known. Tight within a cell of the lattice, for
  /// thousands of products; loose over many cells. On a lattice with skew or turned axes the box's own box on the lattice is taken.
  /// \copydetails Function_3::bounds()
  bool bounds(const Box_3& box, int order, Derivative_bounds& d) const override;

  /// the image's own lattice, the natural one for `make_implicit_cells()`; on an axis with σ below 0.9 voxels with
  /// nodes half way between the voxels, too.
  /// \return the lattice, in mm
  const Lattice& lattice() const;
  /// \return the σ used, in mm
  double sigma() const;
  /// \return the degree of the spline used
  int degree() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_IMAGE_FUNCTION_H
