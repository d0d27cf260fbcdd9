// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line. CLI11 takes long to compile and is included here, in registration_commands.cpp, surface_commands.cpp and describe_program.cpp only.
#include "Progress_bar.h"
#include "commands.h"
#include "describe_program.h"
#include "memory_limit.h"
#include "registration_commands.h"
#include "surface_commands.h"

#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/select.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>
#include <system_error>

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

/// what -o writes.
constexpr const char* formats = "the graph (.graphml .json), its cells (.off), its lines (.obj .ply), all with the "
                                "surface (.vtp .glb .gltf), tables "
                                "(.vertices.csv .edges.csv .cells.csv), markups of 3D Slicer (.mrk.json), a page to "
                                "look at (.html), a picture (.png); "
                                "repeatable";

/// the options of all commands that write a mesh.
void add_outputs(CLI::App& command, tool::Output_options& options) {
  const auto option = [&](const std::string& name, auto& value, const std::string& type, const std::string& text) {
    return command.add_option(name, value, text)->type_name(type);
  };
  option("-o,--output", options.outputs, "FILE", formats)->allow_extra_args(false);
  option("--lines", options.lines, "FILE", "write the lines as coloured tubes (.off)");
  tool::add_look(command, options);
}

void add_extract(CLI::App& app, tool::Extract_options& options, std::function<int()>& run) {
  CLI::App* command =
      app.add_subcommand("extract", "extracts the extremal mesh of a surface f = 0, an image or a polygon mesh");
  command
      ->add_option("INPUT", options.input,
                   "an image: .nrrd .nhdr .mha .mhd .nii .nii.gz .vtk, a folder of DICOM slices or one of them; or a "
                   "mesh: .off .obj .ply .stl .om")
      ->type_name("");
  const auto option = [&](const std::string& name, auto& value, const std::string& type, const std::string& text) {
    return command->add_option(name, value, text)->type_name(type);
  };
  option("--formula", options.formula, "TEXT", "a function of x, y and z, negative inside");
  option("--box", options.box, "X0 Y0 Z0 X1 Y1 Z1", "formulas: where to look for the surface");
  option("--resolution", options.resolution, "N", "formulas: cubes across the longest side of the box (64)");
  option("--mesher", options.mesher, "grid|cgal",
         "formulas: polygons in the cubes, or triangles about as large by CGAL's mesher (grid)");
  option("--iso", options.iso, "VALUE", "images: the value on the surface");
  option("--sigma", options.sigma, "MM", "images: width of the Gaussian (the largest side of a voxel)");
  option("--radius", options.radius, "R",
         "meshes: the scale of the features looked for, in the mesh's unit (from its sampling and noise)");
  option("--rings", options.rings, "N", "meshes: instead of a radius, how many edges away neighbours are");
  option("--weld", options.weld, "LENGTH", "meshes: vertices so near to each other become one (0; STL: rounding)");
  command->add_flag("--largest", options.largest, "only the component of the surface with the largest area");
  option("--min-area", options.min_area, "AREA", "only components of at least this area, in the unit of the input");
  option("--cells", options.cells, "FILE",
         "write the surface cut along the lines, each polygon with its cell (.ply .off)");
  option("--surface", options.surface, "FILE", "write the polygonal surface used (.off)");
  option("--report", options.report, "FILE", "write counts and checks (.json)");
  add_outputs(*command, options);
  option("--max-level", options.max_level, "N", "how often a cell may be divided (20; images and meshes 8)");
  option("--max-line-level", options.max_line_level, "N",
         "the same where only the course of a line is uncertain (as --max-level; images 2)");
  option("--line-tolerance", options.line_tolerance, "LENGTH",
         "formulas and images: how far the lines may be from what is written of them (0: as the polygons make it)");
  option("--memory-limit", options.memory_limit, "SIZE",
         "end with an error rather than take more memory, such as 500M or 2G (what the machine has)");
  command->add_flag(
      "--certify", options.certify,
      "formulas: prove what cells hold, and count them (takes long); images: prove the surface's topology");
  command->footer("Example:\n  extremal_mesh extract --formula \"x^2/9+y^2/4+z^2-1\" --box -4 -3 -2 4 3 2 "
                  "-o ellipsoid.graphml -o ellipsoid.png\n"
                  "  extremal_mesh extract skull.nii.gz --iso 300 --sigma 1.5 -o skull.graphml --report skull.json\n"
                  "  extremal_mesh extract femur.off --radius 0.1 -o femur.graphml -o femur.png");
  command->callback([&] { run = [&] { return tool::extract(options); }; });
}

