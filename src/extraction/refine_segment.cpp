// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Type changes are zeros of three functions on the line. Where the signs of one differ at the ends there is one zero to be
// found; of two zeros in one segment the slopes before and behind it tell.
#include "refine_segment.h"

#include "../differential/vector.h"
#include "place_on_line.h"
#include "walk_along_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Extremal_mesh_3 {

namespace {

/// The line is looked for within this many times the distance along the chord to its nearer end: it would have to leave
/// its end at more than 71° from the chord to be missed.
constexpr double widest = 3;
constexpr double widest_if_uncertain = 0.3;
/// The same where the cell lies on the surface the other way round, as it may be with tiny ones: left is right there.
constexpr double widest_turned = 0.2;
/// A line that is farther than this part of the chord from it is looked at in two halves.
constexpr double strong_bend = 0.25;
/// A type change nearer to another point than this part of the segment is taken for one at that point.
constexpr double nearest = 1e-9;
/// How near to an umbilic the sign of ∇e_i·t_i is taken for the one that it has there, in parts of the segment.
constexpr double beside_umbilic = 0.02;
/// Values that are less than this part of what they are differences of are 0.
constexpr double rounding = 1e-9;
/// A root is found when a step is less than this part of the segment: the next one would be less by far.
constexpr double settled = 1e-10;
/// A segment is divided at most so many times: into a thousand pieces.
constexpr int most_halvings = 10;

double quantity(const Line_place& at, Type_change_kind kind, int family) {
  switch (kind) {
  case Type_change_kind::turning_point:
    return at.derivative;
  case Type_change_kind::equal_curvatures:
    return at.k1 + at.k2;
  default:
    return family == 1 ? at.k1 : at.k2;
  }
}

/// what a quantity is when it is 0 but for rounding.
double noise(const Line_place& at, Type_change_kind kind) {
  const double k = std::max(std::abs(at.k1), std::abs(at.k2));
  return rounding * (kind == Type_change_kind::turning_point ? k * (at.extremality + k * k) : k);
}

constexpr std::array kinds = {Type_change_kind::turning_point, Type_change_kind::equal_curvatures,
                              Type_change_kind::parabolic_point};

bool changes_sign(const Line_place& a, const Line_place& b, Type_change_kind kind, int family) {
  const double at_a = quantity(a, kind, family), at_b = quantity(b, kind, family);
  return ((at_a < 0 && at_b >= 0) || (at_a >= 0 && at_b < 0)) && // neither is NaN
         (std::abs(at_a) > noise(a, kind) || std::abs(at_b) > noise(b, kind));
}

/// where in (0, 1) between two places a quantity that has the same sign at both may vanish twice in between: a convex
/// function keeps above the lines through its values before and after.
std::optional<double> lowest_point(const Line_place* before, const Line_place& a, const Line_place& b,
                                   const Line_place* after, Type_change_kind kind, int family) {
  if (!before || !after)
    return std::nullopt;
  const double sign = quantity(a, kind, family) < 0 ? -1 : 1;
  const auto value = [&](const Line_place& at) { return sign * quantity(at, kind, family); };
  const double length = distance(a.p, b.p), at_a = value(a), at_b = value(b);
  const double down = (at_a - value(*before)) / distance(before->p, a.p) * length;
  const double up = (value(*after) - at_b) / distance(b.p, after->p) * length;
  const double t = (at_b - at_a - up) / (down - up);
  constexpr double margin = 0.25; // as no function is quite convex
  if (down < 0 && up > 0 && t > 0 && t < 1 && at_a + down * t < margin * std::min(at_a, at_b) && at_b > noise(b, kind))
    return t;
  return std::nullopt;
}

/// A line that leaves an end of a segment by more than this from its direction is followed more closely, if no tolerance
/// is given: so that it keeps to this part of the segment's length.
constexpr double greatest_angle = 0.25, part_of_length = 0.03;

/// the tangent at one of two places, along the way from the one to the other; 0 if it is not known.
Vector tangent_along(const Line_place& at, const Vector& way) {
  return dot(at.tangent, way) < 0 ? -1 * at.tangent : at.tangent;
}

bool is_bent(const Segment& segment) {
  const Vector way = normalized(segment.ends[1].at.p - segment.ends[0].at.p);
  return std::any_of(segment.ends.begin(), segment.ends.end(), [&](const Segment::End& end) {
    const Vector t = tangent_along(end.at, way);
    return dot(t, t) > 0 && norm(t - way) > greatest_angle;
  });
}

/// how far the line should be from the middle of the chord between two places, to the left: that of the cubic with the tangents
/// there.
double expected_bend(const Line_place& a, const Line_place& b) {
  const Vector way = b.p - a.p, left = normalized(cross(a.n + b.n, way));
  constexpr double steepest = 1;
  const double length = norm(way);
  double bend = 0;
  for (const auto& [at, sign] : {std::pair{&a, 1.0}, std::pair{&b, -1.0}}) {
    const Vector t = tangent_along(*at, way);
    const double forward = dot(t, way) / length;
    if (forward > 0)
      bend += sign * std::clamp(dot(t, left) / forward, -steepest, steepest) * length / 8;
  }
  return bend;
}

/// A place on the segment at the parameter t of its chord.
struct Station {
  double t = 0;
  double offset = 0; ///< of the line from the chord
  Line_point at;
};

class Segment_refiner {
public:
  Segment_refiner(const Surface& surface, const Segment& segment, double tolerance)
      : surface_(surface), segment_(segment), length_(distance(segment.ends[0].at.p, segment.ends[1].at.p)),
        tolerance_(tolerance > 0 || !segment.may_bend || !is_bent(segment) ? tolerance : part_of_length * length_) {}

