// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "residuals.h"

#include "../differential/vector.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// Lines of noise have none of their kind, but lie on the surface, which is known from the lines around, so far in gates.
constexpr double reach_of_surface = 3;

/// where a height is measured. As the mean of the normals turns by half when the first mesh turns, its derivative is that at the
/// middle between the two points.
Point middle(const Point& p, const Point& q) {
  return 0.5 * (p + q);
}

void find(const Feature& f, const Target& b, const Similarity& motion, double gate, std::vector<Residual>& out) {
  const auto found = b.vertex_near(f, motion, gate);
  if (!found)
    return;
  const Feature& other = b.features().vertices[*found];
  const Point p = motion(f.point);
  const Vector d = p - other.point;
  // along the mean of both normals, as at lines: along one of them it would be wrong by the curvature times half of the squared
  // distance, much more than noise moves surfaces
  const Vector mean = normalized(motion.turned(f.normal) + other.normal);
  out.push_back({middle(p, other.point), mean, dot(mean, d), Residual_sort::surface, 0});
  out.push_back({p, other.t1, dot(other.t1, d), Residual_sort::vertex_tangent, 0});
  out.push_back({p, other.t2, dot(other.t2, d), Residual_sort::vertex_tangent, 0});
}

void find(const Line_sample& s, const Target& b, const Similarity& motion, double gate, std::vector<Residual>& out) {
  if (const auto found = b.surface_near(s, motion, reach_of_surface * gate))
    if (const auto height = height_over(s, motion, b.features().samples[*found]))
      out.push_back(*height);
  if (const auto found = b.line_near(s, motion, gate)) {
    const Line_sample& other = b.features().samples[*found];
    const Point p = motion(s.point);
    const Vector across = cross(other.normal, other.tangent);
    out.push_back({p, across, dot(across, p - other.point), Residual_sort::across_line, 0});
  }
}

/// one after the other what each of n elements has.
template <class Body> std::vector<Residual> gather(std::size_t n, Thread_pool* threads, const Body& body) {
  std::vector<std::vector<Residual>> found(n);
  const auto one = [&](std::size_t i) { body(i, found[i]); };
  if (threads != nullptr)
    threads->for_each(n, 64, one);
  else
    for (std::size_t i = 0; i < n; ++i)
      one(i);
  std::vector<Residual> all;
  for (const auto& some : found)
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

} // namespace

std::optional<Residual> height_over(const Line_sample& a, const Similarity& motion, const Line_sample& b) {
  Line_sample moved = a;
  moved.point = motion(a.point);
  moved.normal = motion.turned(a.normal);
  moved.tangent = motion.turned(a.tangent);
  const Vector mean = normalized(moved.normal + b.normal), d = moved.point - b.point;
  const double height = dot(mean, d);
  const Vector beside = d - height * mean;
  // Along the mean of the normals the slopes at the two ends cancel out: what is left of Hermite's formula is a twelfth of the
  // difference of the second derivatives.
  const double bent_a = moved.bent(beside) / motion.scale, bent_b = b.bent(beside);
  if (std::max(std::abs(bent_a), std::abs(bent_b)) > norm(beside)) // by more than about a radian on the way
    return std::nullopt;
  return Residual{middle(moved.point, b.point), mean, height - (bent_a - bent_b) / 12, Residual_sort::surface, 0};
}

std::vector<Residual> find_residuals(const Features& a, const Target& b, const Similarity& motion, double gate,
                                     Thread_pool* threads) {
  return gather(a.vertices.size() + a.samples.size(), threads, [&](std::size_t i, std::vector<Residual>& out) {
    if (i < a.vertices.size())
      find(a.vertices[i], b, motion, gate, out);
    else
      find(a.samples[i - a.vertices.size()], b, motion, gate, out);
  });
}

std::vector<Residual> find_residuals_back(const Features& b, const Target& a, const Similarity& backwards, double gate,
                                          Thread_pool& threads) {
  const Similarity motion = backwards.inverse();
  return gather(b.samples.size(), &threads, [&](std::size_t i, std::vector<Residual>& out) {
    const Line_sample& s = b.samples[i];
    if (const auto found = a.surface_near(s, backwards, reach_of_surface * gate * backwards.scale))
      if (const auto height = height_over(a.features().samples[*found], motion, s))
        out.push_back(*height);
  });
}

double weigh(std::vector<Residual>& residuals, double least, const std::array<double, residual_sorts>& share) {
  std::array<double, residual_sorts> deviation{};
  for (std::size_t sort = 0; sort < residual_sorts; ++sort) {
    std::vector<double> sizes;
    for (const Residual& r : residuals)
      if (std::size_t(r.sort) == sort)
        sizes.push_back(std::abs(r.value));
    if (sizes.empty())
      continue;
    const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    deviation[sort] = std::max(1.4826 * *middle, least);
  }
  double sum = 0, squares = 0;
  for (Residual& r : residuals) {
    const auto sort = std::size_t(r.sort);
    const double u = r.value / (4.685 * deviation[sort]);
    const double tukey = std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
    r.weight = share[sort] * tukey / (deviation[sort] * deviation[sort]);
    if (r.sort == Residual_sort::surface) {
      sum += tukey;
      squares += tukey * r.value * r.value;
    }
  }
  return sum > 0 ? std::sqrt(squares / sum) : 0;
}

Change_frame::Change_frame(const std::vector<Residual>& residuals) {
  double sum = 0;
  for (const Residual& r : residuals) {
    centre = centre + r.weight * r.point;
    sum += r.weight;
  }
  if (!(sum > 0))
    return;
  centre = 1 / sum * centre;
  double squares = 0;
  for (const Residual& r : residuals)
    squares += r.weight * dot(r.point - centre, r.point - centre);
  size = std::sqrt(squares / sum);
}

Unknowns Change_frame::derivative(const Residual& r) const {
  const Vector x = 1 / size * (r.point - centre), turn = cross(x, r.direction);
  return {turn[0], turn[1], turn[2], r.direction[0], r.direction[1], r.direction[2], dot(x, r.direction)};
}

Similarity Change_frame::changed(const Similarity& motion, const Unknowns& by) const {
  Similarity change;
  change.rotation = rotation_by({by[0] / size, by[1] / size, by[2] / size});
  change.scale = std::exp(by[6] / size);
  change.translation = centre + Vector{by[3], by[4], by[5]} - change(centre);
  return change * motion;
}

} // namespace CGAL::Extremal_mesh_3
