// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "course_of_lines.h"

#include "degenerate_vertex.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double pi = std::numbers::pi;
/// A critical point that is farther from where Newton's method starts than this is another start's.
constexpr double farthest_first_step = 0.9;
/// What lies this little outside of a cell, with its middle as the centre, may as well lie inside.
constexpr double near = 0.9;
/// The error of the phase may change by this times itself over the cell.
constexpr double slope_of_error = 4;

/// the place of the greatest value of a function with one maximum in [low, high], by golden sections.
template <class Function> double place_of_maximum(const Function& f, double low, double high, int steps) {
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low), fa = f(a), fb = f(b);
  for (int i = 0; i < steps; ++i) {
    if (fa < fb) {
      low = a;
      a = b;
      fa = fb;
      b = low + golden * (high - low);
      fb = f(b);
    } else {
      high = b;
      b = a;
      fb = fa;
      a = high - golden * (high - low);
      fa = f(a);
    }
  }
  return (low + high) / 2;
}

/// A saddle nearer than this to a level is on it up to rounding: which way lines pass there is not to be known.
constexpr double least_height_of_saddle = 1e-8;
/// The same elsewhere. Beside a saddle on its level heights are far less than one would expect from the distance.
constexpr double rounding = 1e-13;

double distance_to_level(double phase) {
  return std::abs(phase - pi * std::round(phase / pi));
}

/// \return many if a phase is not a number
int levels_between(double a, double b) {
  constexpr double many = 1e6;
  const double levels = std::abs(std::floor(a / pi) - std::floor(b / pi));
  return int(levels < many ? levels : many);
}

class Course {
public:
  Course(const Refined_complex& complex, const std::vector<Half_edge>& border, const Border_crossings& met,
         const Cell_model& model, const Planar_polygon& polygon, int most_edge_level)
      : complex_(complex), border_(border), met_(met), model_(model), polygon_(polygon), corner_(polygon.corners()),
        phase_(border_phase(complex, border)), most_edge_level_(most_edge_level) {}

  /// the lines around the one vertex that the cell holds.
  Line_course around_vertex() {
    Line_course course;
    const std::vector<Critical_point> critical = critical_points();
    const bool border = border_is_certain(course.cuts);
    if (lines_seem_to_cross_beside_border(critical))
      course.cuts.clear();
    course.no_closed_line = std::all_of(critical.begin(), critical.end(), [](const auto& c) { return c.saddle; });
    course.certain = border && course.no_closed_line;
    return course;
  }

  Line_course find() {
    Line_course course;
    const std::vector<Critical_point> critical = critical_points();
    const bool joined = join(course.joined);
    course.no_closed_line = has_no_closed_line(critical);
    std::vector<Edge_cut> cuts;
    const bool border = border_is_certain(cuts);
    if (!cuts.empty() && (course.no_closed_line || !lines_seem_to_cross_beside_border(critical))) {
      course.cuts = std::move(cuts);
      return course;
    }
    course.certain = border && joined && course.no_closed_line;
    return course;
  }

private:
  Complex on_edge(std::size_t i, double t) const {
    return (1 - t) * corner_[i] + t * corner_[(i + 1) % corner_.size()];
  }

  /// P and Q turn by less than π between places near to each other, where their phase may turn further.
  using Fields = Cell_model::Fields;
  static double turn(const Fields& from, const Fields& to) {
    const Complex p = to.P * std::conj(from.P), q = to.Q * std::conj(from.Q);
    // Turns of less than π/4 cannot add up to half a turn.
    if (p.real() > std::abs(p.imag()) && q.real() > std::abs(q.imag()))
      return std::arg(p * p * q);
    return 2 * std::arg(p) + std::arg(q);
  }

  /// The phase along an edge at steps of 1/steps, lifted from the one at its first end.
  static constexpr int steps = 12;
  std::array<double, steps + 1> phases_on_edge(std::size_t i) const {
    std::array<double, steps + 1> result;
    Fields before = model_(on_edge(i, 0));
    result[0] = phase_[i];
    for (int k = 1; k <= steps; ++k) {
      const Fields here = model_(on_edge(i, double(k) / steps));
      result[std::size_t(k)] = result[std::size_t(k - 1)] + turn(before, here);
      before = here;
    }
    return result;
  }

  /// tells whether the phase is too flat for a level to be met on an edge that ends on one side of it.
  bool keeps_between_levels(std::size_t i) const {
    const double a = phase_[i], b = phase_[i + 1];
    const double length = std::sqrt(std::norm(corner_[(i + 1) % corner_.size()] - corner_[i]));
    const double beyond = (greatest_slope_ * length - std::abs(b - a)) / 2 + greatest_error_;
    const double least = std::min(a, b) - beyond, greatest = std::max(a, b) + beyond;
    return beyond < pi && levels_between(least, greatest) == 0;
  }

