// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_TEST_EXTRACTED_FEMUR_H
#define EXTREMAL_MESH_3_TEST_EXTRACTED_FEMUR_H

#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

namespace CGAL::Extremal_mesh_3 {

/// the femur of `data/` with its cells as patches, made once.
inline const Extraction& femur() {
  static const Extraction result = [] {
    const Mesh mesh = read_mesh(EXTREMAL_MESH_3_DATA_DIR "/femur.off");
    Fit_options fit;
    fit.radius = 0.1;
    Extraction_options options;
    options.patches = true;
    return extract_extremal_mesh(mesh.cells, fit_vertex_shapes(mesh.cells, fit).shapes, options);
  }();
  return result;
}

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_TEST_EXTRACTED_FEMUR_H
