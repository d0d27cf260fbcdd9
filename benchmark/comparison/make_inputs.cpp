// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   make_inputs volume SIZE NOISE FILE.mha    a bumpy thick shell, with about as much surface as a skull in a CT has
//   make_inputs mesh SIDES FILE.off           a perturbed ellipsoid with 10·SIDES² + 2 vertices

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

void write_volume(std::size_t n, double amplitude, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  out << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = " << n << ' ' << n
      << ' ' << n << "\nElementSpacing = 1 1 1\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
  std::mt19937 random(1);
  const double middle = 0.5 * double(n - 1), radius = 0.39 * double(n);
  std::vector<float> row(n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        const double x = double(i) - middle, y = double(j) - middle, z = double(k) - middle;
        const double r = std::sqrt(x * x + 1.3 * y * y + z * z);
        const double bumps = 4 * std::sin(x / 9) * std::sin(y / 8) * std::sin(z / 10);
        const double noise = double(random() % 1024) / 1024 - 0.5;
        row[i] = float(1000 / (1 + std::exp(std::abs(r - radius + bumps) - 8)) + amplitude * noise);
      }
      out.write(reinterpret_cast<const char*>(row.data()), std::streamsize(n * sizeof(float)));
    }
}

using Point = std::array<double, 3>;

double f(const Point& p) {
  const auto [x, y, z] = p;
  return x * x + 2 * (y * y) + 4 * (z * z) - 1 +
         0.1 * (std::sin(3 * x + 1) * std::sin(4 * y) + std::sin(5 * z) * std::sin(2 * x));
}

/// the point of the surface on the ray from the origin.
Point on_surface(const Point& direction) {
  double low = 0, high = 2;
  const auto at = [&](double s) { return Point{s * direction[0], s * direction[1], s * direction[2]}; };
  for (int i = 0; i < 60; ++i) {
    const double s = 0.5 * (low + high);
    (f(at(s)) < 0 ? low : high) = s;
  }
  return at(high);
}

void write_mesh(std::uint32_t sides, const std::string& file) {
  // An icosahedron, each of whose triangles is divided into sides² ones.
  const double a = 0.5 * (1 + std::sqrt(5.0));
  const std::array<Point, 12> corner{{{-1, a, 0},
                                      {1, a, 0},
                                      {-1, -a, 0},
                                      {1, -a, 0},
                                      {0, -1, a},
                                      {0, 1, a},
                                      {0, -1, -a},
                                      {0, 1, -a},
                                      {a, 0, -1},
                                      {a, 0, 1},
                                      {-a, 0, -1},
                                      {-a, 0, 1}}};
  constexpr std::array<std::array<std::uint32_t, 3>, 20> faces{
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // A vertex by the corners around it and its shares of them: faces beside each other have those on their edge in common.
  std::map<std::array<std::array<std::uint32_t, 2>, 3>, std::uint32_t> number;
  for (const auto& face : faces) {
    const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
      std::array<std::array<std::uint32_t, 2>, 3> key{{{face[0], sides - i - j}, {face[1], i}, {face[2], j}}};
      for (auto& [c, share] : key)
        c = share == 0 ? 0 : c;
      std::sort(key.begin(), key.end());
      const auto [it, added] = number.try_emplace(key, std::uint32_t(points.size()));
      if (added) {
        Point p{};
        for (const auto& [c, share] : key)
          for (std::size_t x = 0; x < 3; ++x)
            p[x] += double(share) * corner[c][x];
        const double length = std::hypot(p[0], p[1], p[2]);
        points.push_back(on_surface({p[0] / length, p[1] / length, p[2] / length}));
      }
      return it->second;
    };
    for (std::uint32_t i = 0; i < sides; ++i)
      for (std::uint32_t j = 0; i + j < sides; ++j) {
        triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
        if (i + j + 1 < sides)
          triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
  }
  std::FILE* const out = std::fopen(file.c_str(), "w");
  if (!out)
    return;
  std::fprintf(out, "OFF\n%zu %zu 0\n", points.size(), triangles.size());
  for (const auto& [x, y, z] : points)
    std::fprintf(out, "%.17g %.17g %.17g\n", x, y, z);
  for (const auto& [p, q, r] : triangles)
    std::fprintf(out, "3 %u %u %u\n", p, q, r);
  std::fclose(out);
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 4 && arguments[0] == "volume")
    write_volume(std::stoul(arguments[1]), std::stod(arguments[2]), arguments[3]);
  else if (arguments.size() == 3 && arguments[0] == "mesh")
    write_mesh(std::uint32_t(std::stoul(arguments[1])), arguments[2]);
  else
    return 2;
}
