// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same cells and the same extremal mesh from every kind of face graph.
#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/face_graph.h>
#include <CGAL/Extremal_mesh_3/project_onto.h>

#include "graph_comparison.h"
#include "meshes.h"
#include "same_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <iterator>
#include <map>
#include <set>

using namespace CGAL::Extremal_mesh_3;
namespace params = CGAL::Extremal_mesh_3::parameters;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
using Poly_mesh = OpenMesh::PolyMesh_ArrayKernelT<Double_traits>;
using Tri_mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;
using Float_mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

// Nothing else is taken for a face graph.
static_assert(!Face_list_graph<Cell_complex> && !Face_list_graph<Function_3> && !Face_list_graph<Formula>);
static_assert(!Face_list_graph<std::vector<Point>> && !Face_list_graph<Lattice>);

template <class Graph> inline constexpr bool of_triangles = std::is_same_v<Graph, Tri_mesh>;
template <class Graph> inline constexpr bool of_floats = std::is_same_v<Graph, Float_mesh>;
template <class Graph> using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;

/// adds a vertex. CGAL's property maps would round the points of an OpenMesh to floats.
template <class Graph> Vertex<Graph> add_point(Graph& g, const Point& p) {
  const auto v = add_vertex(g);
  if constexpr (requires { typename Graph::Point::value_type; })
    g.set_point(v, {typename Graph::Point::value_type(p[0]), typename Graph::Point::value_type(p[1]),
                    typename Graph::Point::value_type(p[2])});
  else
    put(CGAL::vertex_point, g, v, Kernel::Point_3(p[0], p[1], p[2]));
  return v;
}

template <class Graph> Graph graph_of(const meshes::Polygons& m) {
  Graph g;
  std::vector<Vertex<Graph>> v, corners;
  for (const Point& p : m.points)
    v.push_back(add_point(g, p));
  for (const auto& polygon : m.polygons) {
    corners.clear();
    for (const std::uint32_t i : polygon)
      corners.push_back(v[i]);
    CGAL::Euler::add_face(corners, g);
  }
  return g;
}

/// the polygons as lists of points, each beginning with its least one.
std::multiset<std::vector<Point>> polygons_of(const Cell_complex& c) {
  std::multiset<std::vector<Point>> result;
  for (std::size_t i = 0; i < c.number_of_cells(); ++i) {
    std::vector<Point> polygon;
    for (std::size_t k = c.cell_begin[i]; k < c.cell_begin[i + 1]; ++k)
      polygon.push_back(c.points[c.source(c.half_edges[k])]);
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
    result.insert(polygon);
  }
  return result;
}

const Formula ellipsoid("x^2/9 + y^2/4 + z^2 - 1");

/// an ellipsoid: triangles, or polygons of three to seven sides.
meshes::Polygons ellipsoid_mesh(bool triangles) {
  if (triangles)
    return meshes::on_ellipsoid(meshes::icosphere(4), 3, 2, 1);
  const Cell_complex cells = make_implicit_cells(ellipsoid, make_lattice({-3.1, -2.2, -1.3}, {3.15, 2.1, 1.2}, 40));
  meshes::Polygons m{cells.points, {}};
  for (std::size_t i = 0; i < cells.number_of_cells(); ++i) {
    m.polygons.emplace_back();
    for (std::size_t k = cells.cell_begin[i]; k < cells.cell_begin[i + 1]; ++k)
      m.polygons.back().push_back(cells.source(cells.half_edges[k]));
  }
  return m;
}

meshes::Polygons rounded_to_floats(meshes::Polygons m) {
  for (Point& p : m.points)
    for (double& x : p) {
      volatile float rounded = float(x); // volatile: GCC 12.2 forgets the last ones if it vectorizes the loop
      x = double(rounded);
    }
  return m;
}

