// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Weights. They fall to 0 at the radius, so that a jet changes smoothly from vertex to vertex, and are in proportion
// to the vertex's share of the area, so that the fit is one to the surface and not to its triangulation. Measured on
// the ellipsoid x² + 2y² + 4z² = 1 as icosphere of 10242 vertices, whose triangles are stretched by up to 2, R =
// 0.17: without the areas the error of C differs along an edge by 2.4 % of C, with them by 1.7 %. Even triangulations
// do not mind either way.
// Frame. The mean normal, with the same weights, tilts less than the normal at the vertex: at R = 0.28 on a mesh of
// 1556 vertices the error of C is 22 % instead of 27 %, and on noisy meshes there is no question.
#include "Jet_fitter.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

// A jet has 15 coefficients; a few points more tell how well it fits. Two rings around a vertex of six neighbours are
// 19 points, around one of five 16.
constexpr std::size_t least_points_in_ball = 20, least_points_in_rings = 16;

/// How badly a jet may be determined.
struct Limits {
  double condition; ///< of Jet::condition
  double gain;      ///< of C by noise: Jet::third_error, as it would be without growth
  int growths;
};
// Discs have conditions of 4 to 10, half discs 80, quarters 90, sectors of 30 degrees 250. Above 100 the field of
// shapes is rough if not wrong in places. Even discs of 27 points have a gain of 24; narrow stripes, whose condition
// is as good as that of discs, have much more. The gain falls with the fourth power of the radius: from 24 to 200 for
// half a disc costs a growth by 1.4.
constexpr Limits good{150, 200, 0}, // by all means
    tolerable{1000, 2000, 8};       // if twice the radius did not help
constexpr double growth = 1.1;      // small steps, again for smoothness
constexpr int most_growths = 32;    // a factor of 21

bool within(const Limits& limits, const Jet& jet, double gain, int growths) {
  return jet.determined && jet.condition < limits.condition && gain < limits.gain && growths >= limits.growths;
}

} // namespace

/// tells whether a vertex and those along the sides of its polygon, on both hands, have no other neighbours: all that is near lies on a
/// curve, and to grow until it does not may take the whole of a large polygon.
bool Jet_fitter::lies_on_chain(std::uint32_t vertex) const {
  constexpr int steps = 10;
  if (adjacency_[vertex].size() > 2)
    return false;
  for (const std::uint32_t first : adjacency_[vertex]) {
    std::uint32_t before = vertex, here = first;
    for (int i = 0; i < steps; ++i) {
      const auto neighbours = adjacency_[here];
      if (neighbours.size() > 2)
        return false;
      if (neighbours.size() < 2)
        break;
      before = std::exchange(here, neighbours[neighbours[0] == before ? 1 : 0]);
    }
  }
  return true;
}

void Jet_fitter::add(Task task, Vertex_shapes& result) {
  const auto gather_enough = [&] {
    while (!gather(task))
      if (!grow(task))
        return false;
    return true;
  };
  if (lies_on_chain(task.vertex) || !gather_enough()) {
    Fit_quality q;
    q.state = Fit_state::too_few_points;
    q.points = std::uint32_t(task.points);
    q.radius = task.extent.radius;
    result.quality[task.entry] = q;
    return;
  }
  tasks_[batch_.size() - 1] = task;
  if (batch_.full())
    fit_batch(result);
}

/// takes the mean normal of the cells around the vertex for its own, which may be wild where cells are folded.
bool Jet_fitter::begin_again(Task& task) {
  if (task.begun_again)
    return false;
  Task again{task.vertex, task.entry, task.first_extent, task.first_extent};
  again.begun_again = true;
  for (const std::uint32_t w : adjacency_[task.vertex])
    again.normal = again.normal + vertices_[w].area * vertices_[w].n;
  const double length = norm(again.normal);
  if (!(length > 0))
    return false;
  again.normal = (1 / length) * again.normal;
  task = again;
  return true;
}

/// makes the neighbourhood larger, or finds another one, if that is possible.
bool Jet_fitter::grow(Task& task) {
  if (!task.can_grow || task.growths == most_growths)
    return begin_again(task);
  grown_ += task.growths == 0 && !task.begun_again;
  ++task.growths;
  task.extent.radius *= growth;
  task.extent.rings += task.extent.rings > 0;
  return true;
}

/// puts the neighbourhood into the batch, if it has enough points.
bool Jet_fitter::gather(Task& task) {
  const bool rings = task.extent.rings > 0;
  const auto found = rings ? walk_.within_rings(task.vertex, task.normal, task.extent.rings)
                           : walk_.within_distance(task.vertex, task.normal, task.extent.radius);
  task.points = found.size();
  task.can_grow = walk_.can_grow();
  if (found.size() < (rings ? least_points_in_rings : least_points_in_ball))
    return false;

  const Point origin = vertices_[task.vertex].p;
  const double s2 = 1 / (task.extent.radius * task.extent.radius);
  weights_.resize(found.size());
  Vector normal{};
  double farthest = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mesh_vertex& x = vertices_[found[i]];
    const Vector d = x.p - origin;
    const double distance2 = dot(d, d);
    farthest = std::max(farthest, distance2);
    const double t = 1 - distance2 * s2;
    weights_[i] = rings ? 1 : t * t * (x.area * s2);
    normal = normal + (rings ? x.area : weights_[i]) * x.n;
  }
  const double length = norm(normal);
  if (!(length > 0)) // points without area
    return false;
  task.frame.scale = rings ? std::sqrt(farthest) : task.extent.radius;
  task.frame.z = (1 / length) * normal;
  task.frame.x = any_orthogonal(task.frame.z);
  task.frame.y = cross(task.frame.z, task.frame.x);

  if (task.first_reach == 0)
    task.first_reach = std::sqrt(farthest);

  const double s = 1 / task.frame.scale;
  const Vector x = s * task.frame.x, y = s * task.frame.y, z = s * task.frame.z;
  batch_.begin(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Vector d = vertices_[found[i]].p - origin;
    batch_.set(i, dot(d, x), dot(d, y), dot(d, z), weights_[i]);
  }
  return true;
}

void Jet_fitter::fit_batch(Vertex_shapes& result) {
  const auto jets = batch_.fit();
  const auto tasks = tasks_;
  const std::size_t count = batch_.size();
  batch_.clear();
  for (std::size_t l = 0; l < count; ++l) {
    const Jet& jet = jets[l];
    Task task = tasks[l];
    const double scale = task.frame.scale;
    Fit_quality& q = result.quality[task.entry];
    q = {};
    q.points = std::uint32_t(task.points);
    q.radius = scale;
    const double r = task.first_reach / scale, gain = jet.third_error * (r * r * r);
    const bool rings = task.extent.rings > 0; // who asks for them shall have them
    if (!within(good, jet, gain, task.growths) &&
        !within(tolerable, jet, gain, rings ? tolerable.growths : task.growths)) {
      if (grow(task)) {
        add(task, result);
        continue;
      }
      if (!within(tolerable, jet, gain, tolerable.growths)) {
        q.state = Fit_state::rank_deficient;
        continue;
      }
    }
    q.state = Fit_state::fitted;
    q.condition = jet.condition;
    q.residual = jet.residual * scale;
    const double noise = std::max(jet.noise, rounding_ / scale);
    q.L_error = noise * jet.second_error / scale;
    q.C_error = noise * jet.third_error / (scale * scale);
    shape_of_jet(jet, task.frame, result.shapes[task.entry], result.fourth[task.entry]);
  }
}

} // namespace CGAL::Extremal_mesh_3
