// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "propose.h"

#include "../cgal/Point_tree.h"
#include "../differential/vector.h"
#include "least_squares.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <random>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// More vertices than these do not make it more certain, but pairs grow with their square.
constexpr std::size_t most_vertices = 400;
constexpr std::size_t most_pairs_of_a = 6000;
constexpr std::size_t most_pairs_of_b = 80000;
/// How many of the second mesh's pairs are taken for the same as one of the first's.
constexpr std::size_t partners = 6;

struct Pair {
  std::uint32_t first = 0, second = 0;
};
using Descriptors = Point_tree<13>;

double curvedness(const Feature& f) {
  return std::sqrt((f.k1 * f.k1 + f.k2 * f.k2) / 2);
}

double median(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_curvedness(const std::vector<Feature>& features) {
  std::vector<double> all;
  for (const Feature& f : features)
    all.push_back(curvedness(f));
  return median(std::move(all));
}

/// the median distance to the nearest other vertex, of those that pairs are made of.
double spacing_of(const std::vector<Feature>& features) {
  std::vector<Point> points;
  for (const Feature& f : features)
    points.push_back(f.point);
  const Point_tree<3> tree(points);
  std::vector<double> all;
  for (const Point& p : points)
    if (const auto near = tree.nearest(p, 2, std::numeric_limits<double>::infinity()); near.size() == 2)
      all.push_back(near[1].distance);
  return median(std::move(all));
}

/// What makes numbers that differ by noise differ by about 1.
struct Units {
  double curvature = 1, log_distance = 0.1;
  bool scale_free = false;
  static constexpr double angle = 0.2, curvature_noise = 0.4;
};

Descriptors::Coordinates descriptor(const Feature& p, const Feature& q, const Units& units) {
  const double d = distance(p.point, q.point);
  const Vector u = 1 / d * (q.point - p.point);
  Descriptors::Coordinates c{};
  std::size_t next = 0;
  double unit_p = units.curvature, unit_q = units.curvature, length = d;
  if (units.scale_free) {
    unit_p = unit_q = std::sqrt(curvedness(p) * curvedness(q));
    length = d * unit_p;
  }
  c[next++] = std::log(length) / units.log_distance;
  for (const Feature* f : {&p, &q}) {
    c[next++] = dot(f->normal, u) / Units::angle;
    // The square of a complex number does not change with its sign, nor does it with that of t1 and t2.
    const double x = dot(f->t1, u), y = dot(f->t2, u);
    c[next++] = f->is_umbilic() ? 0 : (x * x - y * y) / Units::angle;
    c[next++] = f->is_umbilic() ? 0 : 2 * x * y / Units::angle;
  }
  c[next++] = dot(p.normal, q.normal) / Units::angle;
  c[next++] = dot(cross(p.normal, q.normal), u) / Units::angle;
  for (const double k : {p.k1 / unit_p, p.k2 / unit_p, q.k1 / unit_q, q.k2 / unit_q})
    c[next++] = std::asinh(k) / Units::curvature_noise; // noise is greater where the curvature is
  return c;
}

/// ordered pairs with a distance in a range.
std::vector<Pair> pairs_of(const std::vector<Feature>& features, double least, double most) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < features.size(); ++i)
    for (std::uint32_t j = 0; j < features.size(); ++j)
      if (i != j)
        if (const double d = distance(features[i].point, features[j].point); d >= least && d <= most && d > 0)
          pairs.push_back({i, j});
  return pairs;
}

/// takes some of the pairs, spread evenly over all.
void thin_out(std::vector<Pair>& pairs, std::size_t most, unsigned seed) {
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < std::min(most, pairs.size()); ++i) // std's shuffle differs between libraries
    std::swap(pairs[i], pairs[i + random() % (pairs.size() - i)]);
  pairs.resize(std::min(most, pairs.size()));
}

void add_outer_product(std::array<Vector, 3>& m, double weight, const Vector& b, const Vector& a) {
  for (std::size_t i = 0; i < 3; ++i)
    m[i] = m[i] + (weight * b[i]) * a;
}