  /// tells whether each edge is crossed as often as it seems; asks for a cut where one is crossed twice more.
  bool border_is_certain(std::vector<Edge_cut>& cuts) const {
    bool certain = true;
    for (std::size_t i = 0; i < border_.size(); ++i) {
      if (keeps_between_levels(i))
        continue;
      const auto phases = phases_on_edge(i);
      const double end = phase_[i + 1];
      const int seen = levels_between(phases.front(), end);
      double hidden_at = 0, hidden = 0, before = phases.front();
      int crossed = 0;
      for (std::size_t k = 1; k < steps; ++k) {
        const double rise = phases[k] - phases[k - 1], on = phases[k + 1] - phases[k];
        // An extremum beside a sample at an end is seen in the slope there only.
        const bool turns = (rise < 0) != (on < 0) || (k == 1 && 2 * std::abs(rise) < std::abs(on)) ||
                           (k + 1 == steps && 2 * std::abs(on) < std::abs(rise));
        if (!turns)
          continue;
        const double turned = (rise < 0) != (on < 0)              ? (rise < 0 ? -1 : 1)
                              : 2 * std::abs(rise) < std::abs(on) ? (on < 0 ? 1 : -1)
                                                                  : (rise < 0 ? -1 : 1);
        const Fields base = model_(on_edge(i, double(k) / steps));
        const double t =
            place_of_maximum([&](double at) { return turned * turn(base, model_(on_edge(i, at))); },
                             double(k == 1 ? 0 : k - 1) / steps, double(k + 1 == steps ? steps : k + 1) / steps, 25);
        const double extreme = phases[k] + turn(base, model_(on_edge(i, t)));
        certain &= distance_to_level(extreme) > rounding + model_.phase_error(on_edge(i, t));
        crossed += levels_between(before, extreme);
        if (levels_between(before, extreme) > 0 && distance_to_level(extreme) > hidden) {
          hidden = distance_to_level(extreme);
          hidden_at = t;
        }
        before = extreme;
      }
      crossed += levels_between(before, end);
      if (crossed <= seen)
        continue;
      certain = false;
      const std::uint32_t edge = border_[i] / 2;
      if (hidden > 0 && hidden_at > 1e-3 && hidden_at < 1 - 1e-3 && complex_.edges()[edge].level < most_edge_level_)
        cuts.push_back({edge, border_[i] % 2 == 0 ? hidden_at : 1 - hidden_at});
    }
    return certain;
  }

  struct Critical_point {
    Complex z;
    double phase = 0; ///< lifted
    bool saddle = true;
  };

  /// the critical points of the phase in the cell.
  std::vector<Critical_point> critical_points() {
    std::vector<Critical_point> found;
    look_for_critical_points(0, 1, 0, found);
    return found;
  }

  /// An upper bound for how far the gradient of the logarithm of a field changes within the distance of a view; infinite if the
  /// field may vanish there.
  static double change_of_logarithm(const Field_view& v, double r) {
    const auto length = [](double a, double b) { return std::sqrt(a * a + b * b); };
    const double size = length(v.here.re.f, v.here.im.f);
    const double slope = length(length(v.here.re.x, v.here.re.y), length(v.here.im.x, v.here.im.y));
    const double change = slope * r + length(v.re.remainder, v.im.remainder), least = size - change;
    if (!(least > 0))
      return std::numeric_limits<double>::infinity();
    return (length(v.re.turn, v.im.turn) + slope * change / size) / least;
  }

  static double relative_error(const Field_view& v) {
    return std::sqrt((v.errors.re * v.errors.re + v.errors.im * v.errors.im) /
                     (v.here.re.f * v.here.re.f + v.here.im.f * v.here.im.f));
  }

