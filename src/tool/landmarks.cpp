// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "query_json.h"
#include "registration_commands.h"

#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/landmarks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

std::size_t most_of(const std::optional<std::int64_t>& most) {
  if (most && *most < 1)
    throw Usage_error(fmt::format("the number of landmarks is {}; give --most a number of at least 1", *most));
  return most ? std::size_t(*most) : Landmark_options().most;
}

/// Distances to the nearest of one sort, over all landmarks.
struct Distances {
  const char* sort;
  std::vector<double> values, by_chance;

  double quantile(double q) const {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    return sorted[std::size_t(q * double(sorted.size() - 1) + 0.5)];
  }
  static double mean(const std::vector<double>& all) {
    double sum = 0;
    for (const double x : all)
      sum += x / double(all.size());
    return sum;
  }
  /// how many landmarks are nearer than points around them are in the mean.
  double nearer_than_chance() const {
    double n = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      n += values[i] < by_chance[i] ? 1 : 0;
    return n / double(values.size());
  }
};

std::array<Distances, 4> distances_of(const std::vector<Landmark_match>& matches) {
  std::array<Distances, 4> all{
      {{"extremal_point", {}, {}}, {"umbilic", {}, {}}, {"line", {}, {}}, {"crest_line", {}, {}}}};
  for (const Landmark_match& m : matches) {
    const std::array<double, 4> d{m.to_extremal_point, m.to_umbilic, m.to_line, m.to_crest_line};
    const std::array<double, 4> c{m.chance_extremal_point, m.chance_umbilic, m.chance_line, m.chance_crest_line};
    for (std::size_t i = 0; i < all.size(); ++i)
      if (std::isfinite(d[i])) {
        all[i].values.push_back(d[i]);
        all[i].by_chance.push_back(c[i]);
      }
  }
  return all;
}

} // namespace

int landmarks(const Landmarks_command_options& options) {
  Landmark_options what;
  what.most = most_of(options.most);
  what.umbilics = options.umbilics;
  if (options.outputs.empty() && !options.json)
    throw Usage_error("there is nothing to write; give -o FILE.mrk.json or -o FILE.csv, or --json");
  for (const std::string& file : options.outputs) {
    if (!file.ends_with(".json") && !file.ends_with(".csv"))
      throw Usage_error(fmt::format("the extension of '{}' is not known; give -o a .mrk.json or a .csv", file));
    check_writable(file);
  }
  const Extremal_mesh mesh = read_graphml(options.file);
  const std::vector<Landmark> found = strongest_landmarks(mesh, what);
  for (const std::string& file : options.outputs)
    file.ends_with(".csv") ? write_landmarks_csv(file, mesh, found) : write_markups(file, mesh, found);
  if (options.json) {
    Json list = Json::array();
    for (const Landmark& landmark : found)
      list.push_back({{"id", landmark.id},
                      {"kind", to_string(mesh.vertex(landmark.vertex).kind)},
                      {"vertex", landmark.vertex},
                      {"point", mesh.vertex(landmark.vertex).point},
                      {"persistence", landmark.persistence}, // infinity becomes null
                      {"strength", landmark.strength}});
    fmt::print("{}\n", pretty({{"landmarks", std::move(list)}}));
    return success;
  }
  fmt::print("{:<10} {}\n", "landmarks", found.size());
  return success;
}

int match(const Match_options& options) {
  Landmark_options what;
  what.most = most_of(options.most);
  what.umbilics = true;
  if (!options.output.empty()) {
    if (!options.output.ends_with(".csv"))
      throw Usage_error(fmt::format("the extension of '{}' is not known; give -o a .csv", options.output));
    check_writable(options.output);
  }
  const Extremal_mesh mesh = read_graphml(options.file);
  std::vector<Given_landmark> given;
  for (const std::string& file : options.landmarks) {
    const std::vector<Given_landmark> some = read_landmarks(file);
    given.insert(given.end(), some.begin(), some.end());
  }
  std::vector<Landmark> among;
  if (options.most)
    among = strongest_landmarks(mesh, what);
  const std::vector<Landmark_match> matches = match_landmarks(mesh, given, among);
  if (!options.output.empty()) {
    std::string csv = "label,x,y,z,extremal_point,distance,umbilic,distance,line,distance,crest_line,distance\n";
    for (std::size_t i = 0; i < given.size(); ++i) {
      const Landmark_match& m = matches[i];
      csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", given[i].label, fmt::join(given[i].point, ","),
                         m.extremal_point, m.to_extremal_point, m.umbilic, m.to_umbilic, m.line, m.to_line,
                         fmt::format("{},{}", m.crest_line, m.to_crest_line));
    }
    write_text_file(options.output, csv);
  }
  const std::array<Distances, 4> all = distances_of(matches);
  if (options.json) {
    Json json = {{"landmarks", given.size()}};
    for (const Distances& d : all)
      if (!d.values.empty())
        json[d.sort] = {{"mean", Distances::mean(d.values)},
                        {"median", d.quantile(0.5)},
                        {"ninety_percent", d.quantile(0.9)},
                        {"greatest", d.quantile(1)},
                        {"mean_by_chance", Distances::mean(d.by_chance)},
                        {"nearer_than_chance", d.nearer_than_chance()}};
    fmt::print("{}\n", pretty(json));
    return success;
  }
  fmt::print("{} landmarks; distance to the nearest\n", given.size());
  fmt::print("{:<16} {:>9} {:>9} {:>9} {:>9} {:>12} {:>14}\n", "", "mean", "median", "90 %", "greatest", "by chance",
             "nearer, % of");
  for (const Distances& d : all)
    if (!d.values.empty())
      fmt::print("{:<16} {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g} {:>12.4g} {:>14.0f}\n", d.sort, Distances::mean(d.values),
                 d.quantile(0.5), d.quantile(0.9), d.quantile(1), Distances::mean(d.by_chance),
                 100 * d.nearer_than_chance());
  return success;
}

} // namespace CGAL::Extremal_mesh_3::tool
