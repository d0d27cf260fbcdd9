// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_COMMANDS_H
#define EXTREMAL_MESH_3_SRC_TOOL_COMMANDS_H

#include <CGAL/Extremal_mesh_3/types.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// The program's commands. Each gives the exit code, or throws: `Usage_error` and `std::invalid_argument` where the
/// command line is wrong, what the library throws otherwise.
namespace CGAL::Extremal_mesh_3::tool {

/// Ended by signal s, the code is `signalled` + s, as the shell has it.
enum Exit_code { success = 0, failure = 1, usage = 2, signalled = 128 };

/// A command line that makes no sense. The message is one sentence that tells what to do.
class Usage_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Which files are to be written, and how.
struct Output_options {
  std::vector<std::string> outputs; ///< what they are follows from their extensions
  std::string lines, cells, surface, report;
  std::string show;    ///< in pictures: "all", "crest" or "surface"; empty: all
  std::string colour;  ///< of cells: "sign" or "cell"; empty: by sign
  Vector view{}, up{}; ///< zero: the renderer's own
  std::string size;    ///< "WIDTHxHEIGHT"; empty: the renderer's own
  int threads = 0;
  bool quiet = false;
  bool json = false; ///< print one JSON object instead of text
};

struct Extract_options : Output_options {
  std::string input; ///< an image or a mesh; empty if there is a formula
  std::optional<std::string> formula;
  std::optional<std::array<double, 6>> box;
  std::optional<std::int64_t> resolution;
  std::optional<std::string> mesher;
  std::optional<double> iso, sigma;
  std::optional<double> radius, weld;
  std::optional<int> rings;
  std::optional<int> max_level, max_line_level;
  std::optional<double> line_tolerance;
  bool largest = false; ///< of the surface's components
  std::optional<double> min_area;
  bool certify = false;
  std::string memory_limit; ///< such as "2G"; empty: what the machine has
};
int extract(const Extract_options& options);

struct Simplify_options : Output_options {
  std::string file;
  std::optional<double> threshold, keep_crest;
  std::string measure = "persistence"; ///< or `life-time`
  std::optional<std::int64_t> number_of_cells, number_of_vertices, level;
  bool gap = false;
  std::string patches;                ///< the given mesh's cells, as `extract --cells` writes them
  std::string persistence, hierarchy; ///< files
};
int simplify(const Simplify_options& options);

/// Pages and pictures of a graph.
struct View_command_options : Output_options {
  std::string file;
  std::string converted; ///< one more of `outputs`
  std::string patches;   ///< the given mesh's cells, as `extract --cells` writes them; empty: lines alone
};
int view(const View_command_options& options);
/// writes the graph as other files.
int convert(const View_command_options& options);

struct Graph_options {
  std::string file;
  bool json = false;
};
int info(const Graph_options& options);
int check(const Graph_options& options);

/// Exactly one question, and what belongs to it.
struct Query_options {
  std::string file;
  std::optional<std::array<double, 3>> cell_at, nearest;
  std::string surface;                         ///< of `cell_at`: the cut surface; empty: lines tell
  std::optional<std::array<double, 3>> normal; ///< of `cell_at`
  std::optional<std::int64_t> cell, neighbours, around, line_through, strongest;
  std::optional<std::array<std::int64_t, 2>> path;
  std::optional<std::string> vertices, edges;
  std::array<std::optional<double>, 6> min, max; ///< of `edges`, by `Line_measure`
  bool components = false, quads = false;
  bool json = false; ///< as it is anyhow
};
int query(const Query_options& options);

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_COMMANDS_H
