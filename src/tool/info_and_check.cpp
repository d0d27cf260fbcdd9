// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "summary_text.h"

#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/summary.h>

#include <fmt/format.h>

namespace CGAL::Extremal_mesh_3::tool {

int info(const Graph_options& options) {
  const Extremal_mesh mesh = read_graphml(options.file);
  const std::vector<Check> checks = Extremal_mesh_3::check(mesh);
  if (options.json) {
    fmt::print("{}\n", to_json(mesh, checks));
    return success;
  }
  if (!mesh.surface().source.empty())
    fmt::print("{:<10} {}\n", "source", mesh.surface().source);
  if (!mesh.surface().parameters.empty())
    fmt::print("{:<10} {}\n", "made by", mesh.surface().parameters);
  fmt::print("{}", summary_text(mesh, checks, nullptr));
  return success;
}

int check(const Graph_options& options) {
  const Extremal_mesh mesh = read_graphml(options.file);
  const std::vector<Check> checks = Extremal_mesh_3::check(mesh);
  fmt::print("{}", options.json ? to_json(mesh, checks) + "\n" : checks_text(checks));
  return all_hold(checks) ? success : failure;
}

} // namespace CGAL::Extremal_mesh_3::tool
