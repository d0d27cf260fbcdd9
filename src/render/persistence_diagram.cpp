// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/persistence_diagram.h>

#include "../io/Text_file.h"
#include "Diagram.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double left = 90, right = 870, top = 76, bottom = 540;
/// A scale of more decades would squeeze those in which something happens. Steps below stand on the bottom line.
constexpr int most_decades = 8;
constexpr Colour grid{228, 230, 234}, frame{120, 124, 132}, gap_tint{255, 240, 200}, level_ink{200, 30, 40};

/// of each operation.
constexpr std::array<Colour, 8> operation_colours = {Colour{31, 119, 180}, {214, 39, 160}, {255, 127, 14},
                                                     {44, 160, 44},        {140, 86, 75},  {120, 120, 120},
                                                     {23, 190, 207},       {90, 70, 200}};

Colour colour_of(Simplification_operation operation) {
  return operation_colours[std::min(static_cast<std::size_t>(operation), operation_colours.size() - 1)];
}

std::string lower_case_extension(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Where numbers of vertices and persistences are in the diagram.
class Axes {
public:
  explicit Axes(const std::vector<Simplification_step>& steps) {
    double least = 0, greatest = 0;
    for (const Simplification_step& step : steps) {
      most_vertices_ = std::max(most_vertices_, double(step.vertices));
      greatest = std::max(greatest, step.persistence);
      if (step.persistence > 0 && least == 0) // they never fall
        least = step.persistence;
    }
    if (greatest == 0)
      return;
    high_ = int(std::floor(std::log10(greatest))) + 1;
    low_ = std::max(int(std::floor(std::log10(least))), high_ - most_decades);
  }

  double x(double vertices) const {
    return left + (right - left) * std::log1p(vertices) / std::log1p(1.1 * most_vertices_);
  }
  /// below the decades there is room for what is less.
  double y(double persistence) const {
    const double decade = persistence > 0 ? std::log10(persistence) : -1e9;
    return bottom - (bottom - top) * std::max(decade - low_ + 0.5, 0.0) / (high_ - low_ + 0.5);
  }
  double most_vertices() const { return most_vertices_; }
  int low() const { return low_; }
  int high() const { return high_; }

private:
  double most_vertices_ = 1;
  int low_ = -1, high_ = 0; ///< powers of 10
};

void draw_axes(Diagram& diagram, const Axes& axes) {
  using Align = Diagram::Align;
  for (int decade = axes.low(); decade <= axes.high(); ++decade) {
    const double y = axes.y(std::pow(10, decade));
    diagram.lines.push_back({left, y, right, y, 1, grid, false});
    diagram.texts.push_back({left - 8, y, Align::right, fmt::format("{:g}", std::pow(10, decade))});
  }
  diagram.texts.push_back({left - 8, bottom, Align::right, "less"});
  const auto most = std::uint64_t(1.1 * axes.most_vertices());
  for (std::uint64_t decade = 1; decade <= most; decade *= 10)
    for (const std::uint64_t n : {decade, 2 * decade, 5 * decade})
      if (n <= most) {
        const double x = axes.x(double(n));
        diagram.lines.push_back({x, top, x, bottom, 1, grid, false});
        diagram.texts.push_back({x, bottom + 14, Align::middle, std::to_string(n)});
      }
  diagram.texts.push_back({left, bottom + 14, Align::middle, "0"});
  diagram.lines.push_back({left, top, left, bottom, 1, frame, false});
  diagram.lines.push_back({left, bottom, right, bottom, 1, frame, false});
  diagram.texts.push_back({(left + right) / 2, bottom + 38, Align::middle, "vertices left after the step"});
  diagram.texts.push_back(
      {14, 20, Align::left, "persistence: change of a curvature times the root of the area (no unit)"});
}

/// where the border between the steps before a level and those after is.
std::array<double, 2> border_at(const std::vector<Simplification_step>& steps, std::size_t level, const Axes& axes) {
  return {level > 0 ? axes.y(steps[level - 1].persistence) : bottom,
          level < steps.size() ? axes.y(steps[level].persistence) : top};
}

void draw_marks(Diagram& diagram, const Axes& axes, const Simplification& simplification, std::size_t level) {
  const auto& steps = simplification.steps();
  if (steps.empty())
    return;
  const auto vertices_at = [&](std::size_t l) {
    return l > 0 ? fmt::format("{} vertices", steps[l - 1].vertices) : std::string("nothing done");
  };
  const std::size_t gap = simplification.level_at_gap();
  const auto [below, above] = border_at(steps, gap, axes);
  diagram.rectangles.push_back({left, above, right - left, below - above, gap_tint});
  diagram.texts.push_back(
      {right - 6, above + 12, Diagram::Align::right, fmt::format("gap at level {}: {}", gap, vertices_at(gap))});
  const auto [done, next] = border_at(steps, level, axes);
  const double y = (done + next) / 2;
  diagram.lines.push_back({left, y, right, y, 1.5, level_ink, true});
  // beside the other mark's text where both are at the same place
  const double text_y = std::abs(y - 10 - (above + 12)) < 14 ? y + 12 : y - 10;
  diagram.texts.push_back(
      {right - 6, text_y, Diagram::Align::right, fmt::format("chosen level {}: {}", level, vertices_at(level))});
}

void draw_steps(Diagram& diagram, const Axes& axes, const std::vector<Simplification_step>& steps) {
  std::map<Simplification_operation, Diagram::Dots> of_operation;
  for (const Simplification_step& step : steps) {
    Diagram::Dots& dots = of_operation[step.operation];
    if (dots.centres.empty()) {
      dots.name = to_string(step.operation);
      dots.colour = colour_of(step.operation);
    }
    dots.centres.push_back({axes.x(double(step.vertices)), axes.y(step.persistence)});
  }
  double x = left, y = 40;
  for (auto& [operation, dots] : of_operation) {
    std::string text = fmt::format("{} {}", dots.centres.size(), dots.name);
    std::replace(text.begin(), text.end(), '_', ' ');
    const double width = 30 + 6.5 * double(text.size());
    if (x + width > right) {
      x = left;
      y += 18;
    }
    diagram.rectangles.push_back({x, y - 4, 8, 8, dots.colour});
    diagram.texts.push_back({x + 13, y, Diagram::Align::left, text});
    x += width;
    diagram.dots.push_back(std::move(dots));
  }
  if (steps.empty())
    diagram.texts.push_back({left, y, Diagram::Align::left, "no step"});
  // What is rare is drawn last, or it would not be seen.
  std::stable_sort(diagram.dots.begin(), diagram.dots.end(),
                   [](const auto& a, const auto& b) { return a.centres.size() > b.centres.size(); });
}

void write_csv(const std::string& file, const Simplification& simplification, std::size_t level) {
  const std::size_t gap = simplification.level_at_gap();
  Text_file out(file);
  out << "level,vertices,persistence,operation,done,below_gap\n";
  std::size_t next = 1;
  for (const Simplification_step& step : simplification.steps()) {
    out.print(FMT_COMPILE("{},{},{},{},{},{}\n"), next, step.vertices, step.persistence, to_string(step.operation),
              int(next <= level), int(next <= gap));
    ++next;
  }
  out.commit();
}

} // namespace