  /// looks into the square about z with sides of 2 h: divides it until the phase keeps rising in one direction; else Newton's
  /// method decides.
  void look_for_critical_points(Complex z, double h, int depth, std::vector<Critical_point>& found) {
    constexpr int deepest = 2;
    constexpr double apart = 1e-4;
    const double r = depth == 0 ? 1 : std::numbers::sqrt2 * h; // the cell lies in the unit circle
    if (depth > 0 && !polygon_.contains(z) && polygon_.distance_to_border(z) > r)
      return;
    const Cell_model::Views v = model_.views(z, r);
    const auto slope = [](const Field_view& f) {
      const Complex inverse =
          1 / (f.here.re.f * f.here.re.f + f.here.im.f * f.here.im.f) * Complex(f.here.re.f, -f.here.im.f);
      return Complex((Complex(f.here.re.x, f.here.im.x) * inverse).imag(),
                     (Complex(f.here.re.y, f.here.im.y) * inverse).imag());
    };
    const double change = 2 * change_of_logarithm(v.P, r) + change_of_logarithm(v.Q, r);
    const double rise = std::sqrt(std::norm(2.0 * slope(v.P) + slope(v.Q)));
    if (depth == 0) {
      greatest_slope_ = rise + change;
      greatest_error_ = slope_of_error * (2 * relative_error(v.P) + relative_error(v.Q));
    }
    if (rise > change) {
      regular_ = regular_ && rise > change + slope_of_error * (2 * relative_error(v.P) + relative_error(v.Q));
      return;
    }
    regular_ = regular_ && depth < deepest;
    if (depth < deepest) {
      const double q = h / 2;
      for (const Complex d : {Complex(-q, -q), Complex(q, -q), Complex(-q, q), Complex(q, q)})
        look_for_critical_points(z + d, q, depth + 1, found);
      return;
    }
    if (!find_critical_point(z) || !polygon_.contains(near * z) ||
        std::any_of(found.begin(), found.end(), [&](const auto& c) { return std::norm(c.z - z) < apart * apart; }) ||
        vanishes(Field::P, z) || vanishes(Field::Q, z))
      return;
    // Lifted from the nearest corner, from where it turns little.
    const auto nearest = std::min_element(corner_.begin(), corner_.end(),
                                          [&](Complex a, Complex b) { return std::norm(a - z) < std::norm(b - z); });
    const double near_it = phase_[std::size_t(nearest - corner_.begin())] + turn(model_(*nearest), model_(z));
    // The model's own, which at the corner is a little different from the sample's.
    const double phase = near_it + std::remainder(std::arg(model_(z).phi()) - near_it, 2 * pi);
    found.push_back({z, phase, model_.slopes(z).hessian() < 0});
  }

  /// tells whether the field is 0 up to rounding.
  bool vanishes(Field field, Complex z) const {
    constexpr double nearest = 1e-6; // a zero would be
    const Field_jets f = model_.jets(field, z);
    const double slope2 = f.re.x * f.re.x + f.re.y * f.re.y + f.im.x * f.im.x + f.im.y * f.im.y;
    return f.re.f * f.re.f + f.im.f * f.im.f < nearest * nearest * slope2;
  }

  bool is_on_level(const Critical_point& c) const {
    return distance_to_level(c.phase) <= least_height_of_saddle + model_.phase_error(c.z);
  }

  bool is_well_inside(Complex z) const {
    for (std::size_t i = 0; i < corner_.size(); ++i) {
      const Complex a = corner_[i] - z, b = corner_[(i + 1) % corner_.size()] - z;
      if ((std::conj(a) * b).imag() < least_distance_of_vertex * std::abs(b - a))
        return false;
    }
    return true;
  }

  /// Cuts would pull corners towards the crossing: it would stay beside the border.
  bool lines_seem_to_cross_beside_border(const std::vector<Critical_point>& critical) const {
    return std::any_of(critical.begin(), critical.end(),
                       [&](const auto& c) { return c.saddle && is_on_level(c) && !is_well_inside(c.z); });
  }

  /// tells whether a straight way from an extremum to the border meets no level: then no line closes around it.
  bool is_open_to_border(const Critical_point& extremum) const {
    for (std::size_t i = 0; i < corner_.size(); ++i)
      if (levels_between(phase_[i], extremum.phase) == 0 && is_way_open(extremum, corner_[i]))
        return true;
    for (std::size_t i = 0; i < corner_.size(); ++i)
      if (is_way_open(extremum, on_edge(i, 0.5)))
        return true;
    return false;
  }

  bool is_way_open(const Critical_point& extremum, Complex to) const {
    constexpr int stations = 8;
    const auto off_level = [&](Complex z, double phase) {
      return levels_between(phase, extremum.phase) == 0 && distance_to_level(phase) > rounding + model_.phase_error(z);
    };
    Fields before = model_(extremum.z);
    double phase = extremum.phase;
    bool open = off_level(extremum.z, phase);
    for (int k = 1; k <= stations && open; ++k) {
      const Complex z = extremum.z + double(k) / stations * (to - extremum.z);
      const Fields here = model_(z);
      phase += turn(before, here);
      before = here;
      open = polygon_.contains(near * z) && off_level(z, phase);
    }
    return open;
  }

