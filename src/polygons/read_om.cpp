// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenMesh's own format (OpenMesh/Core/IO/OMFormat.hh): chunks, of which the vertices' positions and, from version 2 on,
// the half-edges are needed, before that the faces. Little endian.
#include "Bytes.h"
#include "soup_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace CGAL::Extremal_mesh_3 {

namespace {

enum class Entity { vertex = 0, mesh = 1, face = 2, edge = 4, half_edge = 6, end = 7 };
enum class Content { position = 0, normal = 1, texture = 2, status = 3, colour = 4, custom = 6, topology = 7 };

/// 16 bits before each chunk.
struct Chunk {
  explicit Chunk(unsigned bits)
      : has_name((bits >> 1) & 1U), entity(static_cast<Entity>((bits >> 2) & 7U)),
        content(static_cast<Content>((bits >> 5) & 15U)), is_float((bits >> 10) & 1U),
        dimension(((bits >> 11) & 7U) + 1), log_size((bits >> 14) & 3U) {}

  bool has_name;
  Entity entity;
  Content content;
  bool is_float;
  unsigned dimension;
  unsigned log_size; // of a number: floats from 4 bytes on, integers from 1
};

class Om_reader {
public:
  explicit Om_reader(std::string_view content) : bytes_(content, 0, std::endian::little) {}

  Polygon_soup read() {
    const auto o = bytes_.next<char>("the letters OM"), m = bytes_.next<char>("the letters OM");
    if (o != 'O' || m != 'M')
      throw std::runtime_error("byte 0: expected the letters OM");
    sides_ = bytes_.next<char>("the kind of mesh");
    if (sides_ != 'T' && sides_ != 'Q' && sides_ != 'P')
      throw std::runtime_error("byte 2: expected the letter T, Q or P");
    const unsigned version = bytes_.next<std::uint8_t>("the version") >> 5U;
    vertices_ = bytes_.next<std::uint32_t>("the number of vertices");
    faces_ = bytes_.next<std::uint32_t>("the number of faces");
    edges_ = bytes_.next<std::uint32_t>("the number of edges");
    while (!(has_points_ && has_polygons_)) {
      const Chunk chunk(bytes_.next<std::uint16_t>("vertices and faces"));
      if (chunk.entity == Entity::end)
        throw std::runtime_error(
            fmt::format("byte {}: expected vertices and faces, found the end", bytes_.position() - 2));
      if (chunk.has_name)
        bytes_.skip(bytes_.next<std::uint8_t>("the length of a name"), 1, "a letter of a name");
      if (chunk.entity == Entity::vertex && chunk.content == Content::position && !has_points_)
        read_points(chunk);
      else if (chunk.entity == Entity::half_edge && chunk.content == Content::topology && version >= 2)
        read_half_edges(chunk);
      else if (chunk.entity == Entity::face && chunk.content == Content::topology && version < 2)
        read_faces(chunk);
      else
        skip(chunk);
    }
    return std::move(soup_);
  }

private:
  void read_points(const Chunk& chunk) {
    if (!chunk.is_float || chunk.dimension != 3 || chunk.log_size > 1)
      throw std::runtime_error(fmt::format("byte {}: expected points of three floats or doubles", bytes_.position()));
    bytes_.require(vertices_, 3 * (std::size_t(4) << chunk.log_size), "a point");
    const auto coordinate = [&] {
      return chunk.log_size == 0 ? bytes_.coordinate<float>() : bytes_.coordinate<double>();
    };
    for (std::uint32_t i = 0; i < vertices_; ++i) {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      soup_.points.push_back({x, y, z});
    }
    has_points_ = true;
  }

  std::int64_t integer(const Chunk& chunk, bool is_signed) {
    constexpr const char* what = "an index";
    switch (chunk.log_size) {
    case 0:
      return is_signed ? bytes_.next<std::int8_t>(what) : std::int64_t(bytes_.next<std::uint8_t>(what));
    case 1:
      return is_signed ? bytes_.next<std::int16_t>(what) : std::int64_t(bytes_.next<std::uint16_t>(what));
    case 2:
      return is_signed ? bytes_.next<std::int32_t>(what) : std::int64_t(bytes_.next<std::uint32_t>(what));
    default:
      return bytes_.next<std::int64_t>(what);
    }
  }

