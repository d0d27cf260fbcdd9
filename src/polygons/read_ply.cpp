// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Greg Turk's polygon file format: the elements vertex and face; all else in it is left out.
#include "Ply_numbers.h"
#include "soup_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Element = Ply_header::Element;
using Property = Ply_header::Property;

void read_vertices(const Element& element, Ply_numbers& numbers, std::vector<Point>& points) {
  constexpr std::size_t none = 3;
  std::vector<std::size_t> axis; // of each property
  std::array<bool, 3> known{};
  for (const Property& property : element.properties) {
    const std::size_t a = property.name.size() == 1 && !property.length ? std::size_t(property.name[0] - 'x') : none;
    axis.push_back(std::min(a, none));
    if (a < none)
      known[a] = true;
  }
  if (!known[0] || !known[1] || !known[2])
    throw std::runtime_error("its header: expected properties x, y and z of the element vertex");
  for_each_property(element, numbers, [&](std::size_t p, std::uint64_t i) {
    if (axis[p] == none)
      return skip(element.properties[p], numbers);
    if (points.size() == i)
      points.emplace_back();
    const double value = numbers.next(element.properties[p].type, "a coordinate");
    if (!std::isfinite(value))
      numbers.refuse(value, "a finite coordinate");
    points.back()[axis[p]] = value;
  });
}

void read_faces(const Element& element, Ply_numbers& numbers, std::uint64_t vertices, std::vector<Polygon>& polygons) {
  const auto is_list_of_corners = [](const Property& property) {
    return property.length && (property.name == "vertex_indices" || property.name == "vertex_index");
  };
  const auto corners = std::find_if(element.properties.begin(), element.properties.end(), is_list_of_corners);
  if (corners == element.properties.end())
    throw std::runtime_error("its header: expected a list vertex_indices of the element face");
  for_each_property(element, numbers, [&](std::size_t p, std::uint64_t) {
    const Property& property = element.properties[p];
    if (&property != &*corners)
      return skip(property, numbers);
    polygons.emplace_back(list_length(property, numbers));
    for (std::uint32_t& corner : polygons.back()) {
      const double value = numbers.next(property.type, "the index of a vertex");
      if (!(value >= 0 && value < double(vertices) && value == std::floor(value)))
        numbers.refuse(value, fmt::format("the index of a vertex from 0 to {}", std::int64_t(vertices) - 1));
      corner = std::uint32_t(value);
    }
  });
}

} // namespace

Polygon_soup read_ply(std::string_view content) {
  const Ply_header header = read_ply_header(content);
  const auto count = [&](std::string_view name) -> std::uint64_t {
    const auto found = std::find_if(header.elements.begin(), header.elements.end(),
                                    [&](const Element& element) { return element.name == name; });
    if (found == header.elements.end())
      throw std::runtime_error(fmt::format("its header: expected an element {}", name));
    return found->count;
  };
  const std::uint64_t vertices = count("vertex");
  count("face");

  Polygon_soup soup;
  Ply_numbers numbers(content, header);
  for (const Element& element : header.elements)
    if (element.name == "vertex" && soup.points.empty())
      read_vertices(element, numbers, soup.points);
    else if (element.name == "face" && soup.polygons.empty())
      read_faces(element, numbers, vertices, soup.polygons);
    else
      for_each_property(element, numbers, [&](std::size_t p, std::uint64_t) { skip(element.properties[p], numbers); });
  return soup;
}

} // namespace CGAL::Extremal_mesh_3