  /// tells whether no line closes inside: around one that does there would be an extremum of the phase.
  bool has_no_closed_line(const std::vector<Critical_point>& critical) const {
    return std::all_of(critical.begin(), critical.end(),
                       [&](const Critical_point& c) { return !is_on_level(c) && (c.saddle || is_open_to_border(c)); });
  }

  /// Newton's method for |P|² |Q|² ∇φ = 0, which is nearly a polynomial also where ∇φ is steep, beside where P nearly vanishes. Finds
  /// zeros of P and Q, too.
  bool find_critical_point(Complex& z) const {
    for (int k = 0; k < 15; ++k) {
      const auto s = model_.slopes(z);
      const double xx = s.xx + s.x * s.log_x, xy = s.xy + s.x * s.log_y, yx = s.xy + s.y * s.log_x,
                   yy = s.yy + s.y * s.log_y, det = xx * yy - xy * yx;
      Complex step((s.y * xy - s.x * yy) / det, (s.x * yx - s.y * xx) / det);
      const double length = std::sqrt(std::norm(step));
      if (!(length < (k == 0 ? farthest_first_step : 1e3)))
        return false;
      z += length > 0.5 ? 0.5 / length * step : step;
      if (std::norm(z) > 1.5 * 1.5)
        return false;
      if (length < 1e-8)
        return true;
    }
    return false;
  }

  /// A part of the border between two crossings.
  struct Interval {
    Complex best;      ///< the highest point
    double height = 0; ///< there
    double width = 0;  ///< the distance between the crossings
  };

  /// where about an edge is crossed, as far as the phases at its ends tell.
  Complex place_of(const Border_crossing& crossing, std::size_t edge) const {
    const double rise = phase_[edge + 1] - phase_[edge], t = (pi * crossing.level - phase_[edge]) / rise;
    return on_edge(edge, std::clamp(t, 0.0, 1.0));
  }

  /// the point of the border between crossings i and j, walking on from i, that is highest.
  template <class Height> Interval best_between(std::size_t i, std::size_t j, const Height& height) const {
    Interval interval{0, -1e300};
    const auto edge_of = [&](std::size_t c) {
      return std::size_t(std::find(border_.begin(), border_.end(), met_.crossings[c].half_edge) - border_.begin());
    };
    const std::size_t first = edge_of(i), last = edge_of(j), n = border_.size();
    interval.width = std::sqrt(std::norm(place_of(met_.crossings[i], first) - place_of(met_.crossings[j], last)));
    const auto look = [&](Complex z) {
      if (const double h = height(z); h > interval.height)
        interval = {z, h};
    };
    // Edges are crossed once: the interval goes from within `first` over corners to within `last`.
    for (std::size_t e = first; e != last; e = (e + 1) % n) {
      look(corner_[(e + 1) % n]);
      if (e != first)
        for (int k = 1; k < steps; ++k)
          look(on_edge(e, double(k) / steps));
    }
    return interval;
  }

  static constexpr double outside = -10; ///< lower than any height

  /// how far the height keeps above the error on the straight way from a to b, seen at steps that are the smaller the nearer they are to
  /// the gaps: there what parts the sides of the way may be as narrow as it is at the border.
  template <class Height>
  double clearance_between(Complex a, Complex b, const std::array<Interval, 2>& gaps, const Height& height) const {
    constexpr double longest = 0.02, part = 0.25, shortest = 1e-6;
    double step = longest;
    for (const Interval& gap : gaps)
      step = std::min(step, part * (gap.width + std::sqrt(std::norm(0.5 * (a + b) - gap.best))));
    if (std::norm(b - a) > std::max(step, shortest) * std::max(step, shortest)) {
      const Complex middle = 0.5 * (a + b);
      const double first = clearance_between(a, middle, gaps, height);
      return first > 0 ? std::min(first, clearance_between(middle, b, gaps, height)) : first;
    }
    return polygon_.contains(b) ? height(b) - model_.phase_error(b) - rounding : outside;
  }

