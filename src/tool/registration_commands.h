// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_REGISTRATION_COMMANDS_H
#define EXTREMAL_MESH_3_SRC_TOOL_REGISTRATION_COMMANDS_H

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace CGAL::Extremal_mesh_3::tool {

struct Register_options {
  std::string a, b, output;
  std::optional<double> tolerance;
  bool scale = false, mirror = false, json = false, quiet = false;
  unsigned seed = 1;
  int threads = 0;
};
/// \return `failure` if there is no motion
int register_meshes(const Register_options& options);

struct Compare_options {
  std::string a, b, transform;
  std::vector<std::string> outputs; ///< .csv, .json or .txt
  std::optional<double> tolerance;
  bool json = false;
  int threads = 0;
};
int compare(const Compare_options& options);

struct Landmarks_command_options {
  std::string file;
  std::vector<std::string> outputs; ///< .mrk.json or .csv
  std::optional<std::int64_t> most;
  bool umbilics = false, json = false;
};
int landmarks(const Landmarks_command_options& options);

struct Match_options {
  std::string file;
  std::vector<std::string> landmarks;
  std::optional<std::int64_t> most; ///< extremal points, and umbilics: the strongest
  std::string output;               ///< .csv
  bool json = false;
};
int match(const Match_options& options);

struct Scale_space_command_options {
  std::string file;
  double iso = 0;
  std::vector<double> sigmas;
  std::string output, events, plot, folder;
  std::optional<double> tolerance;
  int threads = 0;
  bool quiet = false, json = false;
};
int scale_space(const Scale_space_command_options& options);

/// adds the commands above to the program. The one that is called for is put into `run`.
void add_registration_commands(CLI::App& app, std::function<int()>& run);

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_REGISTRATION_COMMANDS_H
