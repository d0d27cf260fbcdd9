// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Outputs.h"

#include "Progress_bar.h"
#include "summary_text.h"

#include <CGAL/Extremal_mesh_3/interchange.h>
#include <CGAL/Extremal_mesh_3/io.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z')
      c = char(c - 'A' + 'a');
  return text;
}

/// one number of "1600x1200".
int pixels(std::string_view text, std::string_view size) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 16 || number > 16384)
    throw Usage_error(fmt::format("'{}' is not a size of a picture; give --size WIDTHxHEIGHT with numbers of pixels "
                                  "from 16 to 16384",
                                  size));
  return number;
}

} // namespace

Outputs::Kind Outputs::kind_of(const std::string& file, Content content) {
  // longer endings come before those that they end in
  static constexpr std::pair<std::string_view, Kind> endings[] = {{".graphml", Kind::graphml},
                                                                  {".off", Kind::cell_polygons},
                                                                  {".png", Kind::picture},
                                                                  {".html", Kind::page},
                                                                  {".obj", Kind::obj},
                                                                  {".ply", Kind::lines_ply},
                                                                  {".vtp", Kind::vtp},
                                                                  {".glb", Kind::gltf},
                                                                  {".gltf", Kind::gltf},
                                                                  {".vertices.csv", Kind::vertices_csv},
                                                                  {".edges.csv", Kind::edges_csv},
                                                                  {".cells.csv", Kind::cells_csv},
                                                                  {".mrk.json", Kind::markups},
                                                                  {".json", Kind::json}};
  static constexpr std::pair<std::string_view, Kind> endings_of_surfaces[] = {
      {".ply", Kind::patches_ply}, {".off", Kind::patches_off}, {".vtp", Kind::vtp},    {".glb", Kind::gltf},
      {".gltf", Kind::gltf},       {".html", Kind::page},       {".png", Kind::picture}};
  const std::string name = lower_case(std::filesystem::path(file).filename().string());
  if (content == Content::surface) {
    for (const auto& [ending, kind] : endings_of_surfaces)
      if (name.ends_with(ending))
        return kind;
    throw Usage_error(
        fmt::format("the extension of '{}' is not known; give -o a .ply, .off, .vtp, .glb, .gltf, .html or "
                    ".png",
                    file));
  }
  for (const auto& [ending, kind] : endings)
    if (name.ends_with(ending))
      return kind;
  throw Usage_error(fmt::format("the extension of '{}' is not known; give -o a .graphml, .off, .obj, .ply, .vtp, .glb, "
                                ".gltf, .json, .mrk.json, .vertices.csv, .edges.csv, .cells.csv, .html or .png",
                                file));
}

Outputs::Outputs(const Output_options& options, Content content) {
  if (options.threads < 0)
    throw Usage_error(fmt::format("the number of threads is {}; give --threads 0 for all cores", options.threads));
  for (const std::string& file : options.outputs) {
    add(kind_of(file, content), file);
  }
  add(Kind::lines, options.lines);
  if (!options.cells.empty()) {
    const std::string extension = lower_case(std::filesystem::path(options.cells).extension().string());
    if (extension != ".off" && extension != ".ply")
      throw Usage_error(
          fmt::format("the extension of '{}' is not known; give an .off or a .ply for the cells", options.cells));
    add(extension == ".off" ? Kind::patches_off : Kind::patches_ply, options.cells);
  }
  add(Kind::surface, options.surface);
  add(Kind::report, options.report);

  if (options.colour == "cell")
    colouring_ = Cell_colouring::cell;
  else if (!options.colour.empty() && options.colour != "sign")
    throw Usage_error(fmt::format("'{}' is not a way to colour cells; give --colour sign or cell", options.colour));
  render_.colouring = colouring_;
  if (options.show == "crest")
    render_.lines = Shown_lines::crest;
  else if (options.show == "surface")
    render_.lines = Shown_lines::none;
  else if (!options.show.empty() && options.show != "all")
    throw Usage_error(fmt::format("'{}' cannot be shown; give --show all, crest or surface", options.show));
  if (!options.size.empty()) {
    const std::string_view size = options.size;
    const std::size_t cross = std::min(size.find('x'), size.size() - 1);
    render_.width = pixels(size.substr(0, cross), size);
    render_.height = pixels(size.substr(cross + 1), size);
  }
  render_.threads = options.threads;
  if (options.view != Vector{})
    render_.view = options.view;
  if (options.up != Vector{})
    render_.up = options.up;
  view_ = {render_.view, render_.up, colouring_};
}

