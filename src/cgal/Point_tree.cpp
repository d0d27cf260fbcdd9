// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Point_tree.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace CGAL::Extremal_mesh_3 {

namespace {

template <std::size_t dimension> struct Numbered_point {
  std::array<double, dimension> coordinates;
  std::uint32_t index;
  bool operator==(const Numbered_point& other) const { return index == other.index; }
};

template <std::size_t dimension> struct Coordinates_of {
  using result_type = const double*;
  const double* operator()(const Numbered_point<dimension>& p) const { return p.coordinates.data(); }
  const double* operator()(const Numbered_point<dimension>& p, int) const { return p.coordinates.data() + dimension; }
};

template <std::size_t dimension>
using Traits = CGAL::Search_traits<double, Numbered_point<dimension>, const double*, Coordinates_of<dimension>,
                                   CGAL::Dimension_tag<int(dimension)>>;

} // namespace

template <std::size_t dimension> struct Point_tree<dimension>::Tree {
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits<dimension>>;
  typename Search::Tree tree;
};

template <std::size_t dimension>
Point_tree<dimension>::Point_tree(const std::vector<Coordinates>& points) : tree_(std::make_unique<Tree>()) {
  for (std::uint32_t i = 0; i < points.size(); ++i)
    tree_->tree.insert({points[i], i});
  if (!points.empty())
    tree_->tree.build(); // here and not in the first of the queries, which may come from many threads
}
template <std::size_t dimension> Point_tree<dimension>::~Point_tree() = default;
template <std::size_t dimension> Point_tree<dimension>::Point_tree(Point_tree&&) noexcept = default;
template <std::size_t dimension>
Point_tree<dimension>& Point_tree<dimension>::operator=(Point_tree&&) noexcept = default;

template <std::size_t dimension>
auto Point_tree<dimension>::nearest(const Coordinates& p, std::size_t k, double within) const
    -> std::vector<Neighbour> {
  std::vector<Neighbour> found;
  if (tree_->tree.size() == 0)
    return found;
  const typename Tree::Search search(tree_->tree, {p, 0}, unsigned(k));
  for (const auto& [point, squared] : search)
    if (const double distance = std::sqrt(squared); distance <= within)
      found.push_back({point.index, distance});
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.index < b.index);
  });
  return found;
}

template <std::size_t dimension>
std::vector<std::uint32_t> Point_tree<dimension>::all_within(const Coordinates& p, double within) const {
  std::vector<std::uint32_t> found;
  const auto take = [&found](const Numbered_point<dimension>& point) { found.push_back(point.index); };
  if (tree_->tree.size() > 0)
    tree_->tree.search(boost::make_function_output_iterator(std::cref(take)),
                       CGAL::Fuzzy_sphere<Traits<dimension>>(Numbered_point<dimension>{p, 0}, within));
  std::sort(found.begin(), found.end());
  return found;
}

template class Point_tree<3>;
template class Point_tree<13>;

} // namespace CGAL::Extremal_mesh_3
