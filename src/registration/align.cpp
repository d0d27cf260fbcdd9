// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Iterated closest points with Tukey's biweight, whose scale is the median of the residuals of each sort.
#include "align.h"

#include "../differential/vector.h"
#include "least_squares.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The sorts of residuals.
enum Sort : std::uint8_t { surface, across_line, vertex_normal, vertex_tangent };
constexpr std::size_t sorts = 4;

struct Residual {
  Point point{};      ///< of the first mesh, moved
  Vector direction{}; ///< along which it is measured
  double value = 0;
  Sort sort = surface;
  double weight = 0;
};

void find_residuals(const Feature& f, const Target& b, const Similarity& motion, double gate,
                    std::vector<Residual>& out) {
  const auto found = b.vertex_near(f, motion, gate);
  if (!found)
    return;
  const Feature& other = b.features().vertices[*found];
  const Point p = motion(f.point);
  const Vector d = p - other.point;
  out.push_back({p, other.normal, dot(other.normal, d), vertex_normal, 0});
  out.push_back({p, other.t1, dot(other.t1, d), vertex_tangent, 0});
  out.push_back({p, other.t2, dot(other.t2, d), vertex_tangent, 0});
}

void find_residuals(const Line_sample& s, const Target& b, const Similarity& motion, double gate,
                    std::vector<Residual>& out) {
  const Point p = motion(s.point);
  const Vector n = motion.turned(s.normal);
  // lines of noise have none of their kind, but lie on the surface, which is known from the lines around
  constexpr double farther = 3;
  if (const auto found = b.surface_near(s, motion, farther * gate)) {
    const Line_sample& other = b.features().samples[*found];
    const Vector mean = normalized(n + other.normal);
    out.push_back({p, mean, dot(mean, p - other.point), surface, 0});
  }
  if (const auto found = b.line_near(s, motion, gate)) {
    const Line_sample& other = b.features().samples[*found];
    const Vector across = cross(other.normal, other.tangent);
    out.push_back({p, across, dot(across, p - other.point), across_line, 0});
  }
}

