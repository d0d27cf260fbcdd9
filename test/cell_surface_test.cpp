// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface cut along the lines, as a mesh of CGAL's.
#include <CGAL/Extremal_mesh_3/cell_surface.h>

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include "hand_made.h"
#include "surfaces.h"
#include "temporary_folder.h"

#include <set>

using namespace CGAL::Extremal_mesh_3;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Surface::Face_index;

struct Shape {
  const char* name;
  Extraction extraction;
};

Extraction extracted(const std::string& formula, const Point& low, const Point& high, double line_tolerance = 0) {
  Extraction_options options;
  options.patches = true;
  options.line_tolerance = line_tolerance;
  return extract_extremal_mesh(Formula(formula), make_lattice(low, high, 20), options);
}

/// a surface like a sphere, one like a torus, and one with a border; the first and the last also with lines of many points.
const std::vector<Shape>& shapes() {
  const std::string bent = "x^2+1.3*y^2+1.7*z^2+0.2*x^3+0.15*y^3-0.4*x*y*z+0.2*x^2*z+0.1*x*y^2-1";
  static const std::vector<Shape> all = {
      {"closed", extracted(bent, {-1.4, -1.4, -1.4}, {1.4, 1.4, 1.4})},
      {"torus", extracted("(sqrt(x^2+1.3*y^2)-1)^2+z^2*(1+0.2*x)+0.03*y*z-0.16", {-1.6, -1.5, -0.7}, {1.6, 1.5, 0.7})},
      {"bordered", extracted(bent, {-1.4, -1.4, -0.1}, {1.4, 1.4, 1.4})},
      {"closed_with_fine_lines", extracted(bent, {-1.4, -1.4, -1.4}, {1.4, 1.4, 1.4}, 1e-6)},
      {"bordered_with_fine_lines", extracted(bent, {-1.4, -1.4, -0.1}, {1.4, 1.4, 1.4}, 1e-4)}};
  return all;
}

auto cells_of(Surface& surface) {
  const auto [map, found] = surface.property_map<Face, std::uint32_t>("f:cell");
  EXPECT_TRUE(found);
  return map;
}

Point point_of(const Surface& surface, Surface::Vertex_index v) {
  return {surface.point(v).x(), surface.point(v).y(), surface.point(v).z()};
}

double area_of(const Surface& surface, Face f) {
  std::vector<Point> corners;
  for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
    corners.push_back(point_of(surface, v));
  return surfaces::length(surfaces::cross(surfaces::along(corners[1], -1, corners[0]),
                                          surfaces::along(corners[2], -1, corners[0]))) /
         2;
}

/// \param surface  of triangles: by these `Extremal_mesh_cell::area` is defined
std::vector<double> areas_by_cell(Surface& surface, std::size_t n) {
  std::vector<double> areas(n, 0);
  const auto cell = cells_of(surface);
  for (const Face f : surface.faces())
    areas.at(cell[f]) += area_of(surface, f);
  return areas;
}

/// all segments of the lines, by their ends.
std::set<std::pair<Point, Point>> segments_of(const Extremal_mesh& mesh) {
  std::set<std::pair<Point, Point>> segments;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    for (std::size_t i = 0; i + 1 < mesh.edge(e).polyline.size(); ++i)
      segments.insert(std::minmax(mesh.edge(e).polyline[i], mesh.edge(e).polyline[i + 1]));
  return segments;
}

} // namespace

TEST(Cell_surface, is_a_valid_mesh_that_is_closed_where_the_surface_is) {
  for (const Shape& shape : shapes()) {
    Surface surface;
    make_cell_surface(shape.extraction.patches, surface);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(surface)) << shape.name;
    EXPECT_EQ(CGAL::is_closed(surface), shape.extraction.mesh.surface().closed) << shape.name;
    EXPECT_EQ(std::int64_t(surface.number_of_vertices()) - std::int64_t(surface.number_of_edges()) +
                  std::int64_t(surface.number_of_faces()),
              shape.extraction.mesh.surface().euler_characteristic)
        << shape.name;
    EXPECT_EQ(surface.number_of_vertices(), shape.extraction.patches.points.size()) << shape.name;
    EXPECT_EQ(surface.number_of_faces(), shape.extraction.patches.cell.size()) << shape.name;
  }
}

