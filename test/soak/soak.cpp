// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   soak SECONDS [SEED]
//
// Random surfaces, each also moved: extract, check, write, read, compare, simplify, check, register, cells as surfaces. See
// scripts/soak.sh.
#include "../motion.h"
#include "../random_surfaces.h"

#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/extract_extremal_mesh.h>
#include <CGAL/Extremal_mesh_3/fit_vertex_shapes.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/register.h>
#include <CGAL/Extremal_mesh_3/simplify.h>

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace {

using namespace CGAL::Extremal_mesh_3;

/// in MB; what Linux tells.
double resident_memory() {
  std::ifstream status("/proc/self/statm");
  double total = 0, resident = 0;
  status >> total >> resident;
  return resident * double(::sysconf(_SC_PAGE_SIZE)) / 0x1p20;
}

void require(bool holds, const std::string& what) {
  if (!holds)
    throw std::logic_error(what);
}

void require_checked(const Extremal_mesh& mesh, const std::string& what) {
  for (const Check& claim : check(mesh))
    require(!claim.applies || claim.holds, fmt::format("{}: {}: {}", what, claim.name, claim.detail));
}

/// the mesh as a file tells it, which must tell it exactly.
Extremal_mesh written_and_read(const Extremal_mesh& mesh, const std::string& folder) {
  const std::string first = folder + "/a.graphml", second = folder + "/b.graphml";
  write_graphml(first, mesh);
  Extremal_mesh read = read_graphml(first);
  write_graphml(second, read);
  const auto content = [](const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  require(content(first) == content(second), "a graph is not read as it was written");
  return read;
}

struct Counts {
  std::size_t surfaces = 0, vertices = 0, steps = 0, found = 0, not_found = 0;
};

void soak(unsigned seed, const std::string& folder, Counts& counts) {
  const auto f = random_surfaces::ellipsoid(seed);
  const auto motion = surfaces::random_motion(seed);
  const auto moved = random_surfaces::ellipsoid(seed, motion);
  Extraction_options options;
  options.patches = true;
  const Lattice lattice = make_lattice({-1.6, -1.6, -1.6}, {1.6, 1.6, 1.6}, 12);
  const Extraction extraction = extract_extremal_mesh(f, lattice, options);
  const std::string name = fmt::format("surface {}", seed);
  require_checked(extraction.mesh, name);
  counts.vertices += extraction.mesh.number_of_vertices();
  const Extremal_mesh mesh = written_and_read(extraction.mesh, folder);
  write_ply(folder + "/cells.ply", extraction.patches, mesh);
  require(read_cell_patches(folder + "/cells.ply").corners == extraction.patches.corners, name + ": cells as surfaces");

  const Simplification simplification(mesh);
  counts.steps += simplification.steps().size();
  for (const std::size_t level : {simplification.number_of_levels() / 2, simplification.number_of_levels() - 1})
    require_checked(written_and_read(simplification.mesh_at(level), folder), fmt::format("{}, level {}", name, level));

  const Point low{motion.translation[0] - 2, motion.translation[1] - 2, motion.translation[2] - 2},
      high{low[0] + 4, low[1] + 4, low[2] + 4};
  const Extremal_mesh other = extract_extremal_mesh(moved, make_lattice(low, high, 14)).mesh;
  require_checked(other, name + ", moved");
  // The box round the moved surface holds other parts of space, where some functions have other sheets.
  const Surface_info &a = mesh.surface(), &b = other.surface();
  if (a.closed && b.closed && a.components == 1 && b.components == 1)
    require(other.number_of_vertices() == mesh.number_of_vertices(),
            fmt::format("{}: moved, it has {} vertices, not {}", name, other.number_of_vertices(),
                        mesh.number_of_vertices()));
  const Registration registration = register_extremal_meshes(mesh, other);
  ++(registration.found ? counts.found : counts.not_found);

  // The polygons as a mesh of which no more is known.
  const Cell_complex cells = make_implicit_cells(f, lattice);
  try {
    require_checked(extract_extremal_mesh(cells, fit_vertex_shapes(cells).shapes).mesh, name + ", as a mesh");
  } catch (const Extraction_error&) {
  }
  ++counts.surfaces;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: soak SECONDS [SEED]\n");
    return 2;
  }
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double seconds = std::atof(argv[1]);
  unsigned seed = argc > 2 ? unsigned(std::atol(argv[2])) : 1;
  const std::string folder = (std::filesystem::temp_directory_path() / fmt::format("soak_{}", ::getpid())).string();
  std::filesystem::create_directory(folder);
  Counts counts;
  int failures = 0;
  double next = 0, settled = 0;
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const auto report = [&] {
    fmt::print("{:6.0f} s: {} surfaces, {} vertices, {} steps, {} motions found, {} not, {} failures, {:.1f} MB\n",
               passed(), counts.surfaces, counts.vertices, counts.steps, counts.found, counts.not_found, failures,
               resident_memory());
    std::fflush(stdout);
  };
  for (; passed() < seconds; ++seed) {
    try {
      soak(seed, folder, counts);
    } catch (const std::exception& error) {
      ++failures;
      fmt::print("surface {}: {}\n", seed, error.what());
    }
    if (passed() > next) {
      report();
      next = passed() + 30;
    }
    if (settled == 0 && passed() > seconds / 4)
      settled = resident_memory();
  }
  report();
  std::filesystem::remove_all(folder);
  constexpr double margin = 1.25; // between what surfaces of different size leave in the allocator
  if (settled > 0 && resident_memory() > margin * settled + 20) {
    fmt::print("memory has grown from {:.1f} MB\n", settled);
    ++failures;
  }
  return failures == 0 ? 0 : 1;
}