void add_simplify(CLI::App& app, tool::Simplify_options& options, std::function<int()>& run) {
  CLI::App* command = app.add_subcommand("simplify", "removes what is least persistent from an extremal mesh");
  command->add_option("GRAPH", options.file, "an extremal mesh (.graphml)")->required()->type_name("");
  const auto option = [&](const std::string& name, auto& value, const std::string& type, const std::string& text) {
    return command->add_option(name, value, text)->type_name(type);
  };
  option("--measure", options.measure, "NAME",
         "what a step costs: persistence, or life-time, which 'scale-space --graphs' tells");
  option("--threshold", options.threshold, "T", "do every step of at most this persistence, or life time");
  option("--cells", options.number_of_cells, "N", "until there are at most so many cells");
  option("--vertices", options.number_of_vertices, "N", "until there are at most so many vertices");
  option("--level", options.level, "L", "do so many steps");
  command->add_flag("--gap", options.gap, "until the greatest rise of the persistence from a step to the next");
  option("--keep-crest", options.keep_crest, "STRENGTH", "crest lines of at least this strength keep their course");
  option("--persistence", options.persistence, "FILE", "write the persistence diagram (.svg .png .csv)");
  option("--hierarchy", options.hierarchy, "FILE", "write all steps as a table (.csv)");
  option("--surface", options.patches, "FILE", "the cells of GRAPH as 'extract --cells' wrote them (.ply)");
  option("--patches", options.cells, "FILE",
         "write the surface with the cells that are left (.ply .off); needs --surface");
  add_outputs(*command, options);
  command->footer(
      "Example:\n  extremal_mesh simplify skull.graphml --cells 300 -o simple.graphml\n"
      "  extremal_mesh simplify skull.graphml --persistence diagram.svg --hierarchy steps.csv\n"
      "  extremal_mesh simplify skull.graphml --gap --surface cells.ply -o simple.png --patches simple.ply");
  command->callback([&] { run = [&] { return tool::simplify(options); }; });
}

void add_graph_command(CLI::App& app, const std::string& name, const std::string& description,
                       tool::Graph_options& options, int (*function)(const tool::Graph_options&),
                       std::function<int()>& run) {
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("GRAPH", options.file, "an extremal mesh (.graphml)")->required()->type_name("");
  command->add_flag("--json", options.json, "print one JSON object");
  command->footer(fmt::format("Example:\n  extremal_mesh {} ellipsoid.graphml --json", name));
  command->callback([&options, function, &run] { run = [&options, function] { return function(options); }; });
}

void add_view(CLI::App& app, tool::View_command_options& options, std::function<int()>& run) {
  CLI::App* command = app.add_subcommand("view", "makes a page that shows an extremal mesh in a browser, or a picture");
  command->add_option("GRAPH", options.file, "an extremal mesh (.graphml)")->required()->type_name("");
  command
      ->add_option("--surface", options.patches,
                   "the cells of GRAPH as 'extract --cells' wrote them (.ply); without them the lines are shown alone")
      ->type_name("FILE");
  const auto option = [&](const std::string& name, auto& value, const std::string& type, const std::string& text) {
    return command->add_option(name, value, text)->type_name(type);
  };
  option("-o,--output", options.outputs, "FILE", "a page that needs no network (.html), a picture (.png); repeatable")
      ->allow_extra_args(false);
  tool::add_look(*command, options);
  command->footer(
      "Example:\n  extremal_mesh view skull.graphml --surface cells.ply -o skull.html\n"
      "  extremal_mesh view skull.graphml --surface cells.ply -o skull.png --camera 0.5 1 -0.2 --size 1200x900");
  command->callback([&] { run = [&] { return tool::view(options); }; });
}

