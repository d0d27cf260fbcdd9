// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of vertices propose motions, the most frequent ones are refined on a part of the features, the best of these on all,
// and what is left has to stand a test.
#include <CGAL/Extremal_mesh_3/register.h>

#include "../differential/vector.h"
#include "align_finely.h"
#include "evidence.h"
#include "least_squares.h"
#include "propose.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// a positive number among the parameters of a mesh; 0 if there is none.
double parameter(const Extremal_mesh& mesh, const char* name) {
  const nlohmann::json parameters = nlohmann::json::parse(mesh.surface().parameters, nullptr, false);
  if (!parameters.is_object() || !parameters.contains(name) || !parameters[name].is_number())
    return 0;
  return std::max(0.0, parameters[name].get<double>());
}

/// in the unit of the mesh.
double tolerance_of(const Extremal_mesh& mesh) {
  double tolerance = parameter(mesh, "voxel");
  if (!(tolerance > 0))
    tolerance = parameter(mesh, "sigma");
  const double root_area = std::sqrt(std::max(0.0, mesh.surface().area));
  if (!(tolerance > 0))
    tolerance = 0.01 * root_area;
  return tolerance;
}

/// how large a cell is, across.
double cell_size(const Extremal_mesh& mesh) {
  return mesh.number_of_cells() > 0 ? std::sqrt(std::max(0.0, mesh.surface().area) / double(mesh.number_of_cells()))
                                    : 0;
}

void require_in_range(const Registration_options& options) {
  if (!(options.tolerance >= 0) || std::isinf(options.tolerance))
    throw std::invalid_argument(fmt::format("the tolerance is {}, not a positive length or 0", options.tolerance));
  if (options.most_vertices < 3)
    throw std::invalid_argument(fmt::format("{} vertices are too few for a motion", options.most_vertices));
}

template <class T> std::vector<T> some_of(const std::vector<T>& all, std::size_t most) {
  std::vector<T> some;
  const std::size_t step = 1 + all.size() / most;
  for (std::size_t i = 0; i < all.size(); i += step)
    some.push_back(all[i]);
  return some;
}

/// A motion that was refined, and what speaks for it.
struct Candidate {
  Alignment alignment;
  double score = 0; ///< the share of vertices that match, plus that of samples on the surface
  bool reversed = false, mirrored = false;
};

/// One registration under way.
class Registrar {
public:
  Registrar(const Extremal_mesh& a, const Extremal_mesh& b, const Registration_options& options)
      : a_(a), b_(b), options_(options), threads_(options.threads),
        tolerance_(options.tolerance > 0 ? options.tolerance : default_tolerance(a, b)), sigma_(parameter(b, "sigma")) {
  }

  Registration run() {
    Registration result;
    result.tolerance = tolerance_;
    const std::vector<Feature> vertices_a = vertex_features(a_), vertices_b = vertex_features(b_);
    if (vertices_a.size() < 3 || vertices_b.size() < 3 || !(tolerance_ > 0)) {
      result.reason = fmt::format("there are {} and {} extremal points and umbilics, too few to tell a motion",
                                  vertices_a.size(), vertices_b.size());
      return result;
    }
    // Lines of the first mesh need to be as dense as errors are independent, those of the second dense enough to be met.
    Features a = line_features(a_, tolerance_, most_sparse), b = line_features(b_, tolerance_ / 2, most_dense);
    a.vertices = first_of(vertices_a, options_.most_vertices);
    b.vertices = first_of(vertices_b, 2 * options_.most_vertices);
    const Target target(b);
    for (const bool mirrored : {false, true}) {
      if (mirrored && !options_.mirror)
        break;
      const Features side = mirrored ? a.mirrored() : a;
      for (const bool reversed : {false, true}) {
        attempt(reversed ? side.turned_over() : side, target, reversed, mirrored, result);
        if (result.found) {
          refine(a, target, result);
          match(result, vertices_a, vertices_b);
          return result;
        }
      }
    }
    return result;
  }

private:
  static constexpr std::size_t most_sparse = 8000, most_dense = 150000;

  static std::vector<Feature> first_of(const std::vector<Feature>& all, std::size_t most) {
    return {all.begin(), all.begin() + std::ptrdiff_t(std::min(all.size(), most))};
  }

  /// few enough features to try many motions.
  static Features part_of(const Features& a) {
    Features part;
    part.spacing = a.spacing * double(1 + a.samples.size() / 600);
    part.vertices = first_of(a.vertices, 300);
    part.samples = some_of(a.samples, 600);
    return part;
  }

  /// the distance within which the second mesh has lines everywhere.
  double reach() const { return std::max(4 * tolerance_, 0.7 * cell_size(b_)); }

  Alignment_options alignment_options(double first_gate, double last_gate) const {
    Alignment_options options;
    options.scale = options_.scale;
    options.first_gate = std::max(first_gate, last_gate);
    options.last_gate = last_gate;
    // Noise that a Gaussian has smoothed depends on itself over an area of 4πσ², about as wide as 3.5 σ; blocks of twice that hardly
    // depend on each other.
    options.block = std::max(6 * tolerance_, 7 * sigma_);
    return options;
  }