TEST(Cell_surface, has_the_area_of_each_cell) {
  for (const Shape& shape : shapes()) {
    const Extremal_mesh& mesh = shape.extraction.mesh;
    Surface triangles;
    make_cell_surface(triangulate(shape.extraction.patches), triangles);
    EXPECT_TRUE(CGAL::is_triangle_mesh(triangles)) << shape.name;
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(triangles)) << shape.name;
    EXPECT_EQ(CGAL::is_closed(triangles), mesh.surface().closed) << shape.name;
    const auto by_triangles = areas_by_cell(triangles, mesh.number_of_cells());
    for (std::size_t c = 0; c < mesh.number_of_cells(); ++c) { // sums of some hundred terms
      EXPECT_NEAR(by_triangles[c], mesh.cell(c).area, 1e-12 * mesh.surface().area) << shape.name << c;
    }
  }
}

TEST(Cell_surface, is_cut_exactly_along_the_lines) {
  for (const Shape& shape : shapes()) {
    const Extremal_mesh& mesh = shape.extraction.mesh;
    Surface surface;
    make_cell_surface(shape.extraction.patches, surface);
    const auto cell = cells_of(surface);
    const auto segments = segments_of(mesh);
    std::size_t on_lines = 0;
    for (const auto e : surface.edges()) {
      const auto h = surface.halfedge(e);
      if (surface.is_border(e))
        continue;
      const std::uint32_t one = cell[surface.face(h)], other = cell[surface.face(surface.opposite(h))];
      const bool on_line =
          segments.count(std::minmax(point_of(surface, surface.source(h)), point_of(surface, surface.target(h)))) != 0;
      EXPECT_EQ(one != other, on_line) << shape.name;
      if (one != other) {
        EXPECT_EQ(mesh.cell(one).sign, -mesh.cell(other).sign) << shape.name;
      }
      on_lines += on_line;
    }
    EXPECT_EQ(on_lines, segments.size()) << shape.name;
  }
}

TEST(Cell_surface, of_one_cell_has_its_euler_characteristic) {
  for (const Shape& shape : shapes()) {
    const Extremal_mesh& mesh = shape.extraction.mesh;
    for (std::uint32_t c = 0; c < mesh.number_of_cells(); ++c) {
      Surface surface;
      make_cell_surface(patches_of_cell(shape.extraction.patches, c), surface);
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(surface)) << shape.name << c;
      const auto chi = std::int64_t(surface.number_of_vertices()) - std::int64_t(surface.number_of_edges()) +
                       std::int64_t(surface.number_of_faces());
      if (!mesh.cell(c).touches_border) { // there the open cell lacks the border
        EXPECT_EQ(chi, mesh.cell(c).euler_characteristic) << shape.name << c;
      }
      Surface triangles;
      make_cell_surface(triangulate(patches_of_cell(shape.extraction.patches, c)), triangles);
      EXPECT_NEAR(areas_by_cell(triangles, mesh.number_of_cells())[c], mesh.cell(c).area, 1e-12 * mesh.surface().area);
      auto component = surface.add_property_map<Face, std::size_t>("f:component").first;
      EXPECT_EQ(CGAL::Polygon_mesh_processing::connected_components(surface, component), 1U) << shape.name << c;
    }
  }
}