template <class Graph> class Face_graph : public testing::Test {
protected:
  static meshes::Polygons polygons() {
    const meshes::Polygons m = ellipsoid_mesh(of_triangles<Graph>);
    return of_floats<Graph> ? rounded_to_floats(m) : m;
  }
  static Point point(const Graph& g, Vertex<Graph> v) { return internal::to_array(get(CGAL::vertex_point, g, v)); }

  /// what must hold of the cells of any graph without isolated vertices among those that are not deleted.
  static void expect_same_points(const Graph& g, const Cell_complex& cells,
                                 const std::vector<Vertex<Graph>>& vertices) {
    ASSERT_EQ(cells.points.size(), vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      EXPECT_EQ(cells.points[i], point(g, vertices[i]));
  }
};

struct Names {
  template <class Graph> static std::string GetName(int) {
    return std::is_same_v<Graph, Surface_mesh> ? "Surface_mesh"
           : std::is_same_v<Graph, Polyhedron> ? "Polyhedron_3"
           : std::is_same_v<Graph, Poly_mesh>  ? "OpenMesh_polygons"
           : std::is_same_v<Graph, Tri_mesh>   ? "OpenMesh_triangles"
                                               : "OpenMesh_floats";
  }
};
using Graphs = testing::Types<Surface_mesh, Polyhedron, Poly_mesh, Tri_mesh, Float_mesh>;
TYPED_TEST_SUITE(Face_graph, Graphs, Names);

} // namespace

TYPED_TEST(Face_graph, gives_its_points_and_polygons) {
  const meshes::Polygons m = this->polygons();
  const auto g = graph_of<TypeParam>(m);
  const Cell_complex cells = make_cell_complex(g);
  EXPECT_EQ(cells.points, m.points);
  EXPECT_EQ(polygons_of(cells), polygons_of(m.cells()));
  EXPECT_EQ(cells.euler_characteristic(), 2);
}

TYPED_TEST(Face_graph, leaves_out_vertices_without_a_face_and_tells_the_others) {
  const meshes::Polygons m = this->polygons();
  TypeParam g;
  add_point(g, {7, 8, 9});
  std::vector<Vertex<TypeParam>> v, corners, vertices;
  for (const Point& p : m.points)
    v.push_back(add_point(g, p));
  add_point(g, {-7, -8, -9});
  for (const auto& polygon : m.polygons) {
    corners.clear();
    for (const std::uint32_t i : polygon)
      corners.push_back(v[i]);
    CGAL::Euler::add_face(corners, g);
  }
  const Cell_complex cells = make_cell_complex(g, params::vertex_output_iterator(std::back_inserter(vertices)));
  EXPECT_EQ(cells.points, m.points);
  EXPECT_EQ(vertices, v);
}

TYPED_TEST(Face_graph, keeps_its_borders) {
  const meshes::Polygons m = this->polygons();
  auto g = graph_of<TypeParam>(m);
  // Without the cells around a vertex, and elsewhere without one cell.
  std::vector<typename boost::graph_traits<TypeParam>::halfedge_descriptor> removed;
  for (const auto h : CGAL::halfedges_around_target(halfedge(*vertices(g).begin(), g), g))
    removed.push_back(h);
  removed.push_back(halfedge(*std::prev(faces(g).end()), g));
  std::size_t border = degree(face(removed.back(), g), g);
  for (std::size_t i = 0; i + 1 < removed.size(); ++i)
    border += degree(face(removed[i], g), g) - 2;
  for (const auto h : removed)
    CGAL::Euler::remove_face(h, g);

  std::vector<Vertex<TypeParam>> vertices;
  const Cell_complex cells = make_cell_complex(g, params::vertex_output_iterator(std::back_inserter(vertices)));
  this->expect_same_points(g, cells, vertices);
  EXPECT_EQ(cells.points.size(), m.points.size() - 1);
  EXPECT_EQ(cells.number_of_cells(), m.polygons.size() - removed.size());
  EXPECT_EQ(cells.euler_characteristic(), 0);
  std::size_t sides = 0;
  for (const auto& [left, right] : cells.edge_cells)
    sides += (left == Cell_complex::no_cell) + (right == Cell_complex::no_cell);
  EXPECT_EQ(sides, border);
}

