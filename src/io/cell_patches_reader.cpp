// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../polygons/Ply_numbers.h"
#include "../polygons/file_content.h"

#include <CGAL/Extremal_mesh_3/io.h>

#include <array>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

namespace {

using Element = Ply_header::Element;
using Property = Ply_header::Property;

/// the number of the property with a name.
/// \throws std::runtime_error if there is none
std::size_t property_of(const Element& element, std::string_view name, bool is_list) {
  for (std::size_t p = 0; p < element.properties.size(); ++p)
    if (element.properties[p].name == name && element.properties[p].length.has_value() == is_list)
      return p;
  throw std::runtime_error(fmt::format("its header: expected a property {} of the element {}; were these cells written "
                                       "by --cells?",
                                       name, element.name));
}

/// \param axes  the numbers of the properties x y z nx ny nz
void read_points(const Element& element, Ply_numbers& numbers, Cell_patches& patches) {
  std::vector<std::optional<std::size_t>> slot(element.properties.size());
  constexpr std::array<std::string_view, 6> names{"x", "y", "z", "nx", "ny", "nz"};
  for (std::size_t i = 0; i < names.size(); ++i)
    slot[property_of(element, names[i], false)] = i;
  for_each_property(element, numbers, [&](std::size_t p, std::uint64_t i) {
    if (!slot[p])
      return skip(element.properties[p], numbers);
    if (patches.points.size() == i) {
      patches.points.emplace_back();
      patches.normals.emplace_back();
    }
    const double value = numbers.next(element.properties[p].type, "a coordinate");
    if (!std::isfinite(value))
      numbers.refuse(value, "a finite coordinate");
    (*slot[p] < 3 ? patches.points : patches.normals).back()[*slot[p] % 3] = value;
  });
}

void read_polygons(const Element& element, Ply_numbers& numbers, std::uint64_t points, Cell_patches& patches) {
  const std::size_t corners = property_of(element, "vertex_indices", true), cell = property_of(element, "cell", false);
  const auto index = [&](Ply_type type, double end, const char* expected) {
    const double value = numbers.next(type, expected);
    if (!(value >= 0 && value < end && value == std::floor(value)))
      numbers.refuse(value, fmt::format("{} less than {}", expected, end));
    return std::uint32_t(value);
  };
  for_each_property(element, numbers, [&](std::size_t p, std::uint64_t) {
    const Property& property = element.properties[p];
    if (p == corners) {
      const std::uint64_t n = list_length(property, numbers);
      if (n < 2)
        numbers.refuse(double(n), "a polygon of at least two corners");
      for (std::uint64_t i = 0; i < n; ++i)
        patches.corners.push_back(index(property.type, double(points), "the index of a vertex"));
      patches.begin.push_back(patches.corners.size());
    } else if (p == cell) {
      patches.cell.push_back(index(property.type, 0x1p31, "the number of a cell"));
    } else {
      skip(property, numbers);
    }
  });
}

} // namespace

Cell_patches read_cell_patches(const std::string& file) {
  return with_name_in_errors(file, [&] {
    const std::string content = content_of(file);
    const Ply_header header = read_ply_header(content);
    const auto element = [&](std::string_view name) -> const Element& {
      for (const Element& candidate : header.elements)
        if (candidate.name == name)
          return candidate;
      throw std::runtime_error(fmt::format("its header: expected an element {}", name));
    };
    const Element &vertex = element("vertex"), &face = element("face");
    Cell_patches patches;
    Ply_numbers numbers(content, header);
    for (const Element& next : header.elements)
      if (&next == &vertex)
        read_points(next, numbers, patches);
      else if (&next == &face)
        read_polygons(next, numbers, vertex.count, patches);
      else
        for_each_property(next, numbers, [&](std::size_t p, std::uint64_t) { skip(next.properties[p], numbers); });
    return patches;
  });
}

} // namespace CGAL::Extremal_mesh_3