TEST(Cell_surface, tells_cells_and_normals_to_the_maps_that_it_is_given) {
  const Cell_patches patches = shapes()[0].extraction.patches;
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Polyhedron polyhedron;
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, std::uint32_t> cells;
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, Kernel::Vector_3> normals;
  make_cell_surface(patches, polyhedron,
                    CGAL::parameters::face_patch_map(boost::make_assoc_property_map(cells))
                        .vertex_normal_map(boost::make_assoc_property_map(normals)));
  EXPECT_TRUE(polyhedron.is_valid());
  EXPECT_TRUE(polyhedron.is_closed());
  ASSERT_EQ(cells.size(), patches.cell.size());
  std::size_t i = 0;
  for (const auto f : faces(polyhedron))
    EXPECT_EQ(cells.at(f), patches.cell[i++]);
  std::map<Point, Vector> normal_at;
  for (std::size_t p = 0; p < patches.points.size(); ++p)
    normal_at[patches.points[p]] = patches.normals[p];
  for (const auto v : vertices(polyhedron)) {
    const Vector& n = normal_at.at({v->point().x(), v->point().y(), v->point().z()});
    EXPECT_EQ(normals.at(v), Kernel::Vector_3(n[0], n[1], n[2]));
  }
}

TEST(Cell_surface, keeps_what_the_mesh_has) {
  Surface surface;
  make_cell_surface(shapes()[0].extraction.patches, surface);
  const std::size_t faces = surface.number_of_faces();
  make_cell_surface(patches_of_cell(shapes()[1].extraction.patches, 3), surface);
  EXPECT_GT(surface.number_of_faces(), faces);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(surface));
  const auto cell = cells_of(surface);
  EXPECT_EQ(cell[Face(0)], shapes()[0].extraction.patches.cell[0]);
  EXPECT_EQ(cell[Face(Surface::size_type(faces))], 3U);
}

TEST(Cell_surface, in_a_file_is_read_by_cgal_with_its_cells_and_colours) {
  const Temporary_folder folder;
  const Extraction& given = shapes()[0].extraction;
  write_ply(folder.file("cells.ply"), given.patches, given.mesh);
  Surface surface;
  std::ifstream in(folder.file("cells.ply"), std::ios::binary);
  ASSERT_TRUE(CGAL::IO::read_PLY(in, surface));
  EXPECT_TRUE(CGAL::is_closed(surface));
  EXPECT_EQ(surface.number_of_faces(), given.patches.cell.size());
  const auto cell = surface.property_map<Face, std::int32_t>("f:cell");
  ASSERT_TRUE(cell.second);
  const auto colour = surface.property_map<Face, CGAL::IO::Color>("f:color");
  ASSERT_TRUE(colour.second);
  for (const Face f : surface.faces()) {
    const auto c = std::uint32_t(cell.first[f]);
    EXPECT_EQ(c, given.patches.cell[f.idx()]);
    EXPECT_EQ(colour.first[f].red() > colour.first[f].blue(), given.mesh.cell(c).sign > 0); // ivory, grey-blue
  }
}

TEST(Cell_surface, follows_a_simplification) {
  const Extraction& given = shapes()[0].extraction;
  const Simplification simplification(given.mesh);
  const std::size_t level = simplification.steps().size();
  ASSERT_GT(level, 0U);
  const Extremal_mesh simple = simplification.mesh_at(level);
  Surface surface;
  make_cell_surface(triangulate(simplification.patches_at(level, given.patches)), surface);
  EXPECT_TRUE(CGAL::is_closed(surface));
  const auto areas = areas_by_cell(surface, simple.number_of_cells());
  for (std::size_t c = 0; c < areas.size(); ++c)
    EXPECT_NEAR(areas[c], simple.cell(c).area, 1e-12 * simple.surface().area) << c;
}

TEST(Cell_patches, of_a_cell_that_meets_itself_in_a_point_get_a_vertex_on_each_side) {
  // Two triangles with a corner in common.
  Cell_patches bow_tie;
  bow_tie.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  bow_tie.normals.assign(5, {0, 0, 1});
  bow_tie.corners = {0, 1, 2, 0, 3, 4};
  bow_tie.begin = {0, 3, 6};
  bow_tie.cell = {7, 7};
  Surface surface;
  make_cell_surface(bow_tie, surface);
  EXPECT_EQ(surface.number_of_vertices(), 6U);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(surface));
}