TYPED_TEST(Face_graph, forgets_what_was_deleted) {
  if constexpr (!of_triangles<TypeParam>) {
    // Around a tenth of the vertices the faces are joined to one; no garbage is collected.
    auto g = graph_of<TypeParam>(this->polygons());
    const std::vector<Vertex<TypeParam>> all(vertices(g).begin(), vertices(g).end());
    std::set<Vertex<TypeParam>> left(all.begin(), all.end());
    std::size_t cells_left = num_faces(g);
    for (std::size_t i = 0; i < all.size(); i += 10) {
      const auto h = halfedge(all[i], g);
      const std::size_t around = degree(all[i], g);
      // Joined faces must not meet themselves.
      std::multiset<Vertex<TypeParam>> link;
      for (const auto to_center : CGAL::halfedges_around_target(h, g))
        for (auto k = next(to_center, g); target(next(k, g), g) != all[i]; k = next(k, g))
          link.insert(target(k, g));
      if (std::set<Vertex<TypeParam>>(link.begin(), link.end()).size() != link.size())
        continue;
      CGAL::Euler::remove_center_vertex(h, g);
      left.erase(all[i]);
      cells_left -= around - 1;
    }
    ASSERT_LT(left.size(), all.size() - 20);

    std::vector<Vertex<TypeParam>> vertices;
    const Cell_complex cells = make_cell_complex(g, params::vertex_output_iterator(std::back_inserter(vertices)));
    this->expect_same_points(g, cells, vertices);
    EXPECT_EQ(std::set<Vertex<TypeParam>>(vertices.begin(), vertices.end()), left);
    EXPECT_EQ(cells.number_of_cells(), cells_left);
    EXPECT_EQ(cells.euler_characteristic(), 2);
  } else {
    // A mesh of triangles stays one: each tenth edge is contracted.
    auto g = graph_of<TypeParam>(this->polygons());
    const std::size_t n = num_vertices(g);
    std::vector<typename TypeParam::HalfedgeHandle> contracted;
    for (std::size_t i = 0; i < num_edges(g); i += 10)
      contracted.push_back(g.halfedge_handle(OpenMesh::EdgeHandle(int(i)), 0));
    g.request_vertex_status();
    g.request_edge_status();
    g.request_halfedge_status();
    g.request_face_status();
    std::size_t gone = 0;
    for (const auto h : contracted)
      if (!g.status(g.edge_handle(h)).deleted() && g.is_collapse_ok(h)) {
        g.collapse(h);
        ++gone;
      }
    ASSERT_GT(gone, 20U);
    EXPECT_EQ(num_vertices(g), n); // the dead are counted
    std::vector<Vertex<TypeParam>> vertices;
    const Cell_complex cells = make_cell_complex(g, params::vertex_output_iterator(std::back_inserter(vertices)));
    this->expect_same_points(g, cells, vertices);
    EXPECT_EQ(cells.points.size(), n - gone);
    EXPECT_EQ(cells.euler_characteristic(), 2);
    EXPECT_TRUE(std::none_of(vertices.begin(), vertices.end(), [&](auto v) { return g.status(v).deleted(); }));
  }
}

