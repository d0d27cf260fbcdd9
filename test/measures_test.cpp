// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of parts of an extremal mesh: by hand, and on surfaces that were moved and scaled before anything was computed.
#include <CGAL/Extremal_mesh_3/cell_queries.h>
#include <CGAL/Extremal_mesh_3/measures.h>
#include <CGAL/Extremal_mesh_3/select.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include "changed_mesh.h"
#include "hand_made.h"
#include "random_surfaces.h"

using namespace CGAL::Extremal_mesh_3;

namespace {

const std::vector<Line_measure> all_measures = {
    Line_measure::length,         Line_measure::strength,          Line_measure::sharpness,
    Line_measure::mean_curvature, Line_measure::extreme_curvature, Line_measure::stability};

/// the power of the length in the unit of a measure.
int dimension(Line_measure measure) {
  switch (measure) {
  case Line_measure::length:
    return 1;
  case Line_measure::mean_curvature:
  case Line_measure::extreme_curvature:
    return -1;
  default:
    return 0;
  }
}

/// measures of some kind, sorted: surfaces that were moved can have their edges in another order.
using Sorted = std::vector<double>;

void expect_scaled(Sorted a, Sorted b, double factor, double tolerance, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  double size = 0;
  for (double& x : a) {
    x *= factor;
    size = std::max(size, std::abs(x));
  }
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], tolerance * size) << what;
}

template <typename Value> Sorted for_each(std::size_t number, const Value& value) {
  Sorted values;
  for (std::uint32_t i = 0; i < number; ++i)
    values.push_back(value(i));
  return values;
}

/// whether a line reaches an umbilic. |∇e·t| grows there like one over the distance, so that its integral has no limit: the
/// sharpness depends on how near the polyline's points come.
bool reaches_umbilic(const Extremal_mesh& mesh, const Extremal_line& line) {
  return std::any_of(line.half_edges.begin(), line.half_edges.end(), [&](Half_edge h) {
    return mesh.vertex(mesh.source(h)).kind == Vertex_kind::umbilic ||
           mesh.vertex(mesh.target(h)).kind == Vertex_kind::umbilic;
  });
}

/// expects that the measures of `b` are those of `a` on a surface `scale` times as large.
/// \param same_points  the polylines have the same points, so that all measures can be compared
void expect_scaled_measures(const Extremal_mesh& a, const Extremal_mesh& b, double scale, double tolerance,
                            bool same_points) {
  for (const Line_measure m : all_measures) {
    const double factor = std::pow(scale, dimension(m));
    const std::string name(to_string(m));
    const auto values = [&](const Extremal_mesh& mesh, const std::vector<Extremal_line>& lines) {
      Sorted all;
      for (const Extremal_line& line : lines)
        if (m != Line_measure::sharpness || same_points || !reaches_umbilic(mesh, line))
          all.push_back(value_of(line_measures(mesh, line), m));
      return all;
    };
    const auto edges = [](const Extremal_mesh& mesh) {
      std::vector<Extremal_line> lines;
      for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
        lines.push_back({{2 * e}, false});
      return lines;
    };
    expect_scaled(values(a, edges(a)), values(b, edges(b)), factor, tolerance, "edges: " + name);
    expect_scaled(values(a, all_lines(a)), values(b, all_lines(b)), factor, tolerance, "lines: " + name);
  }
  const auto of_cells = [&](double Cell_measures::*member, double factor, const std::string& name) {
    const auto values = [&](const Extremal_mesh& mesh) {
      return for_each(mesh.number_of_cells(), [&](std::uint32_t c) { return cell_measures(mesh, c).*member; });
    };
    expect_scaled(values(a), values(b), factor, tolerance, name);
  };
  of_cells(&Cell_measures::area, scale * scale, "area");
  of_cells(&Cell_measures::weight, 1, "weight");
  of_cells(&Cell_measures::mean_extremality, 1 / (scale * scale), "mean_extremality");
  of_cells(&Cell_measures::perimeter, scale, "perimeter");
  const auto compactness = [](const Extremal_mesh& mesh) {
    return for_each(mesh.number_of_cells(), [&](auto c) { return cell_measures(mesh, c).compactness.value_or(-1); });
  };
  expect_scaled(compactness(a), compactness(b), 1, tolerance, "compactness");
  const auto of_vertices = [&](double Vertex_measures::*member, const std::string& name) {
    const auto values = [&](const Extremal_mesh& mesh) {
      return for_each(mesh.number_of_vertices(), [&](std::uint32_t v) { return vertex_measures(mesh, v).*member; });
    };
    expect_scaled(values(a), values(b), 1, tolerance, name);
  };
  of_vertices(&Vertex_measures::strength, "strength of vertices");
  of_vertices(&Vertex_measures::stability, "stability of vertices");
  const auto extrema = [](const Extremal_mesh& mesh) {
    return for_each(mesh.number_of_vertices(), [&](std::uint32_t v) {
      const auto found = vertex_measures(mesh, v).extrema;
      return found ? double(*found) : -1.0;
    });
  };
  expect_scaled(extrema(a), extrema(b), 1, 0, "extrema");
}