  Segment_points refine() {
    // Where the phase is rough a piece need not be straighter than the whole, nor shorter.
    const bool may_be_divided = segment_.may_bend && segment_.divided < most_halvings;
    if (may_be_divided && segment_.certain)
      if (const auto points = walk_along_line(surface_, segment_); !points.empty())
        return refine_pieces(points);
    if (may_be_divided)
      if (const auto placed = place(segment_.ends[0].at, segment_.ends[1].at, 0.5,
                                    expected_bend(segment_.ends[0].at, segment_.ends[1].at));
          placed && std::abs(placed->offset) > strong_bend * length_) {
        // Where the phase turns steeply this may be another line: the tangents at the ends do not bend it so.
        if (segment_.certain)
          if (const auto points = walk_along_line(surface_, segment_, true); !points.empty())
            return refine_pieces(points);
        return refine_pieces({line_place(surface_, placed->sample, segment_.family, 1e-3 * length_)});
      }
    if (!find_type_changes()) {
      result_.straight = true;
      return std::move(result_);
    }
    for (std::size_t i = 0; i + 1 < stations_.size(); ++i) {
      if (i > 0)
        result_.points.push_back(stations_[i].at);
      if (tolerance_ > 0)
        follow(stations_[i].at, stations_[i + 1].at);
    }
    return std::move(result_);
  }

private:
  std::optional<Placed_on_line> place(const Line_place& a, const Line_place& b, double t, double guess) const;
  std::optional<Station> station(double t) const;
  Segment_points refine_pieces(const std::vector<Line_place>& points) const;
  bool find_type_changes();
  bool find_zero(Station low, Station high, Type_change_kind kind);
  std::optional<Station> search_dip(const Station& low, const Station& high, double t, Type_change_kind kind) const;
  void follow(const Line_place& a, const Line_place& b);
  bool follow(const Line_place& a, const Line_place& middle, const Line_place& b, int level);
  std::optional<Line_place> middle_of(const Line_place& a, const Line_place& b) const;

