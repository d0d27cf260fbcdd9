// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Features.h"

#include "../differential/vector.h"
#include "../queries/require.h"

#include <CGAL/Extremal_mesh_3/measures.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace CGAL::Extremal_mesh_3 {

namespace {

bool is_max(Line_type type) {
  return type == Line_type::max_largest || type == Line_type::max_second;
}

/// `Line_type` tells whether |k| is maximal. Near k = 0 that depends on the noise, whether k itself is does not.
bool is_signed_max(Line_type type, double k) {
  return is_max(type) == (k > 0);
}

/// how persistent each vertex is. A mesh that cannot be simplified has the stabilities instead, of the same unit.
std::vector<double> persistences(const Extremal_mesh& mesh) {
  try {
    return Simplification(mesh).vertex_persistence();
  } catch (const std::invalid_argument&) {
    std::vector<double> result;
    for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v)
      result.push_back(vertex_measures(mesh, v).stability);
    return result;
  }
}

/// how high the surface is above a chord, at t of the way from one end to the other: the cubic with the slopes that the normals
/// tell. Polylines are so coarse that chords lie farther below it than noise moves it.
Vector height_over_chord(const Vector& chord, const Vector& n0, const Vector& n1, double t) {
  const double length = norm(chord);
  const Vector along = 1 / length * chord, mean = n0 + n1, up = mean - dot(mean, along) * along;
  const double size = norm(up);
  if (!(size > 0.5)) // the chord does not lie along the surface
    return {};
  const Vector n = 1 / size * up;
  const auto slope = [&](const Vector& normal) {
    const double rise = -dot(normal, along), run = dot(normal, n);
    return std::abs(rise) < run ? rise / run : 0; // more than 45 degrees within a chord: an edge of the surface
  };
  return length * t * (1 - t) * ((1 - t) * slope(n0) - t * slope(n1)) * n;
}

/// at t of the way along the segment s of an edge. Nothing where the polyline jumps as the surface has an edge.
std::optional<Line_sample> sample_of(const Extremal_mesh_edge& e, std::size_t s, double t) {
  const Vector chord = e.polyline[s + 1] - e.polyline[s];
  const Vector mean = (1 - t) * e.normals[s] + t * e.normals[s + 1];
  if (!(norm(mean) > 0.5))
    return std::nullopt;
  const double length = norm(chord);
  const auto between = [&](const std::vector<double>& k) { return (1 - t) * k[s] + t * k[s + 1]; };
  Line_sample sample;
  sample.point = e.polyline[s] + t * chord + height_over_chord(chord, e.normals[s], e.normals[s + 1], t);
  sample.normal = normalized(mean);
  sample.tangent = 1 / length * chord;
  sample.kind = std::uint8_t(int(e.family == 2) |
                             int(is_signed_max(e.segment_types[s], between(e.family == 1 ? e.k1 : e.k2))) << 1);
  const Vector turn = 1 / length * (e.normals[s + 1] - e.normals[s]);
  sample.bend[0] = dot(turn, sample.tangent);
  sample.bend[1] = dot(turn, cross(sample.normal, sample.tangent));
  sample.bend[2] = -between(e.k1) - between(e.k2) - sample.bend[0]; // the trace is −(k1 + k2)
  return sample;
}

std::uint8_t kind_of(const Extremal_mesh_vertex& v) {
  if (v.kind == Vertex_kind::umbilic)
    return v.umbilic_index > 0 ? 8 : 9;
  return std::uint8_t(int(is_signed_max(v.extrema[0], v.k1)) | int(is_signed_max(v.extrema[1], v.k2)) << 1 |
                      int(v.field_index > 0) << 2);
}

} // namespace

std::vector<Feature> vertex_features(const Extremal_mesh& mesh) {
  const std::vector<double> persistence = persistences(mesh);
  std::vector<Feature> features;
  for (std::uint32_t i = 0; i < mesh.number_of_vertices(); ++i) {
    const Extremal_mesh_vertex& v = mesh.vertex(i);
    if (v.kind != Vertex_kind::extremal_point && v.kind != Vertex_kind::umbilic)
      continue;
    require_finite(v.point);
    features.push_back({v.point, v.normal, v.t1, v.t2, v.k1, v.k2, kind_of(v), persistence[i], i});
  }
  std::stable_sort(features.begin(), features.end(),
                   [](const Feature& a, const Feature& b) { return a.persistence > b.persistence; });
  return features;
}

Features line_features(const Extremal_mesh& mesh, double spacing, std::size_t most) {
  double total = 0;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    total += mesh.edge(e).length;
  Features features;
  features.spacing = std::max(spacing, total / double(most));
  if (!(features.spacing > 0))
    return features;
  for (std::size_t i = 0; i < mesh.number_of_edges(); ++i) {
    const Extremal_mesh_edge& e = mesh.edge(i);
    double next = features.spacing / 2, walked = 0; // where on the edge the next sample is to be
    for (std::size_t s = 0; s + 1 < e.polyline.size(); ++s) {
      require_finite(e.polyline[s + 1]);
      const double length = distance(e.polyline[s], e.polyline[s + 1]);
      for (; next < walked + length; next += features.spacing)
        if (const auto sample = sample_of(e, s, (next - walked) / length))
          features.samples.push_back(*sample);
      walked += length;
    }
  }
  return features;
}

double Line_sample::bent(const Vector& w) const {
  const double a = dot(w, tangent), c = dot(w, cross(normal, tangent));
  return bend[0] * a * a + 2 * bend[1] * a * c + bend[2] * c * c;
}

Features Features::turned_over() const {
  Features result = *this;
  for (Feature& f : result.vertices) {
    f.normal = -f.normal;
    std::swap(f.t1, f.t2);
    f.k1 = -f.k1;
    f.k2 = -f.k2;
    std::swap(f.k1, f.k2);
    if (!f.is_umbilic()) // what was the maximum of k1 is the minimum of k2
      f.kind = std::uint8_t((f.kind & 4) | (~f.kind >> 1 & 1) | (~f.kind & 1) << 1);
  }
  for (Line_sample& s : result.samples) {
    s.normal = -s.normal;
    s.kind ^= 3;
    s.bend = {-s.bend[0], s.bend[1], -s.bend[2]}; // n × t turns over, too
  }
  return result;
}

Features Features::mirrored() const {
  Features result = *this;
  for (Feature& f : result.vertices) {
    for (Vector* v : {&f.point, &f.normal, &f.t1, &f.t2})
      (*v)[0] = -(*v)[0];
    f.t2 = -f.t2; // the frame is to be direct
  }
  for (Line_sample& s : result.samples) {
    for (Vector* v : {&s.point, &s.normal, &s.tangent})
      (*v)[0] = -(*v)[0];
    s.bend[1] = -s.bend[1]; // n × t is turned over against the mirror image
  }
  return result;
}

} // namespace CGAL::Extremal_mesh_3