void add_convert(CLI::App& app, tool::View_command_options& options, std::function<int()>& run) {
  CLI::App* command = app.add_subcommand("convert", "writes an extremal mesh for other programs");
  command->add_option("GRAPH", options.file, "an extremal mesh (.graphml)")->required()->type_name("");
  command->add_option("OUT", options.converted, "the same as -o OUT")->type_name("");
  command
      ->add_option("--surface", options.patches,
                   "the cells of GRAPH as 'extract --cells' wrote them (.ply), for what shows the surface")
      ->type_name("FILE");
  add_outputs(*command, options);
  command->footer(
      "Example:\n  extremal_mesh convert skull.graphml --surface cells.ply -o skull.vtp -o skull.edges.csv");
  command->callback([&] {
    run = [&] {
      if (!options.converted.empty())
        options.outputs.insert(options.outputs.begin(), options.converted);
      return tool::convert(options);
    };
  });
}

void add_query(CLI::App& app, tool::Query_options& options, std::function<int()>& run) {
  CLI::App* command = app.add_subcommand("query", "answers one question about an extremal mesh, as a JSON object");
  command->add_option("GRAPH", options.file, "an extremal mesh (.graphml)")->required()->type_name("");
  const auto option = [&](const std::string& name, auto& value, const std::string& type, const std::string& text) {
    command->add_option(name, value, text)->type_name(type);
  };
  option("--cell-at", options.cell_at, "X Y Z", "the cell that holds a point of the surface");
  option("--surface", options.surface, "FILE",
         "with --cell-at: decide by the surface cut along the lines (.ply, as 'extract --cells' writes it)");
  option("--normal", options.normal, "NX NY NZ", "with --cell-at: the surface's normal there; ignores other sheets");
  option("--cell", options.cell, "CELL", "a cell, with its sides in order");
  option("--neighbours", options.neighbours, "CELL", "the cells beside a cell");
  option("--around", options.around, "VERTEX", "the branches of a vertex and the cells between them, in order");
  option("--line-through", options.line_through, "EDGE", "the line that an edge is part of");
  option("--strongest", options.strongest, "K", "the K strongest crest lines");
  option("--path", options.path, "V W", "the shortest way along the lines from one vertex to another");
  option("--nearest", options.nearest, "X Y Z", "the nearest vertex and the nearest point of the lines");
  option("--vertices", options.vertices, "KIND", "extremal_point, umbilic, non_generic, boundary, anchor or all");
  option("--edges", options.edges, "TYPE|FAMILY", "max_largest, min_largest, max_second, min_second, 1, 2 or all");
  for (std::size_t i = 0; i < options.min.size(); ++i) {
    const std::string measure(to_string(static_cast<Line_measure>(i)));
    std::string words = measure;
    std::replace(words.begin(), words.end(), '_', '-');
    option(fmt::format("--min-{}", words), options.min[i], "X", fmt::format("with --edges: least {}", measure));
    option(fmt::format("--max-{}", words), options.max[i], "X", fmt::format("with --edges: greatest {}", measure));
  }
  command->add_flag("--components", options.components, "the connected components of the graph");
  command->add_flag("--quads", options.quads, "the cells with four sides, and the order of their types");
  command->add_flag("--json", options.json, "print JSON, as it is done anyhow");
  command->footer("Example:\n  extremal_mesh query ellipsoid.graphml --cell-at 1.7 1.2 0.6\n"
                  "  extremal_mesh query skull.graphml --edges max_largest --min-strength 2");
  command->callback([&] { run = [&] { return tool::query(options); }; });
}

