// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Jet_fitter.h"

#include "../differential/vector.h"

#include <algorithm>

namespace CGAL::Extremal_mesh_3 {

namespace {

// A jet has 15 coefficients; a few points more tell how well it fits. Two rings around a vertex of six neighbours are 19 points, around one
// of five 16.
constexpr std::size_t least_points_in_ball = 20, least_points_in_rings = 16;
constexpr double largest_condition = 1000;
constexpr double growth = 1.25;
constexpr int most_growths = 16; // a factor of 35

} // namespace

void Jet_fitter::add(Task task, Vertex_shapes& result) {
  while (!gather(task)) {
    if (!walk_.can_grow() || task.growths == most_growths) {
      Fit_quality q;
      q.state = Fit_state::too_few_points;
      q.points = std::uint32_t(task.points);
      q.radius = task.frame.scale;
      result.quality[task.vertex] = q;
      return;
    }
    ++task.growths;
    task.extent.radius *= growth;
    task.extent.rings += task.extent.rings > 0;
  }
  tasks_[batch_.size() - 1] = task;
  if (batch_.full())
    fit_batch(result);
}

/// puts the neighbourhood into the batch, if it has enough points.
bool Jet_fitter::gather(Task& task) {
  const bool rings = task.extent.rings > 0;
  const auto found = rings ? walk_.within_rings(task.vertex, task.extent.rings)
                           : walk_.within_distance(task.vertex, task.extent.radius);
  task.points = found.size();
  if (found.size() < (rings ? least_points_in_rings : least_points_in_ball))
    return false;
  const Point origin = vertices_[task.vertex].p;

  weights_.resize(found.size());
  Vector normal{};
  double farthest = 0;
  const double scale2 = 1 / (task.extent.radius * task.extent.radius);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mesh_vertex& x = vertices_[found[i]];
    const Vector d = x.p - origin;
    const double distance2 = dot(d, d);
    farthest = std::max(farthest, distance2);
    const double t = rings ? 0 : 1 - distance2 * scale2;
    weights_[i] = rings ? 1 : t * t;
    normal = normal + weights_[i] * x.n;
  }
  task.frame.scale = rings ? std::sqrt(farthest) : task.extent.radius;
  task.frame.z = normalized(normal);
  task.frame.x = any_orthogonal(task.frame.z);
  task.frame.y = cross(task.frame.z, task.frame.x);

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
    const bool sound = jet.determined && jet.condition < largest_condition;
    Fit_quality& q = result.quality[task.vertex];
    q = {};
    q.points = std::uint32_t(task.points);
    q.radius = scale;
    if (!sound) {
      q.state = Fit_state::rank_deficient;
      if (task.growths == most_growths)
        continue;
      ++task.growths;
      task.extent.radius *= growth;
      task.extent.rings += task.extent.rings > 0;
      add(task, result);
      continue;
    }
    q.state = Fit_state::fitted;
    q.condition = jet.condition;
    q.residual = jet.residual * scale;
    q.L_error = jet.second_error / scale;
    q.C_error = jet.third_error / (scale * scale);
    shape_of_jet(jet, task.frame, result.shapes[task.vertex], result.fourth[task.vertex]);
  }
}

} // namespace CGAL::Extremal_mesh_3
