// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The persistence diagram and the table of all steps tell what the simplification does.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/persistence_diagram.h>

#include "../src/io/Xml_reader.h"
#include "surfaces.h"
#include "temporary_folder.h"

#include <charconv>
#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

const Simplification& simplification() {
  // A bent ellipsoid with small waves on it.
  static const Simplification result(
      extract_extremal_mesh(Formula("x^2/4+y^2/2+z^2-1+0.02*x^2*y+0.004*sin(7*x)*cos(8*y+1)+0.003*sin(9*z+5*x)"),
                            make_lattice({-2.3, -1.6, -1.2}, {2.3, 1.6, 1.2}, 40))
          .mesh);
  return result;
}

std::vector<std::vector<std::string>> table_in(const std::string& file) {
  std::vector<std::vector<std::string>> table;
  std::istringstream in(read_text(file));
  for (std::string line; std::getline(in, line);) {
    table.emplace_back(1);
    for (const char c : line)
      if (c == ',')
        table.back().emplace_back();
      else
        table.back().back() += c;
  }
  return table;
}

double number(const std::string& text) {
  double value = 0;
  EXPECT_EQ(std::from_chars(text.data(), text.data() + text.size(), value).ptr, text.data() + text.size()) << text;
  return value;
}

/// What there is in an SVG.
struct Svg {
  struct Dot {
    double x, y;
    std::string operation;
  };
  std::vector<Dot> dots;
  std::string texts;
  std::size_t bands = 0, dashed_lines = 0;

  explicit Svg(const std::string& file) {
    const std::string content = read_text(file);
    Xml_reader reader(file, content);
    std::string group;
    for (auto tag = reader.next(); tag != Xml_reader::Tag::end_of_text; tag = reader.next()) {
      const std::string name(reader.name());
      if (tag == Xml_reader::Tag::end) {
        if (name == "text")
          texts += std::string(reader.text()) + '\n';
        continue;
      }
      if (name == "g")
        group = reader.attribute("id");
      else if (name == "circle")
        dots.push_back(
            {number(std::string(reader.attribute("cx"))), number(std::string(reader.attribute("cy"))), group});
      else if (name == "line")
        dashed_lines += !reader.attribute("stroke-dasharray").empty();
      else if (name == "rect")
        bands += !reader.attribute("x").empty() && number(std::string(reader.attribute("width"))) > 400;
    }
  }
  bool tells(const std::string& text) const { return texts.find(text) != texts.npos; }
};

} // namespace

TEST(Persistence_diagram, has_a_colour_for_each_operation) {
  const Temporary_folder folder;
  write_persistence_diagram(folder.file("diagram.svg"), simplification(), 0);
  const std::string content = read_text(folder.file("diagram.svg"));
  std::set<std::string> operations, colours;
  for (std::size_t at = 0; (at = content.find("<g id=\"", at)) != content.npos; ++at) {
    const std::size_t name = at + 7, fill = content.find("fill=\"", at) + 6;
    operations.insert(content.substr(name, content.find('"', name) - name));
    colours.insert(content.substr(fill, 7));
  }
  EXPECT_GE(operations.size(), 2U);
  EXPECT_EQ(colours.size(), operations.size());
}

TEST(Persistence_diagram, has_a_dot_per_step_where_it_belongs) {
  const Temporary_folder folder;
  const auto& steps = simplification().steps();
  ASSERT_GT(steps.size(), 20U);
  write_persistence_diagram(folder.file("diagram.svg"), simplification(), 3);
  const Svg svg(folder.file("diagram.svg"));
  ASSERT_EQ(svg.dots.size(), steps.size());

  // Dots are grouped by operation, within a group in the order of the steps.
  std::map<std::string, std::vector<const Simplification_step*>> of_operation;
  for (const Simplification_step& step : steps)
    of_operation[std::string(to_string(step.operation))].push_back(&step);
  std::map<std::string, std::size_t> met;
  std::vector<std::pair<const Simplification_step*, Svg::Dot>> all;
  for (const Svg::Dot& dot : svg.dots) {
    ASSERT_TRUE(of_operation.count(dot.operation)) << dot.operation;
    all.push_back({of_operation[dot.operation].at(met[dot.operation]++), dot});
  }
  for (const auto& [step, dot] : all)
    for (const auto& [other, its_dot] : all) {
      // SVG's y is downwards; coordinates have two decimals.
      if (step->vertices < other->vertices) {
        EXPECT_LE(dot.x, its_dot.x);
      }
      if (step->persistence < other->persistence) {
        EXPECT_GE(dot.y, its_dot.y);
      }
      if (double(step->vertices) < 0.95 * double(other->vertices)) {
        EXPECT_LT(dot.x, its_dot.x);
      }
      if (1e-6 * steps.back().persistence < step->persistence && step->persistence < 0.9 * other->persistence) {
        EXPECT_GT(dot.y, its_dot.y);
      }
    }
}