  const Surface& surface_;
  const Segment& segment_;
  const double length_, tolerance_;
  std::vector<Station> stations_; ///< in order, with the ends
  Segment_points result_;
};

/// the point of the line beside the chord from a to b at t.
/// \param guess  of its distance from the chord, to the left
std::optional<Placed_on_line> Segment_refiner::place(const Line_place& a, const Line_place& b, double t,
                                                     double guess) const {
  const auto search = [&](double sign_on_left, double wide) {
    return place_on_line(surface_, {a, b, segment_.family, sign_on_left}, t, guess, wide);
  };
  const auto placed = search(segment_.sign_on_left, segment_.certain ? widest : widest_if_uncertain);
  return placed ? placed : search(-segment_.sign_on_left, widest_turned);
}

/// the place at t on the chord between the ends.
std::optional<Station> Segment_refiner::station(double t) const {
  const auto& [a, b] = segment_.ends;
  Placed_on_line placed;
  if (surface_.interpolates()) {
    placed.sample = sample_between(surface_, a.sample, b.sample, t);
  } else {
    // The nearest place that is known tells how far the line bends.
    double guess = 0, nearest_t = 2;
    for (const Station& other : stations_)
      if (other.t > 0 && other.t < 1 && std::abs(other.t - t) < nearest_t) {
        nearest_t = std::abs(other.t - t);
        guess = other.offset * t * (1 - t) / (other.t * (1 - other.t));
      }
    const auto on_line = place(a.at, b.at, t, guess);
    if (!on_line)
      return std::nullopt;
    placed = *on_line;
  }
  Station result{t, placed.offset, {}};
  static_cast<Line_place&>(result.at) = line_place(surface_, placed.sample, segment_.family, 1e-3 * length_);
  return result;
}

/// refines the pieces between points of the line, each for itself.
Segment_points Segment_refiner::refine_pieces(const std::vector<Line_place>& points) const {
  Segment_points result;
  bool keep = tolerance_ > 0;
  for (std::size_t i = 0; i <= points.size(); ++i) {
    Segment piece = segment_;
    ++piece.divided;
    if (i > 0) {
      piece.ends[0] = {};
      piece.ends[0].at = points[i - 1];
      piece.ends[0].behind = i > 1 ? points[i - 2] : segment_.ends[0].at;
    }
    if (i < points.size()) {
      piece.ends[1] = {};
      piece.ends[1].at = points[i];
      piece.ends[1].behind = i + 1 < points.size() ? points[i + 1] : segment_.ends[1].at;
    }
    const Segment_points found = refine_segment(surface_, piece, tolerance_);
    result.straight = result.straight || found.straight;
    keep = keep || !found.points.empty();
    result.points.insert(result.points.end(), found.points.begin(), found.points.end());
    if (i < points.size())
      static_cast<Line_place&>(result.points.emplace_back()) = points[i];
  }
  if (!keep)
    result.points.clear();
  return result;
}

/// fills `stations_` with the ends, the type changes, and what separates these.
/// \return false if one that there is could not be placed
bool Segment_refiner::find_type_changes() {
  const auto& ends = segment_.ends;
  for (const auto& end : ends) {
    Station s;
    s.t = &end == &ends[0] ? 0 : 1;
    static_cast<Line_place&>(s.at) = end.at;
    stations_.push_back(s);
  }
  if (!segment_.may_bend && !surface_.interpolates())
    return false;
  // Beside an umbilic, in place of what happens on the other side of it.
  for (const double t : {beside_umbilic, 0.5, 1 - beside_umbilic})
    if ((t <= 0.5 && ends[0].umbilic) || (t >= 0.5 && ends[1].umbilic))
      if (const auto s = station(t))
        stations_.insert(stations_.end() - 1, *s);
  const std::vector<Station> known = stations_;
  for (const Type_change_kind kind : kinds)
    for (std::size_t i = 0; i + 1 < known.size(); ++i) {
      const Line_place &a = known[i].at, &b = known[i + 1].at;
      if (changes_sign(a, b, kind, segment_.family)) {
        if (!find_zero(known[i], known[i + 1], kind))
          return false;
        continue;
      }
      const auto behind = [&](const Segment::End& end) { return end.behind ? &*end.behind : nullptr; };
      const Line_place* before = i > 0 ? &known[i - 1].at : behind(ends[0]);
      const Line_place* after = i + 2 < known.size() ? &known[i + 2].at : behind(ends[1]);
      const auto t = lowest_point(before, a, b, after, kind, segment_.family);
      if (!t || !segment_.may_bend)
        continue;
      const auto dip = search_dip(known[i], known[i + 1], *t, kind);
      if (!dip)
        continue;
      if (!find_zero(known[i], *dip, kind) || !find_zero(*dip, known[i + 1], kind))
        return false;
      stations_.push_back(*dip);
    }
  std::sort(stations_.begin(), stations_.end(), [](const Station& a, const Station& b) { return a.t < b.t; });
  // Two at one place are one; and where nothing changes nothing has to be kept apart.
  for (std::size_t i = 1; i + 1 < stations_.size();)
    if (stations_[i].t - stations_[i - 1].t < nearest || stations_.back().t - stations_[i].t < nearest)
      stations_.erase(stations_.begin() + std::ptrdiff_t(i));
    else
      ++i;
  if (std::none_of(stations_.begin(), stations_.end(), [](const Station& s) { return s.at.change.has_value(); }))
    stations_.erase(stations_.begin() + 1, stations_.end() - 1);
  return true;
}

/// a place at which a quantity has another sign than at both ends, if there is one: the least of parabolas through three
/// places.
std::optional<Station> Segment_refiner::search_dip(const Station& low, const Station& high, double t,
                                                   Type_change_kind kind) const {
  const auto value = [&](const Station& s) { return quantity(s.at, kind, segment_.family); };
  double a = low.t, b = high.t, at_a = value(low), at_b = value(high), middle = a + t * (b - a);
  double at_middle = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 5; ++i) {
    const auto s = station(i == 0 ? middle : t);
    if (!s)
      return std::nullopt;
    if (changes_sign(low.at, s->at, kind, segment_.family))
      return s;
    const double here = std::abs(value(*s));
    if (i == 0) {
      at_middle = here;
      at_a = std::abs(at_a);
      at_b = std::abs(at_b);
    } else if (here < at_middle) {
      (t < middle ? b : a) = middle;
      (t < middle ? at_b : at_a) = at_middle;
      middle = t;
      at_middle = here;
    } else {
      (t < middle ? a : b) = t;
      (t < middle ? at_a : at_b) = here;
    }
    const double p = (middle - a) * (at_middle - at_b), q = (middle - b) * (at_middle - at_a);
    t = middle - 0.5 * ((middle - a) * p - (middle - b) * q) / (p - q);
    if (!(t > a && t < b) || std::abs(t - middle) < 1e-3 * (high.t - low.t))
      return std::nullopt;
  }
  return std::nullopt;
}

