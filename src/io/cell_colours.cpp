// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_colours.h"

#include <algorithm>
#include <array>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// All around the circle of hues, neighbours in the list far from each other.
constexpr std::array<Colour, 12> hues = {Colour{214, 60, 60}, {60, 160, 200}, {230, 190, 50}, {120, 80, 190},
                                         {90, 180, 80},       {220, 90, 170}, {240, 140, 50}, {60, 90, 200},
                                         {170, 200, 60},      {170, 60, 150}, {50, 180, 150}, {160, 110, 70}};

/// light where E_g > 0: so the two sides of a line differ whatever their hues are.
Colour shade(const Colour& hue, int sign) {
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = sign > 0 ? std::uint8_t((2 * hue[i] + 3 * 255) / 5) : std::uint8_t(4 * hue[i] / 5);
  return colour;
}

/// a hue for each cell, one that no cell with a common vertex has if there is one.
std::vector<std::size_t> distinct_hues(const Extremal_mesh& mesh) {
  constexpr std::size_t none = hues.size();
  std::vector<std::size_t> hue(mesh.number_of_cells(), none);
  for (std::size_t c = 0; c < hue.size(); ++c) {
    std::array<std::size_t, hues.size()> met{};
    for (const auto& walk : mesh.cell(c).boundary)
      for (const Half_edge h : walk) {
        const std::uint32_t across = mesh.left_cell(h ^ 1U);
        if (hue[across] != none)
          ++met[hue[across]];
        for (const Half_edge branch : mesh.vertex(mesh.source(h)).star)
          if (const std::uint32_t other = mesh.left_cell(branch); hue[other] != none)
            ++met[hue[other]];
      }
    // To begin elsewhere for each cell makes use of all hues.
    hue[c] = c % hues.size();
    for (std::size_t i = 0; i < hues.size(); ++i)
      if (const std::size_t candidate = (c + i) % hues.size(); met[candidate] < met[hue[c]])
        hue[c] = candidate;
  }
  return hue;
}

} // namespace

std::vector<Colour> cell_colours(const Extremal_mesh& mesh, Cell_colouring colouring) {
  std::vector<Colour> colours;
  colours.reserve(mesh.number_of_cells());
  if (colouring == Cell_colouring::sign) {
    for (const Extremal_mesh_cell& cell : mesh.cells())
      colours.push_back(cell_colour(cell.sign));
    return colours;
  }
  const std::vector<std::size_t> hue = distinct_hues(mesh);
  for (std::size_t c = 0; c < hue.size(); ++c)
    colours.push_back(shade(hues[hue[c]], mesh.cell(c).sign));
  return colours;
}

} // namespace CGAL::Extremal_mesh_3
