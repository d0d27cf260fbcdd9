// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line. CLI11 takes long to compile and is included here only.
#include "commands.h"

#include <CGAL/Extremal_mesh_3/errors.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <new>

namespace {

using namespace CGAL::Extremal_mesh_3;

/// what the shell gave, with what CLI11 would take for options told apart: a formula may begin with a minus, a number
/// with "-.".
std::vector<std::string> arguments(int argc, char** argv) {
  std::vector<std::string> result;
  for (int i = 1; i < argc; ++i) {
    std::string argument = argv[i];
    if (argument == "--formula" && i + 1 < argc)
      argument += std::string("=") + argv[++i];
    else if (argument.starts_with("-.") && argument.size() > 2 && argument[2] >= '0' && argument[2] <= '9')
      argument.insert(1, "0");
    result.push_back(std::move(argument));
  }
  std::reverse(result.begin(), result.end()); // as CLI11 wants them
  return result;
}

void add_extract(CLI::App& app, tool::Extract_options& options, std::function<int()>& run) {
  CLI::App* command = app.add_subcommand("extract", "extracts the extremal mesh of a surface f = 0 or of an image");
  command->add_option("INPUT", options.input, "an image: .nrrd .nhdr .mha .mhd .nii .nii.gz .vtk");
  command->add_option("--formula", options.formula, "a function of x, y and z, negative inside");
  command->add_option("--box", options.box, "x0 y0 z0 x1 y1 z1: where to look for the surface");
  command->add_option("--resolution", options.resolution, "cubes across the longest side of the box (64)");
  command->add_option("--iso", options.iso, "the value of the image on the surface");
  command->add_option("--sigma", options.sigma, "width of the Gaussian in mm (the largest side of a voxel)");
  command->add_option("-o,--output", options.outputs, "the graph (.graphml), its cells (.off), a picture (.png)")
      ->allow_extra_args(false);
  command->add_option("--lines", options.lines, "write the lines as coloured tubes (.off)");
  command->add_option("--cells", options.cells, "write the surface cut along the lines, coloured by cell (.off)");
  command->add_option("--surface", options.surface, "write the polygonal surface used (.off)");
  command->add_option("--report", options.report, "write counts and checks (.json)");
  command->add_option("--view", options.view, "DX DY DZ: the direction of sight of the picture");
  command->add_option("--size", options.size, "WIDTHxHEIGHT of the picture in pixels (1600x1200)");
  command->add_option("--threads", options.threads, "0: as many as there are cores (0)");
  command->add_option("--max-level", options.max_level, "how often a cell may be divided (8)");
  command->add_flag("--quiet", options.quiet, "print errors only");
  command->footer("Example:\n  extremal_mesh extract --formula \"x^2/9+y^2/4+z^2-1\" --box -4 -3 -2 4 3 2 "
                  "-o ellipsoid.graphml -o ellipsoid.png\n"
                  "  extremal_mesh extract skull.nii.gz --iso 300 --sigma 1.5 -o skull.graphml --report skull.json");
  command->callback([&] { run = [&] { return tool::extract(options); }; });
}

void add_graph_command(CLI::App& app, const std::string& name, const std::string& description,
                       tool::Graph_options& options, int (*function)(const tool::Graph_options&),
                       std::function<int()>& run) {
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("GRAPH", options.file, "an extremal mesh (.graphml)")->required();
  command->add_flag("--json", options.json, "print one JSON object");
  command->footer(fmt::format("Example:\n  extremal_mesh {} ellipsoid.graphml --json", name));
  command->callback([&options, function, &run] { run = [&options, function] { return function(options); }; });
}

int tell(std::string message, int code) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "extremal_mesh: {}\n", message);
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("The extremal mesh of surfaces", "extremal_mesh");
  app.set_version_flag("--version", "extremal_mesh " EXTREMAL_MESH_3_VERSION);
  app.require_subcommand(1);
  app.footer("'extremal_mesh COMMAND --help' tells more, with an example.");
  std::function<int()> command;
  tool::Extract_options extract_options;
  tool::Graph_options graph_options;
  add_extract(app, extract_options, command);
  add_graph_command(app, "info", "counts what an extremal mesh consists of", graph_options, tool::info, command);
  add_graph_command(app, "check", "tests the identities of an extremal mesh; exit code 1 if one is violated",
                    graph_options, tool::check, command);
  try {
    app.parse(arguments(argc, argv));
  } catch (const CLI::Success& success) { // help or version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return tell(fmt::format("{}; 'extremal_mesh --help' shows how to call it", error.what()), tool::usage);
  }
  const int code = command();
  if (std::fflush(stdout) != 0)
    return tell("the output cannot be written; is the disk full?", tool::failure);
  return code;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const tool::Usage_error& error) {
    return tell(error.what(), tool::usage);
  } catch (const std::invalid_argument& error) {
    return tell(error.what(), tool::usage);
  } catch (const Cancelled&) {
    return tell("interrupted; nothing was left half written", tool::interrupted);
  } catch (const std::bad_alloc&) {
    return tell("out of memory; try a coarser resolution or a smaller image", tool::failure);
  } catch (const std::exception& error) {
    return tell(error.what(), tool::failure);
  }
}
