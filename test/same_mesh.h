// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_TEST_SAME_MESH_H
#define CGAL_EXTREMAL_MESH_3_TEST_SAME_MESH_H

#include <CGAL/Extremal_mesh_3/Extremal_mesh.h>

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <span>

/// Comparison to the last bit: -0 is not 0.
namespace same_mesh {

using namespace CGAL::Extremal_mesh_3;

inline void expect_same_bits(std::span<const double> a, std::span<const double> b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i]), std::bit_cast<std::uint64_t>(b[i]))
        << what << ": " << a[i] << " and " << b[i];
}

inline void expect_same(const Extremal_mesh_vertex& a, const Extremal_mesh_vertex& b, const std::string& what) {
  EXPECT_EQ(a.kind, b.kind) << what;
  expect_same_bits(a.point, b.point, what);
  expect_same_bits(a.normal, b.normal, what);
  expect_same_bits(std::array{a.k1, a.k2, a.umbilic_index}, std::array{b.k1, b.k2, b.umbilic_index}, what);
  expect_same_bits(a.t1, b.t1, what);
  expect_same_bits(a.t2, b.t2, what);
  EXPECT_EQ(a.field_index, b.field_index) << what;
  EXPECT_EQ(a.umbilic_type, b.umbilic_type) << what;
  EXPECT_EQ(a.ridges, b.ridges) << what;
  EXPECT_EQ(a.extrema, b.extrema) << what;
  EXPECT_EQ(a.star, b.star) << what;
  EXPECT_EQ(a.life_time, b.life_time) << what;
}

inline void expect_same(const Extremal_mesh_edge& a, const Extremal_mesh_edge& b, const std::string& what) {
  EXPECT_EQ(a.id, b.id) << what;
  EXPECT_EQ(a.source, b.source) << what;
  EXPECT_EQ(a.target, b.target) << what;
  EXPECT_EQ(a.family, b.family) << what;
  EXPECT_EQ(a.type, b.type) << what;
  ASSERT_EQ(a.polyline.size(), b.polyline.size()) << what;
  for (std::size_t i = 0; i < a.polyline.size(); ++i)
    expect_same_bits(a.polyline[i], b.polyline[i], what);
  ASSERT_EQ(a.normals.size(), b.normals.size()) << what;
  for (std::size_t i = 0; i < a.normals.size(); ++i)
    expect_same_bits(a.normals[i], b.normals[i], what);
  expect_same_bits(a.k1, b.k1, what);
  expect_same_bits(a.k2, b.k2, what);
  expect_same_bits(a.extremality, b.extremality, what);
  EXPECT_EQ(a.segment_types, b.segment_types) << what;
  EXPECT_EQ(a.type_changes, b.type_changes) << what;
  expect_same_bits(std::array{a.length, a.strength, a.sharpness}, std::array{b.length, b.strength, b.sharpness}, what);
  EXPECT_EQ(a.left_cell, b.left_cell) << what;
  EXPECT_EQ(a.right_cell, b.right_cell) << what;
  EXPECT_EQ(a.life_time, b.life_time) << what;
}

inline void expect_same(const Extremal_mesh_cell& a, const Extremal_mesh_cell& b, const std::string& what) {
  EXPECT_EQ(a.sign, b.sign) << what;
  expect_same_bits(std::array{a.area, a.weight}, std::array{b.area, b.weight}, what);
  EXPECT_EQ(a.euler_characteristic, b.euler_characteristic) << what;
  EXPECT_EQ(a.touches_border, b.touches_border) << what;
  EXPECT_EQ(a.boundary, b.boundary) << what;
}

inline void expect_same(const Extremal_mesh& a, const Extremal_mesh& b) {
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  for (std::size_t v = 0; v < a.number_of_vertices(); ++v)
    expect_same(a.vertex(v), b.vertex(v), "vertex " + std::to_string(v));
  ASSERT_EQ(a.number_of_edges(), b.number_of_edges());
  for (std::size_t e = 0; e < a.number_of_edges(); ++e)
    expect_same(a.edge(e), b.edge(e), "edge " + std::to_string(e));
  ASSERT_EQ(a.number_of_cells(), b.number_of_cells());
  for (std::size_t c = 0; c < a.number_of_cells(); ++c)
    expect_same(a.cell(c), b.cell(c), "cell " + std::to_string(c));
  const Surface_info &s = a.surface(), &t = b.surface();
  EXPECT_EQ(s.euler_characteristic, t.euler_characteristic);
  EXPECT_EQ(s.closed, t.closed);
  EXPECT_EQ(s.components, t.components);
  expect_same_bits(std::array{s.area, s.degenerate_area}, std::array{t.area, t.degenerate_area}, "surface");
  EXPECT_EQ(s.source, t.source);
  EXPECT_EQ(s.parameters, t.parameters);
  EXPECT_EQ(s.frame, t.frame);
}

} // namespace same_mesh

#endif // CGAL_EXTREMAL_MESH_3_TEST_SAME_MESH_H