/// adds the place between two at which a quantity vanishes.
bool Segment_refiner::find_zero(Station low, Station high, Type_change_kind kind) {
  const auto value = [&](const Station& s) { return quantity(s.at, kind, segment_.family); };
  double at_low = value(low), at_high = value(high), last = 2;
  const double zero = 1e-14 * std::max(std::abs(at_low), std::abs(at_high));
  std::optional<Station> s;
  double t_low = low.t, t_high = high.t;
  for (int i = 0; i < 60 && t_high - t_low > 1e-13; ++i) {
    double t = t_low - at_low * (t_high - t_low) / (at_high - at_low);
    if (!(t > t_low && t < t_high) || i % 8 == 7)
      t = t_low + (t_high - t_low) / 2;
    if (t < nearest || t > 1 - nearest) // too near to an end to be told from it
      return true;
    s = station(t);
    if (!s)
      return false;
    const double here = value(*s);
    if (std::abs(here) < zero || std::abs(t - last) < settled)
      break;
    last = t;
    const bool is_low = (here < 0) == (at_low < 0);
    double& kept = is_low ? at_high : at_low;
    const double factor = 1 - here / (is_low ? at_low : at_high);
    kept *= factor > 0 ? factor : 0.5;
    (is_low ? t_low : t_high) = t;
    (is_low ? at_low : at_high) = here;
  }
  if (!s)
    return true;
  s->at.change = kind;
  if (kind == Type_change_kind::turning_point) {
    s->at.derivative = 0;
  } else if (kind == Type_change_kind::equal_curvatures) {
    const double k = (s->at.k1 - s->at.k2) / 2;
    s->at.k1 = k;
    s->at.k2 = -k;
  } else {
    (segment_.family == 1 ? s->at.k1 : s->at.k2) = 0;
  }
  // Found before the others, and after its neighbours: sorted later.
  stations_.push_back(*s);
  return true;
}

