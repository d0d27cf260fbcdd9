// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface as extraction sees it: samples, and where more of them come from.
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_SAMPLE_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_SAMPLE_H

#include "../differential/umbilic_lines.h"

#include <CGAL/Extremal_mesh_3/Differential_quantities.h>

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Extremal_mesh_3 {

using Complex = std::complex<double>;

/// A point of the surface with what decides the extremal mesh there.
struct Sample {
  Point p{};
  Local_shape shape;
  Fourth_order_form fourth; ///< on surfaces that interpolate, and where `has_fourth`
  Complex P;
  double phase = 0; ///< arg Φ in [0, π) where E_g ≥ 0, else in [−π, 0); lines lie where it is a multiple of π
  bool positive = true;    ///< E_g ≥ 0; sign(0) is +
  bool exact = true;       ///< on the surface itself, not interpolated between samples
  bool has_fourth = false; ///< `fourth` says how C changes on the surface

  Sample() = default;
  Sample(const Point& point, const Local_shape& local_shape, bool is_exact);
};

/// The derivatives of the local shape along the surface: a tangent that is the complex number z in the basis of the
/// shape changes Q by Q.z z + Q.z_bar z̄, and likewise A1 and A3.
struct Shape_derivatives {
  struct Pair {
    Complex z, z_bar;
  };
  Pair Q, A1, A3;
};
Shape_derivatives shape_derivatives(const Local_shape& s, const Fourth_order_form& D);

/// What of a sample is wanted: derivatives of order 4 take longer.
enum class Detail : std::uint8_t { third_order, fourth_order };

/// A surface that can be asked for samples anywhere.
class Surface {
public:
  virtual ~Surface() = default;
  /// the sample at the point of the line x + s·direction, |s| ≤ reach, where it meets the surface; nothing if none is
  /// found.
  /// \param accuracy  how far from that point, in parts of `reach`, the derivatives may be taken
  /// \param detail  whether the sample gets its fourth-order form, if the surface has one
  virtual std::optional<Sample> sample(const Point& x, const Vector& direction, double reach, double accuracy = to_look,
                                       Detail detail = Detail::fourth_order) const = 0;
  static constexpr double to_look = 1e-6;   ///< enough to judge what is there
  static constexpr double to_place = 1e-12; ///< for what goes into the result
  /// ∇e_i·t_i, for the family i.
  /// \param step  a length that is small here, for surfaces that must take differences
  virtual double extremality_derivative(const Sample& s, int family, double step) const = 0;
  /// gives a sample its fourth-order form, where the surface has derivatives for it.
  virtual void add_fourth(Sample&) const {}
  /// there are no samples but those given at vertices: what is interpolated between them *is* the surface.
  virtual bool interpolates() const { return false; }

protected:
  Surface() = default;
  Surface(const Surface&) = default;
  Surface& operator=(const Surface&) = default;
};

/// The derivatives of P and Q along u and v at a sample that has its fourth-order form.
struct Field_gradients {
  Linear_field P, Q;
};
Field_gradients field_gradients(const Sample& s);

/// The gradient of the phase of Φ = P² Q at such a sample, along u and v; not finite where P or Q is 0.
struct Phase_gradient {
  double x = 0, y = 0;
};
Phase_gradient phase_gradient(const Sample& s);

/// e^{iα}, α being the angle from b's basis to a's after parallel transport from a to b along the shortest way between
/// their normals. A quantity of spin s at a has the components X e^{isα} in b's basis (P: −1, Q: 2, A1: 1, A3: 3).
Complex frame_turn(const Sample& a, const Sample& b);

/// P and Q of a in the basis of b.
struct Moved_fields {
  Complex P, Q;
};
Moved_fields moved_to(const Sample& a, const Sample& b);

/// the weighted mean of samples: L, C and the fourth-order form are interpolated in a common frame. On a surface that
/// interpolates, L and C are quadratic in between: they follow their derivatives.
Sample interpolate(const Surface& surface, const std::vector<const Sample*>& samples,
                   const std::vector<double>& weights);

/// the point of the surface above the chord from a to b at parameter t; interpolated where the surface cannot be
/// reached. Exchanging the ends and taking 1 − t gives the same point, to the last bit for t = ½.
Sample sample_between(const Surface& surface, const Sample& a, const Sample& b, double t,
                      double accuracy = Surface::to_look, Detail detail = Detail::fourth_order);

/// the same above the centroid of several samples.
Sample sample_amid(const Surface& surface, const std::vector<const Sample*>& corners);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_SAMPLE_H
