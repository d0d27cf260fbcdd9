// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The compiled core of the Python module: plain functions on arrays. What users call is in extremal_mesh/__init__.py.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Functor_function.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/interchange.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/register.h>
#include <CGAL/Extremal_mesh_3/simplify.h>
#include <CGAL/Extremal_mesh_3/view.h>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <optional>

namespace py = pybind11;
using namespace CGAL::Extremal_mesh_3;
using namespace py::literals;

namespace {

template <typename Number> using Array = py::array_t<Number, py::array::c_style | py::array::forcecast>;

template <typename Number> py::array_t<Number> array_of(const std::vector<Number>& values) {
  return py::array_t<Number>(py::ssize_t(values.size()), values.data());
}

py::array_t<double> array_of(const std::vector<Vector>& vectors) {
  py::array_t<double> result({py::ssize_t(vectors.size()), py::ssize_t(3)});
  for (std::size_t i = 0; i < vectors.size(); ++i)
    std::copy(vectors[i].begin(), vectors[i].end(), result.mutable_data(py::ssize_t(i), 0));
  return result;
}

/// An extremal mesh with the surface cut along its lines, if that is known.
struct Result {
  Extremal_mesh mesh;
  Cell_patches patches;
};

Extraction_options options_of(int max_level, int threads) {
  Extraction_options options;
  options.max_level = options.max_line_level = max_level;
  options.threads = threads;
  options.patches = true;
  return options;
}

Result result_of(Extraction extraction, const std::string& source, const std::string& parameters,
                 const std::string& frame) {
  extraction.mesh.set_provenance(source, parameters, frame);
  return {std::move(extraction.mesh), std::move(extraction.patches)};
}

Result extract_formula(const std::string& text, const Point& low, const Point& high, std::size_t resolution,
                       int max_level, int threads, const std::string& parameters) {
  const py::gil_scoped_release release;
  const Formula formula(text);
  return result_of(extract_extremal_mesh(formula, make_lattice(low, high, resolution), options_of(max_level, threads)),
                   text, parameters, "");
}

/// A Python function is called by one thread, and must give the value and all derivatives up to order 3.
Result extract_callable(const std::function<Array<double>(double, double, double)>& function, const Point& low,
                        const Point& high, std::size_t resolution, int max_level, const std::string& parameters) {
  const auto f = make_function(
      [&](const Point& p, int, Derivatives& d) {
        const py::gil_scoped_acquire acquire;
        const Array<double> jet = function(p[0], p[1], p[2]);
        if (jet.size() != 20)
          throw std::invalid_argument(
              "the function must give 20 numbers: value, gradient (3), Hessian (6), third derivatives "
              "(10); it gave " +
              std::to_string(jet.size()));
        const double* next = jet.data();
        d.value = *next++;
        std::copy_n(next, 3, d.gradient.begin());
        std::copy_n(next + 3, 6, d.hessian.begin());
        std::copy_n(next + 9, 10, d.third.begin());
      },
      3);
  const py::gil_scoped_release release;
  return result_of(extract_extremal_mesh(f, make_lattice(low, high, resolution), options_of(max_level, 1)),
                   "a function", parameters, "");
}

Result extract_volume(const Array<float>& voxels, const std::array<std::array<double, 4>, 3>& affine, double iso,
                      double sigma, int max_level, int max_line_level, int threads, const std::string& parameters,
                      const std::string& frame) {
  Image image;
  for (std::size_t a = 0; a < 3; ++a) {
    image.lattice.size[a] = std::size_t(voxels.shape(py::ssize_t(a)));
    image.lattice.origin[a] = affine[a][3];
    for (std::size_t axis = 0; axis < 3; ++axis)
      image.lattice.step[axis][a] = affine[a][axis];
  }
  image.voxels.reserve(std::size_t(voxels.size()));
  const auto at = voxels.unchecked<3>();
  for (py::ssize_t k = 0; k < at.shape(2); ++k)
    for (py::ssize_t j = 0; j < at.shape(1); ++j)
      for (py::ssize_t i = 0; i < at.shape(0); ++i)
        image.voxels.push_back(at(i, j, k));
  const py::gil_scoped_release release;
  Image_function_options image_options;
  image_options.iso = iso;
  image_options.sigma = sigma;
  image_options.threads = threads;
  const Image_function function(std::move(image), image_options);
  Extraction_options options = options_of(max_level, threads);
  options.max_line_level = max_line_level;
  return result_of(extract_extremal_mesh(function, function.lattice(), options), "a volume", parameters, frame);
}

Result extract_polygons(const Array<double>& points, const std::vector<std::size_t>& begin,
                        const std::vector<std::uint32_t>& corners, double radius, int rings, int max_level, int threads,
                        const std::string& parameters) {
  std::vector<Point> vertices(std::size_t(points.shape(0)));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    std::copy_n(points.data(py::ssize_t(i), 0), 3, vertices[i].begin());
  const py::gil_scoped_release release;
  const Cell_complex cells = make_cell_complex(std::move(vertices), begin, corners);
  Fit_options fit_options;
  fit_options.radius = radius;
  fit_options.rings = rings;
  fit_options.threads = threads;
  const Fit fit = fit_vertex_shapes(cells, fit_options);
  return result_of(extract_extremal_mesh(cells, fit.shapes, options_of(max_level, threads)), "polygons", parameters,
                   "");
}

py::list checks_of(const Result& result) {
  py::list checks;
  for (const Check& check : check(result.mesh))
    checks.append(py::dict("name"_a = check.name, "claim"_a = check.claim, "applies"_a = check.applies,
                           "holds"_a = check.holds, "detail"_a = check.detail));
  return checks;
}

Result simplified(const Result& result, std::optional<double> threshold, std::optional<std::size_t> cells,
                  std::optional<std::size_t> vertices) {
  const py::gil_scoped_release release;
  const Simplification simplification(result.mesh);
  const std::size_t level = threshold  ? simplification.level_of_persistence(*threshold)
                            : cells    ? simplification.level_of_cells(*cells)
                            : vertices ? simplification.level_of_vertices(*vertices)
                                       : simplification.level_at_gap();
  Result simple;
  simple.mesh = simplification.mesh_at(level);
  if (!result.patches.cell.empty())
    simple.patches = simplification.patches_at(level, result.patches);
  return simple;
}

py::dict register_meshes(const Result& a, const Result& b, double tolerance, bool scale, bool mirror) {
  Registration_options options;
  options.tolerance = tolerance;
  options.scale = scale;
  options.mirror = mirror;
  Registration registration;
  {
    const py::gil_scoped_release release;
    registration = register_extremal_meshes(a.mesh, b.mesh, options);
  }
  py::list matched;
  for (const Matched_vertices& pair : registration.matched)
    matched.append(py::make_tuple(pair.a, pair.b, pair.distance));
  return py::dict("found"_a = registration.found, "reason"_a = registration.reason,
                  "matrix"_a = registration.transform.matrix(), "rms"_a = registration.rms, "matched"_a = matched);
}

/// writes by the file's ending, as the program does.
void write_file(const Result& result, const std::string& file) {
  const auto ends = [&](const char* ending) { return file.ends_with(ending); };
  const Extremal_mesh& mesh = result.mesh;
  if (ends(".graphml"))
    write_graphml(file, mesh);
  else if (ends(".off"))
    write_off(file, mesh);
  else if (ends(".obj"))
    write_obj(file, mesh);
  else if (ends(".ply"))
    write_lines_ply(file, mesh);
  else if (ends(".vtp"))
    write_vtp(file, mesh, result.patches);
  else if (ends(".glb") || ends(".gltf"))
    write_gltf(file, mesh, result.patches);
  else if (ends(".mrk.json"))
    write_markups(file, mesh);
  else if (ends(".json"))
    write_json(file, mesh);
  else if (ends(".html"))
    write_view(file, mesh, result.patches);
  else
    throw std::invalid_argument(
        "the extension of '" + file +
        "' is not known; give a .graphml, .off, .obj, .ply, .vtp, .glb, .gltf, .json, .mrk.json or .html");
}

py::dict vertices_of(const Result& result) {
  std::vector<Vector> points, normals, t1, t2;
  std::vector<double> k1, k2, index;
  py::list kinds, types;
  for (std::size_t v = 0; v < result.mesh.number_of_vertices(); ++v) {
    const Extremal_mesh_vertex& vertex = result.mesh.vertex(v);
    points.push_back(vertex.point);
    normals.push_back(vertex.normal);
    t1.push_back(vertex.t1);
    t2.push_back(vertex.t2);
    k1.push_back(vertex.k1);
    k2.push_back(vertex.k2);
    index.push_back(vertex.umbilic_index);
    kinds.append(std::string(to_string(vertex.kind)));
    types.append(std::string(to_string(vertex.umbilic_type)));
  }
  return py::dict("kind"_a = kinds, "point"_a = array_of(points), "normal"_a = array_of(normals), "t1"_a = array_of(t1),
                  "t2"_a = array_of(t2), "k_max"_a = array_of(k1), "k_min"_a = array_of(k2),
                  "index"_a = array_of(index), "umbilic_type"_a = types);
}

py::dict edges_of(const Result& result) {
  std::vector<std::uint32_t> source, target, left, right;
  std::vector<std::int32_t> family;
  std::vector<double> length, strength, sharpness;
  py::list types, polylines;
  for (std::size_t e = 0; e < result.mesh.number_of_edges(); ++e) {
    const Extremal_mesh_edge& edge = result.mesh.edge(e);
    source.push_back(edge.source);
    target.push_back(edge.target);
    left.push_back(edge.left_cell);
    right.push_back(edge.right_cell);
    family.push_back(edge.family);
    length.push_back(edge.length);
    strength.push_back(edge.strength);
    sharpness.push_back(edge.sharpness);
    types.append(std::string(to_string(edge.type)));
    polylines.append(array_of(edge.polyline));
  }
  return py::dict("source"_a = array_of(source), "target"_a = array_of(target), "family"_a = array_of(family),
                  "type"_a = types, "length"_a = array_of(length), "strength"_a = array_of(strength),
                  "sharpness"_a = array_of(sharpness), "left_cell"_a = array_of(left), "right_cell"_a = array_of(right),
                  "polyline"_a = polylines);
}

py::dict cells_of(const Result& result) {
  std::vector<std::int32_t> sign, euler_characteristic;
  std::vector<double> area, weight;
  py::list boundary;
  for (const Extremal_mesh_cell& cell : result.mesh.cells()) {
    sign.push_back(cell.sign);
    euler_characteristic.push_back(cell.euler_characteristic);
    area.push_back(cell.area);
    weight.push_back(cell.weight);
    boundary.append(py::cast(cell.boundary));
  }
  return py::dict("sign"_a = array_of(sign), "area"_a = array_of(area), "weight"_a = array_of(weight),
                  "euler_characteristic"_a = array_of(euler_characteristic), "boundary"_a = boundary);
}

py::dict surface_of(const Result& result) {
  if (result.patches.cell.empty())
    return {};
  const Cell_patches surface = triangulate(result.patches);
  py::array_t<std::uint32_t> faces({py::ssize_t(surface.cell.size()), py::ssize_t(3)});
  std::copy(surface.corners.begin(), surface.corners.end(), faces.mutable_data());
  return py::dict("point"_a = array_of(surface.points), "normal"_a = array_of(surface.normals), "triangle"_a = faces,
                  "cell"_a = array_of(surface.cell));
}

} // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled core of extremal_mesh.";
  // std::invalid_argument is ValueError already; what the library cannot do with a right call is RuntimeError, files OSError
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      std::rethrow_exception(pointer);
    } catch (const Io_error& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    }
  });
  py::class_<Result>(module, "Result")
      .def("sizes",
           [](const Result& r) {
             return std::array{r.mesh.number_of_vertices(), r.mesh.number_of_edges(), r.mesh.number_of_cells()};
           })
      .def("vertices", &vertices_of)
      .def("edges", &edges_of)
      .def("cells", &cells_of)
      .def("surface", &surface_of)
      .def("info",
           [](const Result& r) {
             const Surface_info& s = r.mesh.surface();
             return py::dict("euler_characteristic"_a = s.euler_characteristic, "closed"_a = s.closed,
                             "area"_a = s.area, "source"_a = s.source, "parameters"_a = s.parameters,
                             "frame"_a = s.frame);
           })
      .def("check", &checks_of)
      .def("simplify", &simplified)
      .def("register", &register_meshes)
      .def("write", &write_file);
  module.def("extract_formula", &extract_formula);
  module.def("extract_callable", &extract_callable);
  module.def("extract_volume", &extract_volume);
  module.def("extract_polygons", &extract_polygons);
  module.def("read", [](const std::string& file) { return Result{read_graphml(file), {}}; });
}
