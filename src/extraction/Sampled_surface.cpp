// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/internal/Sampled_surface.h>
#include <CGAL/Extremal_mesh_3/project_onto.h>

#include "../differential/vector.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace CGAL::Extremal_mesh_3::internal {

namespace {

void make_unit(std::vector<Vector>& normals) {
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double length = norm(normals[i]);
    if (!std::isfinite(length) || length == 0)
      throw std::invalid_argument(fmt::format("the normal ({}, {}, {}) of point {} is not a direction", normals[i][0],
                                              normals[i][1], normals[i][2], i));
    normals[i] = (1 / length) * normals[i];
  }
}

} // namespace

Extraction extract_extremal_mesh(Sampled_surface s) {
  if (s.function && !s.given.shapes.empty())
    throw std::invalid_argument("both a function and the shapes at the vertices are given");
  if (s.given.shapes.empty() && !s.given.fourth.empty())
    throw std::invalid_argument("fourth-order forms are given without the shapes at the vertices");
  if (s.fit)
    *s.fit = {};
  if (s.function)
    return Extremal_mesh_3::extract_extremal_mesh(
        *s.function, project_onto(*s.function, std::move(s.cells), s.extraction_options.threads), s.extraction_options);
  Fit fit;
  if (!s.given.shapes.empty()) {
    fit.shapes = std::move(s.given);
  } else {
    make_unit(s.fit_options.normals);
    if (!s.fit_options.progress)
      s.fit_options.progress = s.extraction_options.progress;
    fit = fit_vertex_shapes(s.cells, s.fit_options);
  }
  // Before the extraction: where that fails, the fit tells why.
  const Fit& used = s.fit ? * s.fit = std::move(fit) : fit;
  return Extremal_mesh_3::extract_extremal_mesh(s.cells, used.shapes, s.extraction_options);
}

} // namespace CGAL::Extremal_mesh_3::internal
