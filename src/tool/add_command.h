// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_ADD_COMMAND_H
#define EXTREMAL_MESH_3_SRC_TOOL_ADD_COMMAND_H

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

inline constexpr const char* graph_argument = "an extremal mesh (.graphml)";

/// adds an option, or an argument, with the type that the help tells.
template <class Value>
CLI::Option* option(CLI::App* command, const char* name, Value& value, const char* type, const char* text) {
  return command->add_option(name, value, text)->type_name(type);
}

/// a command whose options live as long as the program, and are those of `function`.
template <class Options>
std::pair<CLI::App*, std::shared_ptr<Options>> command(CLI::App& app, const char* name, const char* description,
                                                       int (*function)(const Options&), std::function<int()>& run) {
  auto options = std::make_shared<Options>();
  CLI::App* added = app.add_subcommand(name, description);
  added->callback([options, function, &run] { run = [options, function] { return function(*options); }; });
  return {added, options};
}

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_ADD_COMMAND_H
