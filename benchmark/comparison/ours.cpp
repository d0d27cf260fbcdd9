// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   ours shapes FILE.mha      smoothing, polygonal cells, and k, t, e and Φ at all their vertices
//   ours cells FILE.mha       the polygonal cells of the smoothed volume alone
//   ours mesh FILE.mha        smoothing, cells, the extremal mesh
//   ours accuracy             the error of third derivatives between the nodes
//   ours jets RINGS FILE.off  jets at the vertices of a mesh
//   ours fit FILE.off         the errors of k and e that these jets have, with two rings
//   ours write VERTICES FILE.graphml OUT.graphml   a graph of so many vertices, made of copies of a given one
//   ours read FILE.graphml
//
// The volume in memory already; one thread, or as many as a last argument says.
#include "Ellipsoid.h"
#include "Measurement.h"
#include "Waves.h"

#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>

#include <string>
#include <vector>

using namespace CGAL::Extremal_mesh_3;

namespace {

double sum; // printed at the end, so that no work can be left out

Image_function_options smoothing(int threads) {
  Image_function_options options;
  options.iso = 500;
  options.sigma = Waves::sigma;
  options.threads = threads;
  return options;
}

Extraction_options extraction(int threads) {
  Extraction_options options;
  options.threads = threads;
  options.max_level = 8; // what the program takes for images
  options.max_line_level = 2;
  return options;
}

void shapes(const std::string& file, int threads) {
  Image image = read_image(file);
  std::size_t vertices = 0;
  const double seconds = seconds_of([&] {
    const Image_function f(std::move(image), smoothing(threads));
    const Cell_complex cells = make_implicit_cells(f, f.lattice(), extraction(threads));
    vertices = cells.points.size();
    std::vector<Principal_quantities> found;
    found.reserve(vertices);
    Derivatives d;
    for (const Point& p : cells.points) {
      f.derivatives(p, 3, d);
      const Local_shape shape = local_shape(d);
      found.push_back(principal_quantities(shape));
      sum += shape.Phi().real();
    }
    sum += found.back().e1;
  });
  report(seconds, vertices);
}

void cells(const std::string& file, int threads) {
  const Image_function f(read_image(file), smoothing(threads));
  std::size_t vertices = 0;
  const double seconds =
      seconds_of([&] { vertices = make_implicit_cells(f, f.lattice(), extraction(threads)).points.size(); });
  report(seconds, vertices);
}

void mesh(const std::string& file, int threads) {
  Image image = read_image(file);
  std::size_t points = 0;
  const double seconds = seconds_of([&] {
    const Image_function f(std::move(image), smoothing(threads));
    points = extract_extremal_mesh(f, f.lattice(), extraction(threads)).report.surface_points;
  });
  report(seconds, points);
}

void accuracy() {
  const Waves waves;
  constexpr std::size_t n = Waves::size, margin = Waves::margin;
  Image_function_options options = smoothing(1);
  options.iso = 0;
  const std::vector<float> voxels = waves.voxels();
  const Image_function f({{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {n, n, n}}, {voxels.begin(), voxels.end()}},
                         options);
  Relative_error error;
  Derivatives d;
  for (std::size_t k = margin; k < n - margin; ++k)
    for (std::size_t j = margin; j < n - margin; ++j)
      for (std::size_t i = margin; i < n - margin; ++i) {
        const Point p{double(i) + 0.3, double(j) + 0.4, double(k) + 0.1};
        f.derivatives(p, 3, d);
        for (std::size_t t = 0; t < 10; ++t)
          error.add(-d.third[t], waves.derivative(p, Waves::third[t]));
      }
  report_error(error.value());
}

Fit fit_of(const Cell_complex& cells, int rings, int threads) {
  Fit_options options;
  options.rings = rings;
  options.threads = threads;
  return fit_vertex_shapes(cells, options);
}

void jets(int rings, const std::string& file, int threads) {
  const Cell_complex cells = read_mesh(file).cells;
  const double seconds = seconds_of([&] {
    const Fit fit = fit_of(cells, rings, threads);
    for (const Local_shape& s : fit.shapes.shapes)
      sum += principal_quantities(s).e1;
  });
  report(seconds, cells.points.size());
}

void fit(const std::string& file) {
  const Cell_complex cells = read_mesh(file).cells;
  const Fit fit = fit_of(cells, 2, 1);
  Ellipsoid_errors errors;
  for (std::size_t v = 0; v < cells.points.size(); ++v)
    errors.add(cells.points[v], principal_quantities(fit.shapes.shapes[v]));
  errors.report();
}

void write(std::size_t vertices, const std::string& in, const std::string& out) {
  const Extremal_mesh mesh = read_graphml(in);
  const std::size_t copies = (vertices + mesh.number_of_vertices() - 1) / mesh.number_of_vertices();
  std::vector<Extremal_mesh_vertex> many_vertices;
  std::vector<Extremal_mesh_edge> many_edges;
  std::vector<Extremal_mesh_cell> many_cells;
  for (std::size_t copy = 0; copy < copies; ++copy) {
    const auto of_copy = [&](std::size_t number) { return std::uint32_t(copy * number); };
    const std::uint32_t v0 = of_copy(mesh.number_of_vertices()), e0 = of_copy(mesh.number_of_edges()),
                        c0 = of_copy(mesh.number_of_cells());
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      for (Half_edge& h : many_vertices.emplace_back(mesh.vertex(v)).star)
        h += 2 * e0;
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
      Extremal_mesh_edge& edge = many_edges.emplace_back(mesh.edge(e));
      edge.id += e0;
      edge.source += v0;
      edge.target += v0;
      edge.left_cell += c0;
      edge.right_cell += c0;
    }
    for (const Extremal_mesh_cell& cell : mesh.cells())
      for (auto& walk : many_cells.emplace_back(cell).boundary)
        for (Half_edge& h : walk)
          h += 2 * e0;
  }
  const Extremal_mesh many(std::move(many_vertices), std::move(many_edges), std::move(many_cells), mesh.surface());
  report(seconds_of([&] { write_graphml(out, many); }), many.number_of_vertices());
}

void read(const std::string& file) {
  std::size_t vertices = 0;
  const double seconds = seconds_of([&] { vertices = read_graphml(file).number_of_vertices(); });
  report(seconds, vertices);
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::string task = arguments.empty() ? "" : arguments[0];
  const auto threads = [&](std::size_t i) { return arguments.size() > i ? std::stoi(arguments[i]) : 1; };
  if (task == "shapes" && arguments.size() >= 2)
    shapes(arguments[1], threads(2));
  else if (task == "cells" && arguments.size() >= 2)
    cells(arguments[1], threads(2));
  else if (task == "mesh" && arguments.size() >= 2)
    mesh(arguments[1], threads(2));
  else if (task == "accuracy")
    accuracy();
  else if (task == "jets" && arguments.size() >= 3)
    jets(std::stoi(arguments[1]), arguments[2], threads(3));
  else if (task == "fit" && arguments.size() == 2)
    fit(arguments[1]);
  else if (task == "write" && arguments.size() == 4)
    write(std::stoul(arguments[1]), arguments[2], arguments[3]);
  else if (task == "read" && arguments.size() == 2)
    read(arguments[1]);
  else
    return 2;
  return sum == 0.125 ? 3 : 0;
}