  double score(const Features& a, const Target& b, const Similarity& motion) const {
    double matched = 0, on_surface = 0;
    for (const Feature& f : a.vertices)
      matched += b.vertex_near(f, motion, 1.5 * tolerance_).has_value();
    for (const Line_sample& s : a.samples)
      if (const auto near = b.surface_near(s, motion, reach()))
        on_surface += std::abs(distance_from_surface(s, motion, b.features().samples[*near])) <= tolerance_ / 2;
    return matched / double(std::max<std::size_t>(1, a.vertices.size())) +
           on_surface / double(std::max<std::size_t>(1, a.samples.size()));
  }

  /// the motions that are proposed, refined on a part of the features; the best first.
  std::vector<Candidate> candidates(const Features& a, const Target& b, double& tried) {
    Proposal_options options;
    options.scale = options_.scale;
    options.tolerance = tolerance_;
    options.seed = options_.seed;
    const Proposals proposals = propose_motions(a.vertices, b.features().vertices, options, threads_);
    tried = double(proposals.tried);
    const Features part = part_of(a);
    std::vector<Candidate> result(proposals.motions.size());
    threads_.for_each(result.size(), 1, [&](std::size_t i) {
      const double wide = std::max(8 * tolerance_, 0.1 * proposals.baseline * proposals.motions[i].scale);
      result[i].alignment = align(part, b, proposals.motions[i], alignment_options(wide, 2 * tolerance_), nullptr);
      result[i].score = score(part, b, result[i].alignment.motion);
    });
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate& x, const Candidate& y) { return x.score > y.score; });
    return result;
  }

  /// a motion refined on all features, with what speaks for it.
  Registration tested(const Features& a, const Target& b, const Similarity& start, const Evidence_options& options) {
    Alignment_options fine = alignment_options(2 * tolerance_, 1.5 * tolerance_);
    fine.rounds = 30;
    const Alignment alignment = align(a, b, start, fine, &threads_);
    Registration r;
    r.tolerance = tolerance_;
    r.evidence = gather_evidence(a, b, alignment.motion, options, threads_);
    r.reason = objection(r.evidence, alignment, tolerance_);
    r.found = r.reason.empty();
    r.transform = alignment.motion;
    keep_errors(alignment, r);
    return r;
  }

  /// where the surfaces alone tell a motion, they may fit nearly as well otherwise, as an ellipsoid does with itself after half a turn, and the
  /// right motion may not have been proposed, as vertices are not in their places. So turns of all kinds are tried.
  std::vector<Similarity> best_turns(const Features& a, const Target& b, const Similarity& motion) {
    const Features part = part_of(a);
    Point centre{};
    for (const Line_sample& s : part.samples)
      centre = centre + 1 / double(part.samples.size()) * motion(s.point);
    constexpr std::size_t turns = 128; // within 30 degrees of any: less than from where smooth surfaces find each other
    std::vector<Alignment> all(turns);
    const double wide = std::max(8 * tolerance_, 0.1 * std::sqrt(std::max(0.0, b_.surface().area)));
    threads_.for_each(turns, 1, [&](std::size_t i) {
      Similarity turn;
      turn.rotation = uniform_rotation(i, turns);
      turn.translation = centre - turn(centre);
      Alignment_options options = alignment_options(wide, 2 * tolerance_);
      options.rounds = 20;
      all[i] = align(part, b, turn * motion, options, nullptr);
    });
    std::erase_if(all, [](const Alignment& x) { return !x.determined; });
    std::stable_sort(all.begin(), all.end(),
                     [](const Alignment& x, const Alignment& y) { return x.surface_rms < y.surface_rms; });
    std::vector<Similarity> best;
    constexpr std::size_t most = 4;
    for (const Alignment& x : all)
      if (best.size() < most &&
          std::all_of(best.begin(), best.end(), [&](const Similarity& s) { return differ(s, x.motion, part); }))
        best.push_back(x.motion);
    return best;
  }

  /// looks for a motion between one form of the first mesh and the second; keeps it if it is better than what there was.
  void attempt(const Features& a, const Target& b, bool reversed, bool mirrored, Registration& result) {
    double tried = 1;
    std::vector<Candidate> all = candidates(a, b, tried);
    constexpr std::size_t finalists = 4;
    all.resize(std::min(all.size(), finalists));
    // What is far behind will not catch up; what is hopeless, with hardly more in its place than by chance, need not try.
    constexpr double hopeless = 0.2;
    while (all.size() > 1 && (all.back().score < 0.6 * all.front().score || all.back().score < hopeless))
      all.pop_back();
    Evidence_options evidence_options{tolerance_, reach(), tried, options_.seed};
    std::vector<Registration> refined;
    const auto test = [&](const Similarity& start) {
      Registration r = tested(a, b, start, evidence_options);
      if (mirrored)
        r.transform = r.transform * mirror();
      r.normals_reversed = reversed;
      refined.push_back(std::move(r));
    };
    for (const Candidate& candidate : all)
      test(candidate.alignment.motion);
    std::stable_sort(refined.begin(), refined.end(), better);
    if (!refined.empty() && refined.front().found && !speaks_by_vertices(refined.front().evidence)) {
      const Similarity found = refined.front().transform;
      for (const Similarity& start : best_turns(a, b, mirrored ? found * mirror() : found))
        test(start);
      std::stable_sort(refined.begin(), refined.end(), better);
    }
    if (refined.empty()) {
      if (result.reason.empty())
        result.reason = "no pairs of vertices agree";
      return;
    }
    Registration& best = refined.front();
    if (!best.found && !result.reason.empty() && !better(best, result))
      return;
    for (std::size_t i = 1; i < refined.size(); ++i)
      if (refined[i].found && differ(best.transform, refined[i].transform, a) &&
          weight_of(refined[i]) > 0.9 * weight_of(best))
        best.alternatives.push_back(refined[i].transform);
    result = std::move(best);
  }

  static void keep_errors(const Alignment& alignment, Registration& r) {
    r.surface_rms = alignment.surface_rms;
    r.centre = alignment.centre;
    r.rotation_error = alignment.rotation_error;
    r.translation_error = alignment.translation_error;
    r.scale_error = alignment.scale_error;
  }

  /// the motion that was found, as exactly as noise allows.
  void refine(const Features& a, const Target& b, Registration& result) {
    const bool mirrored = result.transform.mirrors();
    const auto side = [&](const Features& f) {
      const Features turned = result.normals_reversed ? f.turned_over() : f;
      return mirrored ? turned.mirrored() : turned;
    };
    const Features sparse_a = side(a), dense_a = side(line_features(a_, tolerance_ / 2, most_dense)),
                   sparse_b = line_features(b_, tolerance_, most_sparse);
    Alignment start;
    start.motion = mirrored ? result.transform * mirror() : result.transform;
    const Alignment alignment = align_finely({sparse_a, Target(dense_a)}, {sparse_b, b}, start,
                                             alignment_options(1.5 * tolerance_, 1.5 * tolerance_), threads_);
    result.transform = mirrored ? alignment.motion * mirror() : alignment.motion;
    keep_errors(alignment, result);
  }

  static Similarity mirror() {
    Similarity m;
    m.rotation[0][0] = -1;
    return m;
  }
  static double weight_of(const Registration& r) { return double(r.evidence.matched) + r.evidence.overlap; }
  static bool better(const Registration& x, const Registration& y) {
    if (x.found != y.found)
      return x.found;
    const bool by_vertices = speaks_by_vertices(x.evidence);
    if (by_vertices != speaks_by_vertices(y.evidence))
      return by_vertices;
    if (x.found && !by_vertices) // vertices say little
      return x.surface_rms < y.surface_rms;
    return weight_of(x) > weight_of(y);
  }
  /// do two motions take something to different places?
  bool differ(const Similarity& s, const Similarity& t, const Features& a) const {
    return std::any_of(a.vertices.begin(), a.vertices.end(),
                       [&](const Feature& f) { return distance(s(f.point), t(f.point)) > 3 * tolerance_; });
  }

  /// the vertices of both meshes that are the same: each the other's nearest of its kind.
  void match(Registration& result, const std::vector<Feature>& a, const std::vector<Feature>& b) {
    Features fa, fb;
    fa.vertices = a;
    fb.vertices = b;
    if (result.normals_reversed)
      fa = fa.turned_over();
    Similarity motion = result.transform;
    if (motion.mirrors()) {
      fa = fa.mirrored();
      motion = motion * mirror();
    }
    const Target in_a(fa), in_b(fb);
    const Similarity back = motion.inverse();
    double squares = 0;
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      const auto j = in_b.vertex_near(fa.vertices[i], motion, tolerance_);
      if (!j || in_a.vertex_near(fb.vertices[*j], back, tolerance_ / motion.scale) != i)
        continue;
      const double d = distance(motion(fa.vertices[i].point), b[*j].point);
      result.matched.push_back({a[i].vertex, b[*j].vertex, d});
      squares += d * d;
    }
    if (!result.matched.empty())
      result.rms = std::sqrt(squares / double(result.matched.size()));
  }

  const Extremal_mesh &a_, &b_;
  Registration_options options_;
  Thread_pool threads_;
  double tolerance_;
  double sigma_; ///< of the second mesh's image; 0: there is none
};

} // namespace

double default_tolerance(const Extremal_mesh& a, const Extremal_mesh& b) {
  double tolerance = std::max(tolerance_of(a), tolerance_of(b));
  for (const Extremal_mesh* mesh : {&a, &b})
    if (mesh->number_of_vertices() > 0 && mesh->surface().area > 0)
      tolerance =
          std::min(tolerance, 0.25 * std::sqrt(mesh->surface().area /
                                               double(std::min<std::size_t>(1500, mesh->number_of_vertices()))));
  return tolerance;
}

Registration register_extremal_meshes(const Extremal_mesh& a, const Extremal_mesh& b,
                                      const Registration_options& options) {
  require_in_range(options);
  return Registrar(a, b, options).run();
}

} // namespace CGAL::Extremal_mesh_3