void Outputs::add(Kind kind, const std::string& file) {
  if (file.empty())
    return;
  for (const Output& output : outputs_)
    if (output.file == file)
      throw Usage_error(fmt::format("two outputs are to be written to '{}'; give each its own file", file));
  check_writable(file);
  outputs_.push_back({kind, file});
}

void Outputs::reserve(const std::string& file) {
  add(Kind::other, file);
}

bool Outputs::need_patches() const {
  return std::any_of(outputs_.begin(), outputs_.end(), [](const Output& output) {
    return output.kind == Kind::picture || output.kind == Kind::page || output.kind == Kind::vtp ||
           output.kind == Kind::gltf || output.kind == Kind::patches_off || output.kind == Kind::patches_ply;
  });
}

bool Outputs::only_pictures() const {
  return std::all_of(outputs_.begin(), outputs_.end(),
                     [](const Output& output) { return output.kind == Kind::picture || output.kind == Kind::page; });
}

void Outputs::write(const Result& result) const {
  for (const Output& output : outputs_) {
    stop_if_interrupted();
    write(output, result);
  }
}

void Outputs::write(const Output& output, const Result& result) const {
  const Extraction& extraction = result.extraction;
  switch (output.kind) {
  case Kind::graphml:
    return write_graphml(output.file, extraction.mesh);
  case Kind::cell_polygons:
    return write_off(output.file, extraction.mesh, colouring_);
  case Kind::picture:
    return render_png(output.file, extraction.mesh, extraction.patches, render_);
  case Kind::page:
    return write_view(output.file, extraction.mesh, extraction.patches, view_);
  case Kind::obj:
    return write_obj(output.file, extraction.mesh);
  case Kind::lines_ply:
    return write_lines_ply(output.file, extraction.mesh);
  case Kind::vtp:
    return write_vtp(output.file, extraction.mesh, extraction.patches);
  case Kind::gltf:
    return write_gltf(output.file, extraction.mesh, extraction.patches);
  case Kind::vertices_csv:
    return write_vertices_csv(output.file, extraction.mesh);
  case Kind::edges_csv:
    return write_edges_csv(output.file, extraction.mesh);
  case Kind::cells_csv:
    return write_cells_csv(output.file, extraction.mesh);
  case Kind::json:
    return write_json(output.file, extraction.mesh);
  case Kind::markups:
    return write_markups(output.file, extraction.mesh);
  case Kind::lines:
    return write_lines_off(output.file, extraction.mesh);
  case Kind::patches_off:
    return write_off(output.file, extraction.patches, extraction.mesh, colouring_);
  case Kind::patches_ply:
    return write_ply(output.file, extraction.patches, extraction.mesh, colouring_);
  case Kind::surface:
    return write_off(output.file, result.surface);
  case Kind::report:
    return write_text_file(output.file, report_json(result) + "\n");
  case Kind::other:
    break;
  }
}

Cell_patches read_patches_of(const std::string& file, const Extremal_mesh& mesh, const std::string& graph) {
  if (file.empty())
    return {};
  Cell_patches patches = read_cell_patches(file);
  for (const std::uint32_t c : patches.cell)
    if (c >= mesh.number_of_cells())
      throw Io_error(fmt::format("'{}' is not of the mesh in '{}': it has a cell {}, the mesh has {} cells", file,
                                 graph, c, mesh.number_of_cells()));
  return patches;
}

} // namespace CGAL::Extremal_mesh_3::tool
