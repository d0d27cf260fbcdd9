// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "query_json.h"
#include "registration_commands.h"

#include <CGAL/Extremal_mesh_3/compare.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/register.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

void require_tolerance(const std::optional<double>& tolerance) {
  if (tolerance && !(std::isfinite(*tolerance) && *tolerance > 0))
    throw Usage_error(fmt::format("the tolerance is {}; give --tolerance a positive length", *tolerance));
}

Json matched_by_kind(const Registration& r, const Extremal_mesh& a) {
  std::size_t points = 0, umbilics = 0;
  for (const Matched_vertices& m : r.matched)
    ++(a.vertex(m.a).kind == Vertex_kind::umbilic ? umbilics : points);
  return {{"extremal_point", points}, {"umbilic", umbilics}};
}

Json json_of(const Registration& r, const Extremal_mesh& a) {
  const Registration_evidence& e = r.evidence;
  Json json = {{"found", r.found}};
  // No matrix that somebody could take for one where there is none.
  json["matrix"] = r.found ? Json(r.transform.matrix()) : Json();
  if (!r.found)
    json["reason"] = r.reason;
  json["tolerance"] = r.tolerance;
  if (r.found) {
    json["rotation_degrees"] = degrees * rotation_angle(r.transform);
    json["scale"] = r.transform.scale;
    json["mirror"] = r.transform.mirrors();
    json["normals_reversed"] = r.normals_reversed;
    json["matched"] = matched_by_kind(r, a);
    json["rms"] = r.rms;
    json["surface_rms"] = r.surface_rms;
    json["uncertainty"] = {{"rotation_degrees", degrees * r.rotation_error},
                           {"translation", r.translation_error},
                           {"centre", r.centre},
                           {"scale", r.scale_error}};
  }
  json["evidence"] = {{"vertices", e.vertices},
                      {"matched", e.matched},
                      {"chance", e.chance},
                      {"overlap", e.overlap},
                      {"on_surface", e.on_surface},
                      {"on_surface_by_chance", e.on_surface_by_chance},
                      {"log10_significance", e.log10_significance}};
  if (r.found) {
    json["alternatives"] = Json::array();
    for (const Similarity& s : r.alternatives)
      json["alternatives"].push_back(s.matrix());
    json["pairs"] = Json::array();
    for (const Matched_vertices& m : r.matched)
      json["pairs"].push_back(
          {{"a", m.a}, {"b", m.b}, {"kind", to_string(a.vertex(m.a).kind)}, {"distance", m.distance}});
  }
  return json;
}

std::string text_of(const Registration& r) {
  const Registration_evidence& e = r.evidence;
  std::string text;
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("{:<10} {}\n", name, value);
  };
  line("motion", fmt::format("turns by {:.4g} degrees{}{}", degrees * rotation_angle(r.transform),
                             r.transform.scale == 1 ? "" : fmt::format(", scales by {:.6g}", r.transform.scale),
                             r.transform.mirrors() ? ", mirrored" : ""));
  for (const auto& row : r.transform.matrix())
    line("", fmt::format("{:12.6f} {:12.6f} {:12.6f} {:12.6f}", row[0], row[1], row[2], row[3]));
  if (r.normals_reversed)
    line("normals", "reversed");
  line("error",
       fmt::format("{:.2g} degrees, {:.2g} of length (standard)", degrees * r.rotation_error, r.translation_error));
  line("evidence", fmt::format("{} of {} vertices match, {:.1f} % by chance; {:.1f} % of the lines lie on the other "
                               "surface; overlap {:.0f} %",
                               e.matched, e.vertices, 100 * e.chance, 100 * e.on_surface, 100 * e.overlap));
  line("residuals", fmt::format("vertices {:.4g}, surface {:.4g}", r.rms, r.surface_rms));
  if (!r.alternatives.empty())
    line("note", fmt::format("{} other motions fit nearly as well: the surface is symmetric", r.alternatives.size()));
  return text;
}

Similarity read_transform(const std::string& file) {
  std::ifstream in(file);
  if (!in)
    throw Io_error(fmt::format("'{}' cannot be read: is it there?", file));
  const Json json = Json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("matrix"))
    throw Io_error(fmt::format("'{}' is not what 'register -o' writes: an object with a \"matrix\" is expected", file));
  if (json["matrix"].is_null())
    throw Io_error(fmt::format("'{}' tells that no motion was found, so there is none to compare by", file));
  try {
    return similarity_of_matrix(json["matrix"].get<std::array<std::array<double, 4>, 4>>());
  } catch (const Json::exception&) {
    throw Io_error(fmt::format("'{}': \"matrix\" is not four rows of four numbers", file));
  } catch (const std::invalid_argument& error) {
    throw Io_error(fmt::format("'{}': {}", file, error.what()));
  }
}

} // namespace

int register_meshes(const Register_options& options) {
  require_tolerance(options.tolerance);
  if (!options.output.empty())
    check_writable(options.output);
  const Extremal_mesh a = read_graphml(options.a), b = read_graphml(options.b);
  Registration_options how;
  how.scale = options.scale;
  how.mirror = options.mirror;
  how.tolerance = options.tolerance.value_or(0);
  how.seed = options.seed;
  how.threads = options.threads;
  const Registration r = register_extremal_meshes(a, b, how);
  const std::string json = pretty(json_of(r, a)) + "\n";
  if (!options.output.empty())
    write_text_file(options.output, json);
  if (options.json)
    fmt::print("{}", json);
  if (!r.found) {
    fmt::print(stderr, "extremal_mesh: no motion takes '{}' to '{}': {}{}\n", options.a, options.b, r.reason,
               options.mirror ? "" : "; --mirror looks for a mirror image, too");
    return failure;
  }
  if (options.json || options.quiet)
    return success;
  Comparison_options comparison_options;
  comparison_options.transform = r.transform;
  comparison_options.tolerance = r.tolerance;
  comparison_options.threads = options.threads;
  fmt::print("{}{}", text_of(r), to_text(compare_extremal_meshes(a, b, comparison_options)));
  return success;
}

int compare(const Compare_options& options) {
  require_tolerance(options.tolerance);
  const auto ends_with = [](const std::string& file, const char* extension) { return file.ends_with(extension); };
  for (const std::string& file : options.outputs) {
    if (!ends_with(file, ".csv") && !ends_with(file, ".json") && !ends_with(file, ".txt"))
      throw Usage_error(fmt::format("the extension of '{}' is not known; give -o a .csv, a .json or a .txt", file));
    check_writable(file);
  }
  const Extremal_mesh a = read_graphml(options.a), b = read_graphml(options.b);
  Comparison_options how;
  how.tolerance = options.tolerance.value_or(0);
  how.threads = options.threads;
  if (!options.transform.empty())
    how.transform = read_transform(options.transform);
  const Comparison comparison = compare_extremal_meshes(a, b, how);
  for (const std::string& file : options.outputs)
    write_text_file(file, ends_with(file, ".csv")    ? to_csv(comparison)
                          : ends_with(file, ".json") ? to_json(comparison) + "\n"
                                                     : to_text(comparison));
  fmt::print("{}", options.json ? to_json(comparison) + "\n" : to_text(comparison));
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
