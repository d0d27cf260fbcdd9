// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/landmarks.h>
#include <CGAL/Extremal_mesh_3/scale_space.h>

#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include "changed_mesh.h"
#include "hand_made.h"
#include "random_surfaces.h"
#include "same_mesh.h"
#include "surfaces.h"
#include "temporary_folder.h"

#include <cmath>

using namespace CGAL::Extremal_mesh_3;

namespace {

/// an ellipsoid with waves that fade away: what smoothing does, without an image.
Extremal_mesh with_waves(double height) {
  const auto f = make_function([height](auto x, auto y, auto z) {
    using std::cos;
    using std::sin;
    return x * x / 9 + y * y / 4 + z * z + height * sin(4 * x) * cos(5 * y + 1) - 1;
  });
  return extract_extremal_mesh(f, make_lattice({-3.3, -2.2, -1.2}, {3.3, 2.2, 1.2}, 64)).mesh;
}

/// extremal points and umbilics: the kinds that are followed.
bool is_followed(const Extremal_mesh_vertex& v) {
  return v.kind == Vertex_kind::extremal_point || v.kind == Vertex_kind::umbilic;
}
std::size_t followed(const Extremal_mesh& mesh) {
  std::size_t n = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    n += is_followed(mesh.vertex(v));
  return n;
}

} // namespace

TEST(Scale_space, of_meshes_that_are_all_the_same_has_no_events) {
  const Extremal_mesh mesh = with_waves(0.003);
  const Scale_space space = link_scales({mesh, mesh, mesh}, {1, 2, 4});
  EXPECT_TRUE(space.events.empty());
  EXPECT_EQ(space.tracks.size(), followed(mesh));
  const std::vector<double> vertices = space.vertex_life_times(1), edges = space.edge_life_times({mesh, mesh, mesh}, 0);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    EXPECT_NEAR(vertices[v], is_followed(mesh.vertex(v)) ? std::log(4.0) : 0, 1e-12);
  for (const double life_time : edges)
    EXPECT_NEAR(life_time, std::log(4.0), 1e-12);
}

TEST(Scale_space, tells_what_vanishes_as_waves_fade) {
  const std::vector<Extremal_mesh> meshes{with_waves(0.003), with_waves(0.001), with_waves(0)};
  ASSERT_GT(meshes[0].number_of_vertices(), meshes[2].number_of_vertices());
  const Scale_space space = link_scales(meshes, {1, 2, 4}, {0.2});
  // Every vertex of every level is in one track, and every end and every beginning is told once.
  std::size_t created = 0, ended = 0, in_tracks = 0, vertices = 0;
  for (const Scale_event& e : space.events) {
    created += e.kind == Scale_event_kind::create;
    ended += e.kind == Scale_event_kind::create ? 0 : e.kind == Scale_event_kind::cancel ? 2 : 1;
  }
  for (const Scale_track& t : space.tracks)
    in_tracks += t.vertices.size();
  for (const Extremal_mesh& mesh : meshes)
    vertices += followed(mesh);
  EXPECT_EQ(in_tracks, vertices);
  EXPECT_EQ(space.tracks.size(), followed(meshes[0]) + created);
  EXPECT_EQ(space.tracks.size(), followed(meshes[2]) + ended);
  EXPECT_GT(ended, 0U);
  // the umbilics of the ellipsoid are there from first to last
  std::size_t lasting = 0;
  for (const Scale_track& t : space.tracks)
    lasting += t.kind == Vertex_kind::umbilic && t.vertices.size() == 3;
  EXPECT_GE(lasting, 4U);
}

TEST(Scale_space, gives_closed_lines_a_life_time_by_their_places) {
  // a line of latitude that stays, and one that moves by more than it may
  const Extremal_mesh here = hand_made::two_loops();
  const Extremal_mesh there = changed(here, [](Mesh_parts& parts) {
    for (Point& p : parts.edges[1].polyline)
      p[2] += 10;
  });
  ASSERT_EQ(here.number_of_edges(), 2U);
  const std::vector<Extremal_mesh> meshes{here, there};
  const Scale_space space = link_scales(meshes, {1, 3}, {0.1});
  const std::vector<double> life_times = space.edge_life_times(meshes, 0);
  EXPECT_NEAR(life_times[0], std::log(3.0), 1e-12);
  EXPECT_EQ(life_times[1], 0);
}