/// an extremal mesh as it is on the moved surface.
Extremal_mesh moved(const Extremal_mesh& mesh, const surfaces::Motion& motion) {
  return changed(mesh, [&](Mesh_parts& p) {
    const double s = motion.scale;
    for (Extremal_mesh_vertex& v : p.vertices) {
      v.point = motion(v.point);
      for (Vector* d : {&v.normal, &v.t1, &v.t2})
        *d = motion.turned(*d);
      v.k1 /= s;
      v.k2 /= s;
    }
    for (Extremal_mesh_edge& e : p.edges) {
      for (std::size_t i = 0; i < e.polyline.size(); ++i) {
        e.polyline[i] = motion(e.polyline[i]);
        e.normals[i] = motion.turned(e.normals[i]);
        e.k1[i] /= s;
        e.k2[i] /= s;
        e.extremality[i] /= s * s;
      }
      e.length *= s;
    }
    for (Extremal_mesh_cell& c : p.cells)
      c.area *= s * s;
    p.surface.area *= s * s;
  });
}

} // namespace

TEST(Edge_measures, are_those_of_the_edge_and_integrals_over_it) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  const Extremal_mesh_edge& edge = mesh.edge(4); // family 2: k2 = −0.5 − 0.03 i, |e1| = 0.1 i (12 − i)
  const Line_measures m = edge_measures(mesh, 4);
  EXPECT_EQ(m.length, edge.length);
  EXPECT_EQ(m.strength, edge.strength);
  EXPECT_EQ(m.sharpness, edge.sharpness);
  EXPECT_NEAR(m.mean_curvature, -0.5 - 0.03 * 6, 1e-12); // in the middle, as the segments have the same length
  EXPECT_EQ(m.extreme_curvature, edge.k2.back());
  // Σ i (12 − i) for i from 1 to 11 = 12·66 − 506 = 286, on segments of a twelfth of the length, of a sphere with the area 4π.
  EXPECT_NEAR(m.stability, std::sqrt(4 * std::numbers::pi) * 0.1 * 286 * edge.length / 12, 1e-12);
  EXPECT_NEAR(edge_measures(mesh, 0).mean_curvature, -0.1 - 0.01 * 6, 1e-12); // family 1: k1
}

TEST(Line_measures, add_up_those_of_the_edges) {
  for (const Extremal_mesh& mesh :
       {hand_made::ellipsoid(), hand_made::two_loops(), hand_made::meridians(), hand_made::hemisphere()})
    for (const Extremal_line& line : all_lines(mesh)) {
      Line_measures expected;
      expected.stability = 1e300;
      for (const Half_edge h : line.half_edges) {
        const Line_measures m = edge_measures(mesh, h / 2);
        expected.mean_curvature += m.mean_curvature * m.length;
        expected.length += m.length;
        expected.strength += m.strength;
        expected.sharpness += m.sharpness;
        expected.extreme_curvature = std::min(expected.extreme_curvature, m.extreme_curvature); // all are negative
        expected.stability = std::min(expected.stability, m.stability);
      }
      const Line_measures m = line_measures(mesh, line);
      EXPECT_NEAR(m.mean_curvature, expected.mean_curvature / expected.length, 1e-12);
      EXPECT_NEAR(m.length, expected.length, 1e-12);
      EXPECT_NEAR(m.strength, expected.strength, 1e-12);
      EXPECT_NEAR(m.sharpness, expected.sharpness, 1e-12);
      EXPECT_EQ(m.extreme_curvature, expected.extreme_curvature);
      EXPECT_EQ(m.stability, expected.stability);
    }
}

TEST(Cell_measures, of_an_octant_of_the_sphere) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  for (std::uint32_t c = 0; c < 8; ++c) {
    const Cell_measures m = cell_measures(mesh, c);
    EXPECT_EQ(m.sides, 4U);
    EXPECT_NEAR(m.perimeter, 3 * std::numbers::pi / 2,
                0.01); // three quarters of great circles, less what chords are shorter
    ASSERT_TRUE(m.compactness);
    EXPECT_NEAR(*m.compactness, 4 * std::numbers::pi * m.area / (m.perimeter * m.perimeter), 1e-15);
    EXPECT_NEAR(m.mean_extremality, 0.1 * c / (std::numbers::pi / 2), 1e-15);
  }
}

TEST(Cell_measures, know_no_compactness_without_a_whole_perimeter) {
  EXPECT_FALSE(cell_measures(hand_made::hemisphere(), 0).compactness);
  const Cell_measures closed = cell_measures(Extremal_mesh({}, {}, std::vector<Extremal_mesh_cell>(1), {}), 0);
  EXPECT_FALSE(closed.compactness);
  EXPECT_EQ(closed.sides, 0U);
  EXPECT_EQ(closed.mean_extremality, 0);
}