TYPED_TEST(Face_graph, takes_points_from_a_map) {
  const meshes::Polygons m = this->polygons();
  const auto g = graph_of<TypeParam>(m);
  std::map<Vertex<TypeParam>, std::array<float, 3>> as_array;
  std::map<Vertex<TypeParam>, Kernel::Point_3> as_point;
  float i = 0;
  for (const auto v : CGAL::make_range(vertices(g))) {
    as_array[v] = {i, i + 1, i * i};
    as_point[v] = Kernel::Point_3(i, i + 1, i * i);
    ++i;
  }
  const Cell_complex first = make_cell_complex(g, params::vertex_point_map(boost::make_assoc_property_map(as_array)));
  for (std::size_t k = 0; k < first.points.size(); ++k)
    EXPECT_EQ(first.points[k], (Point{double(k), double(k + 1), double(k * k)}));
  const auto point_map = boost::make_assoc_property_map(as_point);
  EXPECT_EQ(make_cell_complex(g, params::vertex_point_map(point_map)).points, first.points);
  EXPECT_EQ(make_cell_complex(g, CGAL::parameters::vertex_point_map(point_map)).points, first.points); // CGAL's own
}

TYPED_TEST(Face_graph, gives_the_mesh_of_a_function_that_it_samples) {
  const auto g = graph_of<TypeParam>(this->polygons());
  const Extremal_mesh mesh = extract_extremal_mesh(g, params::function(ellipsoid).threads(2)).mesh;
  surfaces::expect_all_checks_hold(mesh);
  const Extremal_mesh expected = extract_extremal_mesh(ellipsoid, make_lattice({-4, -3, -2}, {4, 3, 2}, 32)).mesh;
  EXPECT_TRUE(graph_comparison::isomorphic(expected, mesh));
  for (const auto kind : {Vertex_kind::extremal_point, Vertex_kind::umbilic}) {
    const auto off = graph_comparison::largest_distance(graph_comparison::positions(expected, kind),
                                                        graph_comparison::positions(mesh, kind));
    ASSERT_TRUE(off);
    EXPECT_LT(*off, 1e-9); // found to rounding, whatever the cells; with room for weakly determined points
  }
}

TYPED_TEST(Face_graph, gives_the_mesh_of_given_shapes) {
  const auto g = graph_of<TypeParam>(this->polygons());
  const Cell_complex cells = make_cell_complex(g);
  const Vertex_shapes shapes = meshes::exact_shapes(ellipsoid, cells.points);
  std::map<Vertex<TypeParam>, Local_shape> shape;
  std::map<Vertex<TypeParam>, Fourth_order_form> fourth;
  std::size_t i = 0;
  for (const auto v : CGAL::make_range(vertices(g))) {
    shape[v] = shapes.shapes[i];
    fourth[v] = shapes.fourth[i++];
  }
  Fit fit;
  const Extraction extraction =
      extract_extremal_mesh(g, params::vertex_fourth_order_map(boost::make_assoc_property_map(fourth))
                                   .vertex_shape_map(boost::make_assoc_property_map(shape))
                                   .fit_output(fit));
  same_mesh::expect_same(extraction.mesh, extract_extremal_mesh(cells, shapes).mesh);
  EXPECT_EQ(fit.shapes.shapes.size(), cells.points.size());
  EXPECT_TRUE(fit.shapes.quality.empty()); // given, not fitted
}

TYPED_TEST(Face_graph, gives_the_mesh_of_fitted_jets) {
  const auto g = graph_of<TypeParam>(this->polygons());
  Fit fit;
  const Extraction extraction = extract_extremal_mesh(g, params::fit_output(fit));
  const Cell_complex cells = make_cell_complex(g);
  EXPECT_EQ(fit.report.fitted, cells.points.size());
  same_mesh::expect_same(extraction.mesh, extract_extremal_mesh(cells, fit_vertex_shapes(cells).shapes).mesh);
}