std::optional<Line_place> Segment_refiner::middle_of(const Line_place& a, const Line_place& b) const {
  const auto s = place(a, b, 0.5, expected_bend(a, b));
  if (!s)
    return std::nullopt;
  return line_place(surface_, s->sample, segment_.family, 1e-3 * length_);
}

/// adds the points between two that the tolerance asks for.
void Segment_refiner::follow(const Line_place& a, const Line_place& b) {
  if (distance(a.p, b.p) < tolerance_) // nor will the line be longer by far
    return;
  const auto middle = middle_of(a, b);
  if (!middle || !follow(a, *middle, b, 0))
    result_.straight = true;
}

/// \param middle  the point of the line half way between a and b
bool Segment_refiner::follow(const Line_place& a, const Line_place& middle, const Line_place& b, int level) {
  if (distance(a.p, b.p) < tolerance_) // nor will the line be longer by far
    return true;
  const auto first = middle_of(a, middle), second = middle_of(middle, b);
  const auto off = [&](const Line_place& at) { // the distance from the chord
    const Vector chord = normalized(b.p - a.p), d = at.p - a.p;
    return norm(d - dot(d, chord) * chord);
  };
  // The greatest distance is that of the middle if the line bends to one side, of the quarters if to both.
  constexpr double safety = 0.9;
  const double farthest = std::max({off(middle), first ? off(*first) : 0, second ? off(*second) : 0});
  if (farthest < safety * tolerance_)
    return first && second;
  if (level == most_halvings || !first || !second) {
    Line_point point;
    static_cast<Line_place&>(point) = middle;
    result_.points.push_back(point);
    return false;
  }
  const bool good = follow(a, *first, middle, level + 1);
  Line_point point;
  static_cast<Line_place&>(point) = middle;
  result_.points.push_back(point);
  return follow(middle, *second, b, level + 1) && good;
}

} // namespace

Line_place line_place(const Surface& surface, Sample s, int family, double step) {
  surface.add_fourth(s);
  const Principal_quantities q = principal_quantities(s.shape);
  const double derivative = surface.extremality_derivative(s, family, step);
  Line_place place{s.p,
                   s.shape.n,
                   q.k1,
                   q.k2,
                   std::isfinite(derivative) ? derivative : 0, // infinite where k1 = k2
                   std::abs(family == 1 ? q.e2 : q.e1),
                   {}};
  if (s.has_fourth) {
    // Along the line the phase of Φ = P² Q does not change.
    const auto [x, y] = phase_gradient(s);
    const double slope = std::sqrt(x * x + y * y);
    if (std::isfinite(slope) && slope > 0)
      place.tangent = (-y / slope) * s.shape.u + (x / slope) * s.shape.v();
  }
  return place;
}

bool may_have_points(const Segment& segment, double tolerance) {
  const auto &a = segment.ends[0], &b = segment.ends[1];
  if (tolerance > 0 || (segment.may_bend && (a.umbilic || b.umbilic || is_bent(segment))))
    return true;
  return std::any_of(kinds.begin(), kinds.end(), [&](Type_change_kind kind) {
    return changes_sign(a.at, b.at, kind, segment.family) ||
           (segment.may_bend && lowest_point(a.behind ? &*a.behind : nullptr, a.at, b.at,
                                             b.behind ? &*b.behind : nullptr, kind, segment.family));
  });
}

Segment_points refine_segment(const Surface& surface, const Segment& segment, double tolerance) {
  return Segment_refiner(surface, segment, tolerance).refine();
}

} // namespace CGAL::Extremal_mesh_3