/// the motion that takes one pair to the other; nothing if their frames do not agree.
std::optional<Similarity> motion_between(const std::array<const Feature*, 2>& a, const std::array<const Feature*, 2>& b,
                                         const Proposal_options& options) {
  const double da = distance(a[0]->point, a[1]->point), db = distance(b[0]->point, b[1]->point);
  if (!options.scale && std::abs(da - db) > 4 * options.tolerance + 0.1 * da)
    return std::nullopt;
  const Vector ua = 1 / da * (a[1]->point - a[0]->point), ub = 1 / db * (b[1]->point - b[0]->point);
  std::array<Vector, 3> sum{};
  add_outer_product(sum, 2, ub, ua); // distances are long: their directions are the best known
  for (std::size_t i = 0; i < 2; ++i)
    add_outer_product(sum, 1, b[i]->normal, a[i]->normal);
  // First without t1 and t2, the signs of which are not known; if that leaves a turn open, it is any of those.
  Similarity motion;
  motion.rotation = nearest_rotation(sum);
  for (std::size_t i = 0; i < 2; ++i)
    if (!a[i]->is_umbilic()) {
      const double sign = dot(motion.turned(a[i]->t1), b[i]->t1) + dot(motion.turned(a[i]->t2), b[i]->t2) < 0 ? -1 : 1;
      add_outer_product(sum, 0.5 * sign, b[i]->t1, a[i]->t1);
      add_outer_product(sum, 0.5 * sign, b[i]->t2, a[i]->t2);
    }
  motion.rotation = nearest_rotation(sum);
  if (options.scale)
    motion.scale = db / da;
  constexpr double close = 0.87; // 30 degrees
  if (dot(motion.turned(ua), ub) < 0.95)
    return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i)
    if (dot(motion.turned(a[i]->normal), b[i]->normal) < close ||
        (!a[i]->is_umbilic() && std::abs(dot(motion.turned(a[i]->t1), b[i]->t1)) < close))
      return std::nullopt;
  motion.translation = 0.5 * (b[0]->point + b[1]->point) - motion(0.5 * (a[0]->point + a[1]->point));
  return motion;
}

/// The space of motions, in which such as differ by the error of a pair have a distance of about 1.
class Motion_space {
public:
  Motion_space(const std::vector<Feature>& a, double scale) {
    for (const Feature& f : a)
      centre_ = centre_ + 1 / double(a.size()) * f.point;
    double sum = 0;
    for (const Feature& f : a)
      sum += dot(f.point - centre_, f.point - centre_);
    unit_ = 0.1 * scale * std::sqrt(sum / double(a.size()));
  }
  Point_tree<13>::Coordinates place_of(const Similarity& s) const {
    Point_tree<13>::Coordinates c{};
    std::size_t next = 0;
    constexpr double turn =
        0.1 * 1.4142135623730951; // of 6 degrees: the entries of a rotation by x change by √2·x in all
    for (const Vector& row : s.rotation)
      for (const double x : row)
        c[next++] = x / turn;
    for (const double x : s(centre_))
      c[next++] = x / unit_;
    c[next] = std::log(s.scale) / 0.1;
    return c;
  }
  Similarity mean(const std::vector<Similarity>& all, const std::vector<std::uint32_t>& members) const {
    std::array<Vector, 3> sum{};
    Point image{};
    double log_scale = 0;
    for (const std::uint32_t i : members) {
      for (std::size_t r = 0; r < 3; ++r)
        sum[r] = sum[r] + all[i].rotation[r];
      image = image + 1 / double(members.size()) * all[i](centre_);
      log_scale += std::log(all[i].scale) / double(members.size());
    }
    Similarity s;
    s.rotation = nearest_rotation(sum);
    s.scale = std::exp(log_scale);
    s.translation = image - s(centre_);
    return s;
  }

private:
  Point centre_{};
  double unit_ = 1;
};