TYPED_TEST(Face_graph, fits_as_told) {
  const auto g = graph_of<TypeParam>(this->polygons());
  const Cell_complex cells = make_cell_complex(g);
  std::map<Vertex<TypeParam>, Kernel::Vector_3> normal;
  Fit_options expected;
  std::size_t i = 0;
  for (const auto v : CGAL::make_range(vertices(g))) {
    Derivatives d;
    ellipsoid.derivatives(cells.points[i++], 1, d);
    normal[v] = Kernel::Vector_3(d.gradient[0], d.gradient[1], d.gradient[2]); // not of length 1
    expected.normals.push_back(surfaces::unit(d.gradient));
  }
  const auto normals = boost::make_assoc_property_map(normal);
  const auto expect_fit = [&](const Fit& fit, const Fit_options& options) {
    const Fit other = fit_vertex_shapes(cells, options);
    EXPECT_EQ(fit.report.radius_median, other.report.radius_median);
    ASSERT_EQ(fit.shapes.shapes.size(), other.shapes.shapes.size());
    for (std::size_t k = 0; k < other.shapes.shapes.size(); ++k) {
      // Their lengths may be scaled to 1 in another order.
      EXPECT_LT(surfaces::distance(fit.shapes.shapes[k].n, other.shapes.shapes[k].n), 1e-9);
      EXPECT_NEAR(fit.shapes.shapes[k].H, other.shapes.shapes[k].H, 1e-9);
      EXPECT_EQ(fit.shapes.quality[k].points, other.shapes.quality[k].points);
    }
  };
  Fit fit;
  expected.radius = 0.7;
  extract_extremal_mesh(g, params::radius(0.7).vertex_normal_map(normals).fit_output(fit));
  expect_fit(fit, expected);
  EXPECT_EQ(fit.report.radius_median, 0.7);

  expected.radius = 0;
  expected.rings = 3;
  extract_extremal_mesh(g, params::vertex_normal_map(normals).fit_output(fit).rings(3));
  expect_fit(fit, expected);

  Fit_options options;
  options.radius = 0.8;
  extract_extremal_mesh(g, params::fit_options(options).fit_output(fit));
  expect_fit(fit, options);
  extract_extremal_mesh(g, params::radius(0.7).fit_options(options).fit_output(fit)); // what is named takes precedence
  options.radius = 0.7;
  expect_fit(fit, options);
}

TYPED_TEST(Face_graph, extracts_as_told) {
  const auto g = graph_of<TypeParam>(this->polygons());
  EXPECT_TRUE(extract_extremal_mesh(g, params::function(ellipsoid)).patches.points.empty());
  Extraction_options options;
  options.patches = true;
  EXPECT_FALSE(
      extract_extremal_mesh(g, params::extraction_options(options).function(ellipsoid)).patches.points.empty());
  options.progress = [](double) { return false; };
  EXPECT_THROW(extract_extremal_mesh(g, params::extraction_options(options)), Cancelled);
}

TYPED_TEST(Face_graph, refuses_contradictions) {
  const auto g = graph_of<TypeParam>(this->polygons());
  std::map<Vertex<TypeParam>, Local_shape> shape;
  std::map<Vertex<TypeParam>, Fourth_order_form> fourth;
  std::map<Vertex<TypeParam>, Vector> normal;
  for (const auto v : CGAL::make_range(vertices(g))) {
    shape[v] = {};
    fourth[v] = {};
    normal[v] = {0, 0, 0};
  }
  const auto shapes = boost::make_assoc_property_map(shape);
  EXPECT_THROW(extract_extremal_mesh(g, params::function(ellipsoid).vertex_shape_map(shapes)), std::invalid_argument);
  EXPECT_THROW(extract_extremal_mesh(g, params::vertex_fourth_order_map(boost::make_assoc_property_map(fourth))),
               std::invalid_argument);
  EXPECT_THROW(extract_extremal_mesh(g, params::vertex_normal_map(boost::make_assoc_property_map(normal))),
               std::invalid_argument);
  EXPECT_THROW(extract_extremal_mesh(g, params::threads(-1)), std::invalid_argument);
  EXPECT_THROW(extract_extremal_mesh(TypeParam()), Extraction_error); // no cells
}

TEST(Face_graph, must_be_a_manifold) {
  // Two triangles that share one point only.
  meshes::Polygons m;
  m.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  m.polygons = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_THROW(make_cell_complex(graph_of<Surface_mesh>(m)), std::invalid_argument);
}