  /// an index from `low` on of one of n things.
  std::int64_t index(const Chunk& chunk, bool is_signed, std::int64_t low, std::int64_t n, const char* what) {
    const std::size_t place = bytes_.position();
    const std::int64_t i = integer(chunk, is_signed);
    if (i < low || i >= n)
      throw std::runtime_error(
          fmt::format("byte {}: expected the index of a {} from {} to {}, found {}", place, what, low, n - 1, i));
    return i;
  }

  void read_half_edges(const Chunk& chunk) {
    struct Half_edge {
      std::int64_t next, target, face;
    };
    const std::int64_t n = 2 * std::int64_t(edges_);
    bytes_.require(std::uint64_t(n), 3 * (std::size_t(1) << chunk.log_size), "a half-edge");
    std::vector<Half_edge> half_edges(static_cast<std::size_t>(n));
    for (Half_edge& h : half_edges) {
      h.next = index(chunk, true, 0, n, "half-edge");
      h.target = index(chunk, true, 0, vertices_, "vertex");
      h.face = index(chunk, true, -1, faces_, "face");
    }
    std::vector<std::pair<std::int64_t, Polygon>> faces;
    for (std::size_t start = 0; start < half_edges.size(); ++start)
      if (const std::int64_t face = half_edges[start].face; face != -1) {
        faces.emplace_back(face, Polygon());
        std::size_t h = start;
        do { // each half-edge leaves its face here, so that no walk is endless
          if (half_edges[h].face != face)
            throw std::runtime_error(fmt::format("the half-edges of face {}: expected a closed loop", face));
          faces.back().second.push_back(std::uint32_t(half_edges[h].target));
          half_edges[h].face = -1;
          h = std::size_t(half_edges[h].next);
        } while (h != start);
      }
    std::stable_sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [face, polygon] : faces)
      soup_.polygons.push_back(std::move(polygon));
    has_polygons_ = true;
  }

  void read_faces(const Chunk& chunk) {
    bytes_.require(faces_, std::size_t(1) << chunk.log_size, "a face");
    for (std::uint32_t f = 0; f < faces_; ++f) {
      Polygon polygon(sides_ == 'T' ? 3U : sides_ == 'Q' ? 4U : bytes_.next<std::uint16_t>("the number of sides"));
      for (std::uint32_t& corner : polygon)
        corner = std::uint32_t(index(chunk, false, 0, vertices_, "vertex"));
      soup_.polygons.push_back(std::move(polygon));
    }
    has_polygons_ = true;
  }

  void skip(const Chunk& chunk) {
    if (chunk.content == Content::custom)
      return bytes_.skip(bytes_.next<std::uint32_t>("the size of a property"), 1, "a byte of a property");
    const std::uint64_t n = chunk.entity == Entity::vertex      ? vertices_
                            : chunk.entity == Entity::face      ? faces_
                            : chunk.entity == Entity::edge      ? edges_
                            : chunk.entity == Entity::half_edge ? 2 * std::uint64_t(edges_)
                                                                : 1;
    // Topology pretends to be of floats.
    const bool is_integer = !chunk.is_float || chunk.content == Content::topology;
    const bool is_status = chunk.content == Content::status;
    bytes_.skip(n, is_status ? 4 : chunk.dimension * std::size_t(is_integer ? 1U : 4U) << chunk.log_size, "a property");
  }

  Bytes bytes_;
  char sides_ = 0;
  std::uint32_t vertices_ = 0, faces_ = 0, edges_ = 0;
  bool has_points_ = false, has_polygons_ = false;
  Polygon_soup soup_;
};

} // namespace

Polygon_soup read_om(std::string_view content) {
  return Om_reader(content).read();
}

} // namespace CGAL::Extremal_mesh_3