TEST(Vertex_measures, tell_which_extrema_meet) {
  const Extremal_mesh mesh = changed(hand_made::ellipsoid(), [](Mesh_parts& p) {
    p.vertices[0].extrema = {Line_type::max_second, Line_type::max_largest};
    p.vertices[1].extrema = {Line_type::min_largest, Line_type::max_second};
    p.vertices[2].extrema = {Line_type::min_largest, Line_type::min_second};
  });
  EXPECT_EQ(vertex_measures(mesh, 0).extrema, Extrema::max_max);
  EXPECT_EQ(vertex_measures(mesh, 1).extrema, Extrema::min_max);
  EXPECT_EQ(vertex_measures(mesh, 2).extrema, Extrema::min_min);
  EXPECT_EQ(vertex_measures(mesh, 3).extrema, Extrema::max_min);
  EXPECT_FALSE(vertex_measures(mesh, 6).extrema); // an umbilic
  EXPECT_EQ(to_string(Extrema::max_min), "max/min");
}

TEST(Vertex_measures, take_the_weaker_of_the_lines_that_cross) {
  const Extremal_mesh mesh = changed(hand_made::ellipsoid(), [](Mesh_parts& p) {
    for (std::size_t e = 0; e < p.edges.size(); ++e)
      p.edges[e].strength = double(1 << e);
  });
  // Vertex 2: edges 0 and 1 of family 1, 4 and 7 of family 2. Vertex 6: edges 8 and 15 of the line through the umbilic.
  EXPECT_EQ(vertex_measures(mesh, 2).strength, 1 + 2);
  EXPECT_EQ(vertex_measures(mesh, 6).strength, 256 + 32768);
  EXPECT_EQ(vertex_measures(hand_made::two_loops(), 0).strength, hand_made::two_loops().edge(0).strength);
  EXPECT_EQ(vertex_measures(hand_made::hemisphere(), 0).strength, hand_made::hemisphere().edge(0).strength);
}

// The first step of a simplification is at the edge where two extremal points, or umbilics, cancel each other first.
TEST(Stability, of_an_edge_is_the_persistence_of_cancelling_its_ends) {
  std::size_t compared = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto f = random_surfaces::ellipsoid(seed);
    const surfaces::Box box = random_surfaces::box_of(f);
    const Extremal_mesh mesh = extract_extremal_mesh(f, make_lattice(box.low, box.high, 24)).mesh;
    const Simplification simplification(mesh);
    ASSERT_FALSE(simplification.steps().empty());
    const Simplification_step& first = simplification.steps().front();
    if (first.operation != Simplification_operation::cancel_extremal_points)
      continue;
    ++compared;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
      nearest = std::min(nearest, std::abs(edge_measures(mesh, e).stability - first.persistence));
    EXPECT_LT(nearest, 1e-9 * first.persistence) << "seed " << seed;
  }
  EXPECT_GT(compared, 3U);
}

TEST(Measures, of_a_mesh_that_was_moved_and_scaled_are_scaled) {
  surfaces::Motion motion = surfaces::random_motion(5, 10);
  motion.scale = 3.5;
  for (const Extremal_mesh& mesh :
       {hand_made::ellipsoid(), hand_made::two_loops(), hand_made::meridians(), hand_made::hemisphere()})
    expect_scaled_measures(mesh, moved(mesh, motion), motion.scale, 1e-12, true);
}

// The moved surface meets other cubes, so its polylines have other points: measures agree as well as they approximate.
TEST(Measures, of_surfaces_do_not_depend_on_where_they_are_and_scale_with_them) {
  for (const unsigned seed : {1U, 2U, 8U}) {
    const auto f = random_surfaces::ellipsoid(seed);
    surfaces::Motion motion = surfaces::random_motion(seed + 100, 2);
    motion.scale = 2.5;
    const surfaces::Moved_function g(f, motion);
    const surfaces::Box box = random_surfaces::box_of(f), moved_box = surfaces::moved(box, motion);
    const Extremal_mesh a = extract_extremal_mesh(f, make_lattice(box.low, box.high, 80)).mesh;
    const Extremal_mesh b = extract_extremal_mesh(g, make_lattice(moved_box.low, moved_box.high, 112)).mesh;
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_scaled_measures(a, b, motion.scale, 0.01, false);
  }
}

TEST(Measures, refuse_what_is_not_there) {
  const Extremal_mesh mesh = hand_made::ellipsoid();
  EXPECT_THROW(edge_measures(mesh, 16), std::invalid_argument);
  EXPECT_THROW(line_measures(mesh, {{0, 32}, false}), std::invalid_argument);
  EXPECT_THROW(cell_measures(mesh, 8), std::invalid_argument);
  EXPECT_THROW(vertex_measures(mesh, 10), std::invalid_argument);
  EXPECT_EQ(line_measures(mesh, {}).length, 0);
  EXPECT_EQ(line_measures(mesh, {}).stability, 0);
}
