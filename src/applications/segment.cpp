// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Extremal_mesh_3/Patch_locator.h>
#include <CGAL/Extremal_mesh_3/internal/manifold_patches.h>
#include <CGAL/Extremal_mesh_3/segment.h>

#include "../algorithms/patches.h"
#include "../cells/Union_find.h"
#include "../cells/bounding_box.h"
#include "../cells/parallel.h"
#include "../differential/vector.h"
#include "triangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// What samples tell of one face.
struct Face_label {
  std::uint32_t cell = 0;
  bool is_cut = false;
  double distance = 0; ///< the largest
};

/// The barycentric coordinates of the middles of 16 equal triangles.
std::array<std::array<double, 3>, 16> sample_places() {
  constexpr int n = 4;
  std::array<std::array<double, 3>, 16> places;
  std::size_t k = 0;
  const auto add = [&](double i, double j) { places[k++] = {i / n, j / n, 1 - (i + j) / n}; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < n)
        add(i + 2.0 / 3, j + 2.0 / 3);
    }
  return places;
}

class Labeller {
public:
  explicit Labeller(const Patch_locator& locator) : locator_(locator) {}

  Face_label label(std::span<const Point> face) const {
    Face_label result;
    std::vector<Corners> triangles;
    append_triangles(face, triangles);
    std::map<std::uint32_t, double> votes; // in the order of the cells
    const auto sample = [&](const Corners& t, const std::array<double, 3>& place, double weight) {
      const auto found = locator_.nearest(place[0] * t[0] + place[1] * t[1] + place[2] * t[2]);
      votes[found->cell] += weight;
      result.distance = std::max(result.distance, found->distance);
    };
    constexpr double near = 0.8, rest = 0.1, third = 1.0 / 3;
    for (const Corners& t : triangles)
      for (const auto& place : {std::array{third, third, third}, std::array{near, rest, rest},
                                std::array{rest, near, rest}, std::array{rest, rest, near}})
        sample(t, place, 1);
    if (votes.size() > 1) {
      result.is_cut = true;
      votes.clear();
      static const auto places = sample_places();
      for (const Corners& t : triangles)
        for (const auto& place : places)
          sample(t, place, norm(cross(t[1] - t[0], t[2] - t[0])));
    }
    result.cell = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                    return a.second < b.second;
                  })->first;
    return result;
  }

private:
  const Patch_locator& locator_;
};

/// the faces of a surface, without cells.
Cell_patches faces_of(const Cell_complex& surface) {
  Cell_patches faces;
  faces.points = surface.points;
  faces.normals.resize(surface.points.size());
  for (std::size_t c = 0; c < surface.number_of_cells(); ++c) {
    const std::size_t first = faces.corners.size();
    for (std::size_t h = surface.cell_begin[c]; h < surface.cell_begin[c + 1]; ++h)
      faces.corners.push_back(surface.source(surface.half_edges[h]));
    const std::span<const std::uint32_t> corners = std::span(faces.corners).subspan(first);
    Vector area{};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      area = area + cross(faces.points[corners[i]] - faces.points[corners[0]],
                          faces.points[corners[i + 1]] - faces.points[corners[0]]);
    for (const std::uint32_t corner : corners)
      faces.normals[corner] = faces.normals[corner] + area;
    faces.begin.push_back(faces.corners.size());
  }
  for (Vector& n : faces.normals)
    n = norm(n) > 0 ? normalized(n) : Vector{0, 0, 1}; // of a point between opposite faces
  return faces;
}

double area_of(const Cell_patches& faces, std::size_t i) {
  std::vector<const Point*> corners;
  for (const std::uint32_t corner : polygon(faces, i))
    corners.push_back(&faces.points[corner]);
  return corners.size() < 3 ? 0 : triangles_of_polygon(corners).area;
}