std::vector<Residual> find_residuals(const Features& a, const Target& b, const Similarity& motion, double gate,
                                     Thread_pool* threads) {
  std::vector<std::vector<Residual>> found(a.vertices.size() + a.samples.size());
  const auto one = [&](std::size_t i) {
    if (i < a.vertices.size())
      find_residuals(a.vertices[i], b, motion, gate, found[i]);
    else
      find_residuals(a.samples[i - a.vertices.size()], b, motion, gate, found[i]);
  };
  if (threads != nullptr)
    threads->for_each(found.size(), 64, one);
  else
    for (std::size_t i = 0; i < found.size(); ++i)
      one(i);
  std::vector<Residual> all;
  for (const auto& some : found)
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

/// weighs residuals by how small those of their sort are.
/// \param least  deviation, that of rounding
/// \return the deviation of the distances from the surface
double weigh(std::vector<Residual>& residuals, double least, const std::array<double, sorts>& share) {
  std::array<double, sorts> deviation{};
  for (std::size_t sort = 0; sort < sorts; ++sort) {
    std::vector<double> sizes;
    for (const Residual& r : residuals)
      if (r.sort == sort)
        sizes.push_back(std::abs(r.value));
    if (sizes.empty())
      continue;
    const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    deviation[sort] = std::max(1.4826 * *middle, least);
  }
  double sum = 0, squares = 0;
  for (Residual& r : residuals) {
    const double u = r.value / (4.685 * deviation[r.sort]);
    const double tukey = std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
    r.weight = share[r.sort] * tukey / (deviation[r.sort] * deviation[r.sort]);
    if (r.sort == surface) {
      sum += tukey;
      squares += tukey * r.value * r.value;
    }
  }
  return sum > 0 ? std::sqrt(squares / sum) : 0;
}

Point centre_of(const std::vector<Residual>& residuals) {
  Point centre{};
  double sum = 0;
  for (const Residual& r : residuals) {
    centre = centre + r.weight * r.point;
    sum += r.weight;
  }
  return sum > 0 ? 1 / sum * centre : centre;
}

/// Lengths in units of the overlap's size, or turns and translations could not be compared.
Unknowns derivative(const Residual& r, const Point& centre, double size) {
  const Vector x = 1 / size * (r.point - centre), turn = cross(x, r.direction);
  return {turn[0], turn[1], turn[2], r.direction[0], r.direction[1], r.direction[2], dot(x, r.direction)};
}

double size_of(const std::vector<Residual>& residuals, const Point& centre) {
  double sum = 0, weights = 0;
  for (const Residual& r : residuals) {
    sum += r.weight * dot(r.point - centre, r.point - centre);
    weights += r.weight;
  }
  return weights > 0 ? std::sqrt(sum / weights) : 0;
}

Normal_equations equations_of(const std::vector<Residual>& residuals, const Point& centre, double size, bool scale) {
  Normal_equations equations;
  for (const Residual& r : residuals)
    if (r.weight > 0)
      equations.add(derivative(r, centre, size), r.value, r.weight);
  if (!scale)
    equations.hold(6);
  return equations;
}

/// turns, moves and scales about the centre, by lengths in units of `size`.
Similarity changed(const Similarity& motion, const Unknowns& by, const Point& centre, double size) {
  Similarity change;
  change.rotation = rotation_by({by[0] / size, by[1] / size, by[2] / size});
  change.scale = std::exp(by[6] / size);
  change.translation = centre + Vector{by[3], by[4], by[5]} - change(centre);
  return change * motion;
}

/// the standard errors, from the scatter of the sums over blocks: residuals beside each other have the same cause.
void estimate_errors(Alignment& result, const std::vector<Residual>& residuals, const Point& centre, double size,
                     const Alignment_options& options, const Square_matrix& inverse) {
  std::map<std::array<std::int64_t, 3>, Unknowns> blocks;
  for (const Residual& r : residuals) {
    if (!(r.weight > 0))
      continue;
    std::array<std::int64_t, 3> block{};
    for (std::size_t i = 0; i < 3; ++i)
      block[i] = std::int64_t(std::floor((r.point[i] - centre[i]) / options.block));
    Unknowns& sum = blocks[block];
    const Unknowns d = derivative(r, centre, size);
    for (std::size_t i = 0; i < unknowns; ++i)
      sum[i] += r.weight * r.value * d[i];
  }
  Square_matrix scatter{};
  for (auto& [block, sum] : blocks) {
    if (!options.scale)
      sum[6] = 0;
    const Unknowns change = inverse * sum;
    for (std::size_t i = 0; i < unknowns; ++i)
      for (std::size_t j = 0; j < unknowns; ++j)
        scatter[i][j] += change[i] * change[j];
  }
  // as for a variance from few numbers; less than what independent residuals would give it cannot be
  const double n = double(blocks.size()), factor = n > unknowns ? n / (n - double(unknowns)) : n;
  const auto error = [&](std::size_t first) {
    std::array<Vector, 3> independent{}, blockwise{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        independent[i][j] = inverse[first + i][first + j];
        blockwise[i][j] = factor * scatter[first + i][first + j];
      }
    return std::sqrt(std::max(greatest_eigenvalue(independent), greatest_eigenvalue(blockwise)));
  };
  result.rotation_error = error(0) / size;
  result.translation_error = error(3);
  if (options.scale)
    result.scale_error = std::sqrt(std::max(inverse[6][6], factor * scatter[6][6])) / size;
}

} // namespace

Alignment align(const Features& a, const Target& b, const Similarity& start, const Alignment_options& options,
                Thread_pool* threads) {
  Alignment result;
  result.motion = start;
  // Samples that lie close to each other tell the same: those of a line count less the denser they lie.
  const double dense = options.block > 0 ? std::min(1.0, start.scale * a.spacing / options.block) : 1;
  const std::array<double, sorts> share{dense, dense, 1, 1};
  // rounds from the first gate to the last, each narrower by a fifth
  const double narrowing = std::ceil(std::log(options.first_gate / options.last_gate) / std::log(1.25));
  for (int round = 0; round < options.rounds; ++round) {
    const double t = narrowing > 0 ? std::min(1.0, double(round) / narrowing) : 1;
    const double gate = options.first_gate * std::pow(options.last_gate / options.first_gate, t);
    std::vector<Residual> residuals = find_residuals(a, b, result.motion, gate, threads);
    result.surface_rms = weigh(residuals, 1e-9 * options.last_gate, share);
    const Point centre = centre_of(residuals);
    const double size = size_of(residuals, centre);
    result.determined = false;
    if (residuals.size() < unknowns || !(size > 0))
      return result;
    const Normal_equations equations = equations_of(residuals, centre, size, options.scale);
    const auto inverse = equations.inverse();
    if (!inverse)
      return result;
    result.determined = true;
    const Unknowns by = *inverse * equations.right;
    result.motion = changed(result.motion, by, centre, size);
    double step = 0;
    for (const double x : by)
      step = std::max(step, std::abs(x));
    const bool converged = t == 1 && step < 1e-5 * options.last_gate;
    if (converged || round + 1 == options.rounds) {
      estimate_errors(result, residuals, centre, size, options, *inverse);
      result.motion.rotation = nearest_rotation(result.motion.rotation); // without the rounding of all the rounds
      break;
    }
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
