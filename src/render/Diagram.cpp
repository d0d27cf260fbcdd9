// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Diagram.h"

#include "../io/Text_file.h"
#include "Canvas.h"
#include "Picture.h"
#include "lettering.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Extremal_mesh_3 {

namespace {

constexpr double dash = 6; ///< and as much between two

/// hundredths of pixels are enough, and do not depend on rounding elsewhere.
double rounded(double x) {
  return std::round(100 * x) / 100;
}

std::string hexadecimal(const Colour& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    switch (c) {
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '&':
      result += "&amp;";
      break;
    default:
      result += c;
    }
  return result;
}

} // namespace

void Diagram::write_svg(const std::string& file) const {
  Text_file out(file);
  out.print(FMT_COMPILE("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                        "viewBox=\"0 0 {0} {1}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"),
            width, height);
  for (const Rectangle& r : rectangles)
    out.print(FMT_COMPILE("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n"), rounded(r.x),
              rounded(r.y), rounded(r.width), rounded(r.height), hexadecimal(r.colour));
  for (const Line& l : lines)
    out.print(FMT_COMPILE("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n"),
              rounded(l.x1), rounded(l.y1), rounded(l.x2), rounded(l.y2), hexadecimal(l.colour), l.width,
              l.dashed ? fmt::format(" stroke-dasharray=\"{0} {0}\"", dash) : "");
  for (const Dots& d : dots) {
    out.print(FMT_COMPILE("<g id=\"{}\" fill=\"{}\">\n"), d.name, hexadecimal(d.colour));
    for (const auto& [x, y] : d.centres)
      out.print(FMT_COMPILE("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n"), rounded(x), rounded(y), dot_radius);
    out << "</g>\n";
  }
  out << "<g font-family=\"sans-serif\" font-size=\"13\" fill=\"#3c4048\">\n";
  for (const Text& t : texts)
    out.print(FMT_COMPILE("<text x=\"{}\" y=\"{}\" dominant-baseline=\"central\" text-anchor=\"{}\">{}</text>\n"),
              rounded(t.x), rounded(t.y),
              t.align == Align::left    ? "start"
              : t.align == Align::right ? "end"
                                        : "middle",
              escaped(t.text));
  out << "</g>\n</svg>\n";
  out.commit();
}

void Diagram::write_png(const std::string& file) const {
  constexpr double s = Canvas::samples;
  Canvas canvas(width, height, 0, height);
  double depth = 0; // less for what is drawn later
  const auto at = [&](double x, double y) { return Screen_point{s * x, s * y, depth}; };
  canvas.rectangle(at(0, 0), at(width, height), {255, 255, 255});
  for (const Rectangle& r : rectangles) {
    --depth;
    canvas.rectangle(at(r.x, r.y), at(r.x + r.width, r.y + r.height), r.colour);
  }
  for (const Line& l : lines) {
    --depth;
    const double length = std::hypot(l.x2 - l.x1, l.y2 - l.y1);
    const int parts = l.dashed ? std::max(int(length / dash), 1) : 1;
    for (int i = 0; i < parts; i += 2) {
      const auto point = [&](int part) {
        const double t = double(part) / parts;
        return at(l.x1 + t * (l.x2 - l.x1), l.y1 + t * (l.y2 - l.y1));
      };
      canvas.stroke(point(i), point(i + 1), s * l.width / 2, 0, l.colour);
    }
  }
  for (const Dots& d : dots)
    for (const auto& [x, y] : d.centres) {
      --depth;
      canvas.dot(at(x, y), s * dot_radius, 0, 0, d.colour);
    }
  Picture picture(width, height);
  canvas.resolve(picture.rows(0, height));
  for (const Text& t : texts) {
    const int size = text_width(t.text, 1);
    const double left = t.align == Align::left ? t.x : t.align == Align::right ? t.x - size : t.x - size / 2.0;
    write_text(picture, int(std::lround(left)), int(std::lround(t.y)) - text_height / 2, t.text, 1);
  }
  picture.write_png(file);
}

} // namespace CGAL::Extremal_mesh_3