/// counts the connected pieces of each cell.
void count_pieces(Segmentation& result) {
  const Cell_patches& faces = result.faces;
  Union_find pieces(faces.cell.size());
  // an edge within a cell is known by its ends and the cell
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> face_at;
  for (std::uint32_t i = 0; i < faces.cell.size(); ++i) {
    const auto corners = polygon(faces, i);
    for (std::size_t j = 0; j < corners.size(); ++j) {
      const auto [a, b] = std::minmax(corners[j], corners[(j + 1) % corners.size()]);
      const auto [found, is_new] = face_at.try_emplace({a, b, faces.cell[i]}, i);
      if (!is_new)
        pieces.unite(i, found->second);
    }
  }
  for (std::uint32_t i = 0; i < faces.cell.size(); ++i)
    if (pieces.find(i) == i)
      ++result.cells[faces.cell[i]].pieces;
}

void sum_up(const Extremal_mesh& mesh, Segmentation& result) {
  result.cells.resize(mesh.number_of_cells());
  for (std::size_t i = 0; i < result.faces.cell.size(); ++i) {
    Cell_share& share = result.cells[result.faces.cell[i]];
    const double area = area_of(result.faces, i);
    ++share.faces;
    share.area += area;
    result.area += area;
  }
  count_pieces(result);
}

} // namespace

Segmentation segment(const Cell_complex& surface, const Extremal_mesh& mesh, const Cell_patches& cells,
                     const Segmentation_options& options) {
  if (!(std::isfinite(options.tolerance) && options.tolerance >= 0))
    throw std::invalid_argument(fmt::format("the tolerance is {}, not a length of 0 or more", options.tolerance));
  require_cells_of(mesh, cells);
  if (cells.cell.empty())
    throw std::invalid_argument("the surface of the cells has no polygon");
  constexpr double share_of_size = 0.01;
  const double tolerance = options.tolerance > 0 ? options.tolerance : share_of_size * diagonal_of(cells.points);

  Segmentation result;
  result.faces = faces_of(surface);
  const std::size_t n = surface.number_of_cells();
  std::vector<Face_label> labels(n);
  const Patch_locator locator(internal::manifold_patches(cells)); // has no polygons of two corners
  const Labeller labeller(locator);
  Thread_pool threads(options.threads);
  constexpr std::size_t block = 1 << 14, grain = 64;
  for (std::size_t first = 0; first < n; first += block) {
    if (options.progress && !options.progress(double(first) / double(n)))
      throw Cancelled();
    threads.for_each(std::min(block, n - first), grain, [&](std::size_t i) {
      std::vector<Point> face;
      for (const std::uint32_t corner : polygon(result.faces, first + i))
        face.push_back(result.faces.points[corner]);
      labels[first + i] = labeller.label(face);
    });
  }
  for (std::size_t i = 0; i < n; ++i)
    result.faces.cell.push_back(labels[i].cell);
  sum_up(mesh, result);
  for (std::size_t i = 0; i < n; ++i) {
    result.largest_distance = std::max(result.largest_distance, labels[i].distance);
    const bool is_away = labels[i].distance > tolerance;
    if (!labels[i].is_cut && !is_away)
      continue;
    const double area = area_of(result.faces, i);
    if (labels[i].is_cut) {
      ++result.cut_faces;
      result.cut_area += area;
    }
    if (is_away) {
      ++result.away_faces;
      result.away_area += area;
    }
  }
  constexpr double strange_share = 0.1;
  if (result.away_area > mesh.surface().degenerate_area + strange_share * result.area)
    throw std::invalid_argument(
        fmt::format("{:.3g} % of the surface are farther than {:.4g} from the cells of the extremal mesh, up to {:.4g}",
                    100 * result.away_area / result.area, tolerance, result.largest_distance));
  return result;
}

Segmentation segment(const Extremal_mesh& mesh, const Cell_patches& cells) {
  require_cells_of(mesh, cells);
  Segmentation result;
  result.faces = cells;
  sum_up(mesh, result);
  return result;
}

} // namespace CGAL::Extremal_mesh_3