TEST(Persistence_diagram, marks_the_gap_and_the_chosen_level_and_tells_what_its_axes_are) {
  const Temporary_folder folder;
  const auto& steps = simplification().steps();
  const std::size_t gap = simplification().level_at_gap();
  for (const std::size_t level : {std::size_t(0), gap, steps.size()}) {
    write_persistence_diagram(folder.file("diagram.svg"), simplification(), level);
    const Svg svg(folder.file("diagram.svg"));
    EXPECT_EQ(svg.bands, 1U);
    EXPECT_EQ(svg.dashed_lines, 1U);
    EXPECT_TRUE(svg.tells("gap at level " + std::to_string(gap) + ": ")) << svg.texts;
    EXPECT_TRUE(
        svg.tells("chosen level " + std::to_string(level) +
                  (level > 0 ? ": " + std::to_string(steps[level - 1].vertices) + " vertices" : ": nothing done")))
        << svg.texts;
    EXPECT_TRUE(svg.tells("vertices left after the step"));
    EXPECT_TRUE(svg.tells("persistence: change of a curvature times the root of the area (no unit)"));
    EXPECT_TRUE(svg.tells(" cancel extremal points"));
  }
}

TEST(Persistence_diagram, as_a_table_has_the_numbers_themselves) {
  const Temporary_folder folder;
  const auto& steps = simplification().steps();
  const std::size_t gap = simplification().level_at_gap(), level = steps.size() / 2;
  write_persistence_diagram(folder.file("diagram.CSV"), simplification(), level);
  const auto table = table_in(folder.file("diagram.CSV"));
  ASSERT_EQ(table.size(), steps.size() + 1);
  EXPECT_EQ(table[0], (std::vector<std::string>{"level", "vertices", "persistence", "operation", "done", "below_gap"}));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto& row = table[i + 1];
    ASSERT_EQ(row.size(), 6U);
    EXPECT_EQ(number(row[0]), double(i + 1));
    EXPECT_EQ(number(row[1]), double(steps[i].vertices));
    EXPECT_EQ(number(row[2]), steps[i].persistence);
    EXPECT_EQ(row[3], to_string(steps[i].operation));
    EXPECT_EQ(row[4], i < level ? "1" : "0");
    EXPECT_EQ(row[5], i < gap ? "1" : "0");
  }
}

TEST(Persistence_diagram, as_a_picture_shows_every_operation) {
  const Temporary_folder folder;
  write_persistence_diagram(folder.file("a.png"), simplification(), 5);
  write_persistence_diagram(folder.file("b.png"), simplification(), 5);
  const std::string picture = read_text(folder.file("a.png"));
  EXPECT_TRUE(picture.starts_with("\x89PNG"));
  EXPECT_EQ(picture, read_text(folder.file("b.png")));
  write_persistence_diagram(folder.file("b.png"), simplification(), simplification().steps().size());
  EXPECT_NE(picture, read_text(folder.file("b.png"))); // the mark is elsewhere
}

TEST(Persistence_diagram, of_a_mesh_that_cannot_be_simplified_is_empty) {
  const Temporary_folder folder;
  const Simplification none{Extremal_mesh()};
  ASSERT_TRUE(none.steps().empty());
  for (const std::string extension : {"svg", "png", "csv"})
    write_persistence_diagram(folder.file("diagram." + extension), none, 0);
  const Svg svg(folder.file("diagram.svg"));
  EXPECT_TRUE(svg.dots.empty());
  EXPECT_TRUE(svg.tells("no step"));
  EXPECT_EQ(table_in(folder.file("diagram.csv")).size(), 1U);
}

TEST(Persistence_diagram, is_refused_for_unknown_formats_and_levels) {
  const Temporary_folder folder;
  EXPECT_THROW(write_persistence_diagram(folder.file("diagram.pdf"), simplification(), 0), std::invalid_argument);
  EXPECT_THROW(
      write_persistence_diagram(folder.file("diagram.svg"), simplification(), simplification().steps().size() + 1),
      std::out_of_range);
  EXPECT_THROW(write_persistence_diagram(folder.file("none/diagram.svg"), simplification(), 0), Io_error);
  EXPECT_EQ(folder.number_of_files(), 0U);
}

TEST(Hierarchy, is_a_table_whose_numbers_read_back_to_the_same_bits) {
  const Temporary_folder folder;
  const auto& steps = simplification().steps();
  write_hierarchy(folder.file("steps.csv"), simplification());
  const auto table = table_in(folder.file("steps.csv"));
  ASSERT_EQ(table.size(), steps.size() + 1);
  EXPECT_EQ(table[0], (std::vector<std::string>{"level", "operation", "persistence", "x", "y", "z", "vertices", "edges",
                                                "cells", "vanished"}));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto& row = table[i + 1];
    ASSERT_EQ(row.size(), 10U);
    EXPECT_EQ(number(row[0]), double(i + 1));
    EXPECT_EQ(row[1], to_string(steps[i].operation));
    EXPECT_EQ(number(row[2]), steps[i].persistence);
    EXPECT_EQ((Point{number(row[3]), number(row[4]), number(row[5])}), steps[i].point);
    EXPECT_EQ(number(row[6]), double(steps[i].vertices));
    EXPECT_EQ(number(row[7]), double(steps[i].edges));
    EXPECT_EQ(number(row[8]), double(steps[i].cells));
    std::istringstream words(row[9]);
    std::vector<std::uint32_t> vanished;
    for (std::uint32_t v = 0; words >> v;)
      vanished.push_back(v);
    EXPECT_EQ(vanished, steps[i].vanished);
    // ... and tells of the meshes themselves.
    if (i % 8 == 0) {
      const Extremal_mesh mesh = simplification().mesh_at(i + 1);
      EXPECT_EQ(number(row[6]), double(mesh.number_of_vertices()));
      EXPECT_EQ(number(row[7]), double(mesh.number_of_edges()));
      EXPECT_EQ(number(row[8]), double(mesh.number_of_cells()));
    }
  }
}
