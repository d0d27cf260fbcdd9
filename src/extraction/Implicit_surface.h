// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_EXTRACTION_IMPLICIT_SURFACE_H
#define EXTREMAL_MESH_3_SRC_EXTRACTION_IMPLICIT_SURFACE_H

#include "Sample.h"

#include <CGAL/Extremal_mesh_3/Function_3.h>

namespace CGAL::Extremal_mesh_3 {

/// The zero set of a function.
class Implicit_surface : public Surface {
public:
  explicit Implicit_surface(const Function_3& f) : f_(f) {}

  std::optional<Sample> sample(const Point& x, const Vector& direction, double reach, double accuracy,
                               Detail detail) const override;
  void add_fourth(Sample& s) const override;
  double extremality_derivative(const Sample& s, int family, double step) const override;

  /// the sample at a point that lies on the surface already.
  Sample sample_at(const Point& p) const;

private:
  int order(Detail detail) const { return detail == Detail::fourth_order && f_.max_order() >= 4 ? 4 : 3; }

  const Function_3& f_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_EXTRACTION_IMPLICIT_SURFACE_H