  /// how far the height keeps above the error along the crest from one part of the border to another, inside.
  /// \param gaps  the parts between, where the border is on the other side of the level
  template <class Height>
  double clearance_along(const Interval& begin, const Interval& end, const std::array<Interval, 2>& gaps,
                         const Height& height) const {
    constexpr int stations = 32;
    constexpr double aside = 0.04;
    const Complex from = begin.best, to = end.best;
    const auto clear_at = [&](const Interval& i) { return i.height - model_.phase_error(i.best) - rounding; };
    double least = std::min(clear_at(begin), clear_at(end)), offset = 0;
    Complex last = from;
    const Complex along = to - from, across = Complex(0, 1) * along;
    for (int k = 1; k < stations && least > 0; ++k) {
      const double s = double(k) / stations;
      const auto at = [&](double o) { return from + s * along + o * across; };
      offset =
          place_of_maximum([&](double o) { return polygon_.contains(at(o)) ? height(at(o)) : outside - std::abs(o); },
                           offset - aside, offset + aside, 12);
      least = std::min(least, clearance_between(last, at(offset), gaps, height));
      last = at(offset);
    }
    // Up to the border itself, where rounding says which side is inside.
    const Complex beside = to + 1e-3 * (last - to);
    return least > 0 ? std::min(least, clearance_between(last, beside, gaps, height)) : least;
  }

  /// tells whether the border rises and falls far enough over and under a level. If not, what is beyond it may be the tip
  /// of something that goes on inside.
  bool both_sides_are_clear(std::int32_t level) const {
    bool above = false, below = false;
    for (std::size_t i = 0; i < corner_.size(); ++i) {
      const double height = phase_[i] - pi * level, error = model_.phase_error(corner_[i]);
      above = above || height > error;
      below = below || -height > error;
    }
    return above && below;
  }

  /// tells whether crossings can be joined in one way only; where four of one level can in two, finds which.
  ///
  /// A saddle inside does not tell: it may be one of other lines, or none may be needed, as where a line pokes over an edge.
  bool join(std::int8_t& joined) const {
    std::map<std::int32_t, std::vector<std::size_t>> of_level;
    for (std::size_t i = 0; i < met_.crossings.size(); ++i) {
      // Walking around, the level shifts by twice the winding, which is 0 here.
      of_level[met_.crossings[i].level].push_back(i);
    }
    bool one = false;
    for (const auto& [level, c] : of_level) {
      if (c.size() == 2) {
        if (!regular_ && !both_sides_are_clear(level))
          return false;
        continue;
      }
      if (c.size() != 4 || one)
        return false;
      one = true;
      const double sign = level % 2 == 0 ? 1 : -1;
      const auto above = [&, s = sign](Complex z) { return std::arg(s * model_(z).phi()); };
      const auto below = [&, s = sign](Complex z) { return -std::arg(s * model_(z).phi()); };
      const std::size_t rise = met_.crossings[c[0]].rising ? 0 : 1; // above between c[rise] and the next
      const auto at = [&, &c = c](std::size_t k) { return c[(rise + k) % 4]; };
      const std::array<Interval, 4> sides{best_between(at(0), at(1), above), best_between(at(1), at(2), below),
                                          best_between(at(2), at(3), above), best_between(at(3), at(0), below)};
      const double up = clearance_along(sides[0], sides[2], {sides[1], sides[3]}, above);
      const double down = clearance_along(sides[1], sides[3], {sides[0], sides[2]}, below);
      joined = std::int8_t((up > down) == (level % 2 == 0) ? 1 : -1);
      // A side that hardly rises over the error says nothing: a path may pass it by unseen.
      const bool clear = std::all_of(sides.begin(), sides.end(), [&](const Interval& side) {
        return side.height > 2 * model_.phase_error(side.best);
      });
      if (!clear || (up > 0) == (down > 0))
        return false;
    }
    return true;
  }

  const Refined_complex& complex_;
  const std::vector<Half_edge>& border_;
  const Border_crossings& met_;
  const Cell_model& model_;
  const Planar_polygon& polygon_;
  const std::vector<Complex>& corner_; ///< of the border, in the coordinates of the model
  std::vector<double> phase_;          ///< lifted, of the corners, and once more of the first one
  int most_edge_level_;
  double greatest_slope_ = std::numeric_limits<double>::infinity(), greatest_error_ = 0; ///< of the phase, in the cell
  bool regular_ = true; ///< the phase has no critical point, even if the model is wrong by its error
};

} // namespace

Line_course course_of_lines(const Refined_complex& complex, const std::vector<Half_edge>& border,
                            const Border_crossings& met, const Cell_model& model, const Planar_polygon& polygon,
                            int most_edge_level) {
  return Course(complex, border, met, model, polygon, most_edge_level).find();
}

Line_course lines_around_vertex(const Refined_complex& complex, const std::vector<Half_edge>& border,
                                const Border_crossings& met, const Cell_model& model, const Planar_polygon& polygon,
                                int most_edge_level) {
  return Course(complex, border, met, model, polygon, most_edge_level).around_vertex();
}

} // namespace CGAL::Extremal_mesh_3