int tell(std::string message, int code) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "extremal_mesh: {}\n", message);
  return code;
}

constexpr const char* out_of_memory =
    "extremal_mesh: out of memory; try a coarser resolution or a smaller image, or allow more\n";

/// Destructors of nlohmann::json take memory: when there is none, no handler of exceptions is reached. Nothing is half written, as
/// outputs get their names last.
[[noreturn]] void end_without_memory() {
  try {
    if (const std::exception_ptr thrown = std::current_exception())
      std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    std::fputs(out_of_memory, stderr);
    std::_Exit(tool::failure);
  } catch (...) {
  }
  std::abort();
}

int run(int argc, char** argv) {
  CLI::App app("The extremal mesh of surfaces", "extremal_mesh");
  app.set_version_flag("--version", "extremal_mesh " EXTREMAL_MESH_3_VERSION);
  app.require_subcommand(0, 1); // that there is one is tested below, with a better message
  app.footer("'extremal_mesh COMMAND --help' tells more, with an example.");
  std::function<int()> command;
  tool::Extract_options extract_options;
  tool::Simplify_options simplify_options;
  tool::Graph_options graph_options;
  add_extract(app, extract_options, command);
  add_graph_command(app, "info", "counts what an extremal mesh consists of", graph_options, tool::info, command);
  add_graph_command(app, "check", "tests the identities of an extremal mesh; exit code 1 if one is violated",
                    graph_options, tool::check, command);
  add_simplify(app, simplify_options, command);
  tool::Query_options query_options;
  add_query(app, query_options, command);
  tool::View_command_options view_options;
  add_view(app, view_options, command);
  tool::View_command_options convert_options;
  add_convert(app, convert_options, command);
  tool::add_registration_commands(app, command);
  tool::add_surface_commands(app, command);
  bool print_man_page = false, print_completion = false;
  app.add_flag("--man-page", print_man_page)->group(""); // for the build; not shown
  app.add_flag("--bash-completion", print_completion)->group("");
  try {
    app.parse(arguments(argc, argv));
  } catch (const CLI::Success& success) { // help or version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return tell(fmt::format("{}; 'extremal_mesh --help' shows how to call it", error.what()), tool::usage);
  }
  if (print_man_page || print_completion)
    command = [&] {
      fmt::print("{}", print_man_page ? tool::man_page(app) : tool::bash_completion(app));
      return int(tool::success);
    };
  if (!command)
    return tell("there is no command; give extract, info, check, simplify, query, register, compare, landmarks, match, "
                "scale-space, segment, reduce, flatten, view or convert",
                tool::usage);
  const int code = command();
  if (std::fflush(stdout) != 0)
    return tell("the output cannot be written; is the disk full?", tool::failure);
  return code;
}

} // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_without_memory);
  std::signal(SIGXFSZ, SIG_IGN); // a file that gets larger than allowed is an error like a full disk
  try {
    return run(argc, argv);
  } catch (const tool::Usage_error& error) {
    return tell(error.what(), tool::usage);
  } catch (const std::invalid_argument& error) {
    return tell(error.what(), tool::usage);
  } catch (const Cancelled&) {
    return tell("interrupted; nothing was left half written", tool::signalled + tool::interrupting_signal());
  } catch (const std::bad_alloc&) {
    // not by tell(), which takes memory
    std::fputs(out_of_memory, stderr);
    return tool::failure;
  } catch (const std::system_error& error) {
    return tell(error.code() == std::errc::resource_unavailable_try_again
                    ? "no thread could be started; allow more memory, or threads"
                    : error.what(),
                tool::failure);
  } catch (const std::exception& error) {
    return tell(error.what(), tool::failure);
  }
}