bool is_persistence_diagram_file(const std::string& file) {
  const std::string extension = lower_case_extension(file);
  return extension == ".svg" || extension == ".png" || extension == ".csv";
}

void write_persistence_diagram(const std::string& file, const Simplification& simplification, std::size_t level) {
  if (!is_persistence_diagram_file(file))
    throw std::invalid_argument(
        fmt::format("the extension of '{}' is not one of a persistence diagram: .svg, .png or .csv", file));
  if (level >= simplification.number_of_levels())
    throw std::out_of_range(
        fmt::format("there is no level {}; the last one is {}", level, simplification.number_of_levels() - 1));
  const std::string extension = lower_case_extension(file);
  if (extension == ".csv")
    return write_csv(file, simplification, level);
  Diagram diagram;
  const Axes axes(simplification.steps());
  draw_marks(diagram, axes, simplification, level);
  std::vector<Diagram::Line> mark = std::move(diagram.lines); // over the grid
  diagram.lines.clear();
  draw_axes(diagram, axes);
  diagram.lines.insert(diagram.lines.end(), mark.begin(), mark.end());
  draw_steps(diagram, axes, simplification.steps());
  if (extension == ".svg")
    diagram.write_svg(file);
  else
    diagram.write_png(file);
}

void write_hierarchy(const std::string& file, const Simplification& simplification) {
  Text_file out(file);
  out << "level,operation,persistence,x,y,z,vertices,edges,cells,vanished\n";
  std::size_t level = 1;
  for (const Simplification_step& step : simplification.steps()) {
    out.print(FMT_COMPILE("{},{},{},{},{},{},{},{},{},"), level++, to_string(step.operation), step.persistence,
              step.point[0], step.point[1], step.point[2], step.vertices, step.edges, step.cells);
    for (std::size_t i = 0; i < step.vanished.size(); ++i)
      out.print(FMT_COMPILE("{}{}"), i == 0 ? "" : " ", step.vanished[i]);
    out << "\n";
  }
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