TEST(Scale_space, gives_life_times_that_are_a_measure_for_simplification) {
  const std::vector<Extremal_mesh> meshes{with_waves(0.003), with_waves(0.001), with_waves(0)};
  const Scale_space space = link_scales(meshes, {1, 2, 4}, {0.2});
  const Extremal_mesh mesh = with_life_times(meshes, space, 0);
  Simplification_options options;
  options.measure = Simplification_measure::life_time;
  EXPECT_THROW(Simplification(meshes[0], options), std::invalid_argument);
  const Simplification simplification(mesh, options);
  ASSERT_FALSE(simplification.steps().empty());
  double before = 0;
  for (const Simplification_step& step : simplification.steps()) {
    EXPECT_GE(step.persistence, before);
    before = step.persistence;
    // What vanishes lives no longer than the step says, but for one of those that are merged, whose life time goes on in the one that stays.
    std::size_t longer = 0;
    for (const std::uint32_t v : step.vanished)
      longer += mesh.vertex(v).life_time.value() > step.persistence;
    EXPECT_LE(longer, step.operation == Simplification_operation::merge_vertices ? 1U : 0U)
        << to_string(step.operation);
  }
  // By persistence they do not come in this order.
  const Simplification by_persistence(mesh);
  bool in_order = true;
  double longest = 0;
  for (const Simplification_step& step : by_persistence.steps())
    for (const std::uint32_t v : step.vanished) {
      in_order = in_order && mesh.vertex(v).life_time.value() >= longest;
      longest = std::max(longest, mesh.vertex(v).life_time.value());
    }
  EXPECT_FALSE(in_order);
  // What is found at one scale only is gone first, without a contradiction, and the file keeps the rest.
  const std::size_t level = simplification.level_of_persistence(0);
  EXPECT_GT(level, 0U);
  const Extremal_mesh simple = simplification.mesh_at(level);
  surfaces::expect_all_checks_hold(simple);
  std::size_t lasting = 0;
  for (std::size_t v = 0; v < simple.number_of_vertices(); ++v)
    lasting += simple.vertex(v).kind == Vertex_kind::umbilic && simple.vertex(v).life_time.value() > std::log(3.9);
  EXPECT_GE(lasting, 4U); // those of the ellipsoid
  const Temporary_folder folder;
  write_graphml(folder.file("simple.graphml"), simple);
  same_mesh::expect_same(simple, read_graphml(folder.file("simple.graphml")));
}

TEST(Scale_space, refuses_scales_that_do_not_ascend) {
  const Extremal_mesh mesh = hand_made::two_loops();
  EXPECT_THROW(link_scales({mesh, mesh}, {1}), std::invalid_argument);
  EXPECT_THROW(link_scales({mesh, mesh}, {2, 1}), std::invalid_argument);
  EXPECT_THROW(link_scales({mesh, mesh}, {0, 1}), std::invalid_argument);
}

TEST(Landmarks, come_in_an_order_that_a_motion_does_not_change) {
  const auto f = random_surfaces::ellipsoid(5);
  const surfaces::Box box = random_surfaces::box_of(f);
  const surfaces::Motion motion = surfaces::random_motion(5, 3);
  const surfaces::Moved_function g(f, motion);
  const surfaces::Box moved = surfaces::moved(box, motion);
  const Extremal_mesh a = extract_extremal_mesh(f, make_lattice(box.low, box.high, 64)).mesh,
                      b = extract_extremal_mesh(g, make_lattice(moved.low, moved.high, 64)).mesh;
  Landmark_options options;
  options.umbilics = true;
  const auto first = strongest_landmarks(a, options), second = strongest_landmarks(b, options);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].id, second[i].id);
    if (i > 0 && first[i].id[0] == first[i - 1].id[0]) {
      EXPECT_LE(first[i].persistence, first[i - 1].persistence);
    }
    EXPECT_LT(surfaces::distance(motion(a.vertex(first[i].vertex).point), b.vertex(second[i].vertex).point), 1e-4)
        << first[i].id;
  }
}

TEST(Landmarks, on_extremal_points_are_matched_with_them) {
  const Extremal_mesh mesh = with_waves(0.003);
  const auto strongest = strongest_landmarks(mesh);
  std::vector<Given_landmark> given;
  for (const Landmark& l : strongest)
    given.push_back({l.id, mesh.vertex(l.vertex).point});
  const auto matches = match_landmarks(mesh, given);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    EXPECT_EQ(matches[i].extremal_point, strongest[i].vertex);
    EXPECT_EQ(matches[i].to_extremal_point, 0);
    EXPECT_LT(matches[i].to_line, 1e-12);
    EXPECT_GT(matches[i].chance_extremal_point, 0);
  }
}