TEST(Cell_patches, with_two_corners_close_up) {
  // A tetrahedron of which one edge was opened into a polygon without area.
  Cell_patches patches;
  patches.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  patches.normals = patches.points;
  patches.corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 1};
  patches.begin = {0, 3, 6, 9, 12, 14};
  patches.cell = {0, 0, 0, 0, 1};
  Surface surface;
  make_cell_surface(patches, surface);
  EXPECT_EQ(surface.number_of_faces(), 4U);
  EXPECT_TRUE(CGAL::is_closed(surface));
}

TEST(Cell_patches, around_a_closed_line_of_two_segments_stay_apart) {
  // On a square two triangles between its ends and a middle point, on both sides of what was an edge.
  Cell_patches patches;
  patches.points = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}};
  patches.normals.assign(5, {0, 0, 1});
  patches.corners = {0, 1, 3, 0, 2, 1, 1, 0, 4, 1, 2, 0};
  patches.begin = {0, 3, 6, 9, 12};
  patches.cell = {5, 6, 5, 6};
  Surface surface;
  make_cell_surface(patches, surface);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(surface));
  EXPECT_EQ(surface.number_of_vertices(), 6U);
  EXPECT_EQ(surface.number_of_edges(), 9U);
  EXPECT_EQ(surface.number_of_faces(), 4U);
  const auto cell = cells_of(surface);
  for (const Face f : surface.faces())
    EXPECT_EQ(cell[f], patches.cell[f.idx()]);
  for (const auto e : surface.edges())
    if (!surface.is_border(e)) {
      const auto h = surface.halfedge(e);
      const bool along = surface.point(surface.source(h)).y() == 0 && surface.point(surface.target(h)).y() == 0;
      EXPECT_TRUE(along);
    }
}

TEST(Cell_patches, of_a_noisy_scan_are_a_closed_surface_too) {
  // Waves of the size of the lattice's cubes: tiny closed lines, cells that meet themselves.
  Extraction_options options;
  options.patches = true;
  options.max_level = 3;
  options.max_line_level = 0;
  const Extraction extraction =
      extract_extremal_mesh(Formula("x^2+1.3*y^2+1.7*z^2-1+0.02*sin(19*x+3*y)*cos(17*y-5*z)+0.02*sin(23*z+2*x)"),
                            make_lattice({-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}, 24), options);
  ASSERT_GT(extraction.mesh.number_of_cells(), 300U);
  Surface surface;
  make_cell_surface(extraction.patches, surface);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(surface));
  EXPECT_TRUE(CGAL::is_closed(surface));
  EXPECT_EQ(std::int64_t(surface.number_of_vertices()) - std::int64_t(surface.number_of_edges()) +
                std::int64_t(surface.number_of_faces()),
            extraction.mesh.surface().euler_characteristic);
}

TEST(Cell_patches, that_make_no_sense_are_refused) {
  const Cell_patches good = hand_made::octants(2);
  Surface surface;
  const auto refused = [&](auto change) {
    Cell_patches bad = good;
    change(bad);
    EXPECT_THROW(make_cell_surface(bad, surface), std::invalid_argument);
    EXPECT_THROW(triangulate(bad), std::invalid_argument);
    EXPECT_THROW(patches_of_cell(bad, 0), std::invalid_argument);
  };
  refused([](Cell_patches& p) { p.corners[3] = 1000; });
  refused([](Cell_patches& p) { p.normals.pop_back(); });
  refused([](Cell_patches& p) { p.cell.pop_back(); });
  refused([](Cell_patches& p) { p.begin[1] = 1000; });
  refused([](Cell_patches& p) { p.begin.clear(); });
  EXPECT_THROW(patches_of_cell(good, 8), std::invalid_argument);
  EXPECT_EQ(surface.number_of_faces(), 0U);
}
