// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_DESCRIBE_PROGRAM_H
#define EXTREMAL_MESH_3_SRC_TOOL_DESCRIBE_PROGRAM_H

#include <string>

namespace CLI {
class App;
}

namespace CGAL::Extremal_mesh_3::tool {

/// makes the manual page, in roff, of what the command line knows: so that it cannot say anything else than --help.
std::string man_page(const CLI::App& app);

/// makes the script by which bash completes commands, options and their values.
std::string bash_completion(const CLI::App& app);

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_DESCRIBE_PROGRAM_H