/// the motions that many others are near to.
std::vector<Similarity> modes(const std::vector<Similarity>& all, const Motion_space& space, std::size_t most,
                              Thread_pool& threads) {
  std::vector<Point_tree<13>::Coordinates> places;
  for (const Similarity& s : all)
    places.push_back(space.place_of(s));
  const Point_tree<13> tree(places);
  std::vector<std::vector<std::uint32_t>> near(all.size());
  threads.for_each(all.size(), 64, [&](std::size_t i) { near[i] = tree.all_within(places[i], 1); });
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return near[i].size() > near[j].size(); });
  std::vector<bool> covered(all.size());
  std::vector<Similarity> result;
  for (const std::uint32_t i : order) {
    if (result.size() == most)
      break;
    if (covered[i])
      continue;
    result.push_back(space.mean(all, near[i]));
    for (const std::uint32_t j : tree.all_within(places[i], 1.5))
      covered[j] = true;
  }
  return result;
}

} // namespace

Proposals propose_motions(const std::vector<Feature>& all_a, const std::vector<Feature>& all_b,
                          const Proposal_options& options, Thread_pool& threads) {
  const auto first_of = [](const std::vector<Feature>& all) {
    return std::vector<Feature>(all.begin(), all.begin() + std::ptrdiff_t(std::min(all.size(), most_vertices)));
  };
  const std::vector<Feature> a = first_of(all_a), b = first_of(all_b);
  Proposals result;
  if (a.size() < 2 || b.size() < 2)
    return result;
  // Distances of a few spacings: short enough that both ends are in an overlap, long enough that they tell directions.
  double spacing_a = spacing_of(a), spacing_b = spacing_of(b);
  if (!options.scale)
    spacing_a = spacing_b = std::max(spacing_a, spacing_b);
  constexpr double least = 1.5, most = 8;
  std::vector<Pair> pairs_a = pairs_of(a, least * spacing_a, most * spacing_a),
                    pairs_b = pairs_of(b, 0.8 * least * spacing_b, 1.2 * most * spacing_b);
  thin_out(pairs_a, most_pairs_of_a, options.seed);
  thin_out(pairs_b, most_pairs_of_b, options.seed);
  for (const Pair& pair : pairs_a)
    result.baseline += distance(a[pair.first].point, a[pair.second].point) / double(pairs_a.size());

  Units units;
  units.curvature = std::max({median_curvedness(a), median_curvedness(b), 1e-300});
  units.scale_free = options.scale;
  units.log_distance = options.scale ? 0.3 : std::max(0.05, 2 * options.tolerance / std::max(result.baseline, 1e-300));
  using Kinds = std::pair<std::uint8_t, std::uint8_t>;
  std::map<Kinds, std::vector<Pair>> by_kinds;
  for (const Pair& pair : pairs_b)
    by_kinds[{b[pair.first].kind, b[pair.second].kind}].push_back(pair);
  std::map<Kinds, Descriptors> trees;
  for (const auto& [kinds, pairs] : by_kinds) {
    std::vector<Descriptors::Coordinates> points;
    for (const Pair& pair : pairs)
      points.push_back(descriptor(b[pair.first], b[pair.second], units));
    trees.emplace(kinds, Descriptors(points));
  }

  std::vector<std::vector<Similarity>> proposed(pairs_a.size());
  threads.for_each(pairs_a.size(), 16, [&](std::size_t i) {
    const Feature &p = a[pairs_a[i].first], &q = a[pairs_a[i].second];
    const auto tree = trees.find({p.kind, q.kind});
    if (tree == trees.end())
      return;
    const std::vector<Pair>& pairs = by_kinds.at(tree->first);
    constexpr double farthest = 6; // 13 numbers that differ by 1 each make 3.6
    for (const auto& near : tree->second.nearest(descriptor(p, q, units), partners, farthest))
      if (const auto motion =
              motion_between({&p, &q}, {&b[pairs[near.index].first], &b[pairs[near.index].second]}, options))
        proposed[i].push_back(*motion);
  });
  std::vector<Similarity> all;
  for (const auto& some : proposed)
    all.insert(all.end(), some.begin(), some.end());
  result.tried = all.size();
  if (!all.empty())
    result.motions = modes(all, Motion_space(a, options.scale ? spacing_b / spacing_a : 1), options.most, threads);
  return result;
}

} // namespace CGAL::Extremal_mesh_3
