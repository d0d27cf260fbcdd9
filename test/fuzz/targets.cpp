// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "targets.h"

#include "Memory_file.h"

#include <CGAL/Extremal_mesh_3/Formula.h>
#include <CGAL/Extremal_mesh_3/Image.h>
#include <CGAL/Extremal_mesh_3/Image_function.h>
#include <CGAL/Extremal_mesh_3/check.h>
#include <CGAL/Extremal_mesh_3/errors.h>
#include <CGAL/Extremal_mesh_3/io.h>
#include <CGAL/Extremal_mesh_3/landmarks.h>
#include <CGAL/Extremal_mesh_3/lines.h>
#include <CGAL/Extremal_mesh_3/measures.h>
#include <CGAL/Extremal_mesh_3/read_mesh.h>
#include <CGAL/Extremal_mesh_3/simplify.h>
#include <CGAL/Extremal_mesh_3/summary.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace fuzz {

namespace {

using namespace CGAL::Extremal_mesh_3;

/// gives the bytes as a file to a reader, which may refuse it.
template <typename Read> void read(Bytes bytes, const char* extension, const Read& read_file) {
  thread_local Memory_file file(extension);
  file.fill(bytes);
  try {
    read_file(file.name());
  } catch (const Io_error&) {
  }
}

template <const char* extension> void mesh(Bytes bytes) {
  read(bytes, extension, [](const std::string& file) { read_mesh(file); });
}

template <const char* extension> void image(Bytes bytes) {
  read(bytes, extension, [](const std::string& file) {
    Image image = read_image(file);
    const Point middle = image.lattice.node(1.5, 1.5, 1.5);
    if (image.voxels.size() > 4096)
      return;
    const auto [low, high] = std::minmax_element(image.voxels.begin(), image.voxels.end());
    Image_function_options options;
    options.iso = 0.5 * double(*low) + 0.5 * double(*high);
    options.threads = 1;
    try {
      const Image_function function(std::move(image), options);
      Derivatives d;
      function.derivatives(middle, 4, d);
    } catch (const std::invalid_argument&) {
    } catch (const Extraction_error&) {
    }
  });
}

/// what is asked of a graph once it is read.
void use(const Extremal_mesh& mesh) {
  to_json(mesh, check(mesh));
  if (!all_hold(check(mesh))) {
    try { // is to refuse what fails in check(), and to be content with the rest
      const Simplification simplification(mesh);
      simplification.mesh_at(simplification.number_of_levels() - 1);
    } catch (const std::invalid_argument&) {
    }
    return;
  }
  for (std::uint32_t e = 0; e < std::min<std::size_t>(mesh.number_of_edges(), 8); ++e)
    line_through(mesh, e);
  const Simplification simplification(mesh);
  if (!all_hold(check(simplification.mesh_at(simplification.number_of_levels() - 1))))
    throw std::logic_error("a check fails after simplification");
}

void graphml(Bytes bytes) {
  read(bytes, ".graphml", [](const std::string& file) { use(read_graphml(file)); });
}

void cell_patches(Bytes bytes) {
  read(bytes, ".ply", [](const std::string& file) { read_cell_patches(file); });
}

template <const char* extension> void landmarks(Bytes bytes) {
  read(bytes, extension, [](const std::string& file) { read_landmarks(file); });
}

void formula(Bytes bytes) {
  try {
    const Formula formula(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    const Point p{0.3, -1.7, 2.5};
    Derivatives d;
    formula.value(p);
    formula.derivatives(p, 4, d);
    Derivative_bounds bounds;
    formula.bounds({{-1, -1, -1}, {1, 2, 0.5}}, 3, bounds);
  } catch (const Formula_error&) {
  }
}

constexpr char off[] = ".off", obj[] = ".obj", ply[] = ".ply", stl[] = ".stl", om[] = ".om", nrrd[] = ".nrrd",
               mha[] = ".mha", nii[] = ".nii", nii_gz[] = ".nii.gz", vtk[] = ".vtk", vti[] = ".vti", csv[] = ".csv",
               json[] = ".json";

constexpr std::array all{Target{"off", mesh<off>},
                         Target{"obj", mesh<obj>},
                         Target{"ply", mesh<ply>},
                         Target{"stl", mesh<stl>},
                         Target{"om", mesh<om>},
                         Target{"nrrd", image<nrrd>},
                         Target{"mha", image<mha>},
                         Target{"nii", image<nii>},
                         Target{"nii_gz", image<nii_gz>},
                         Target{"vtk", image<vtk>},
                         Target{"vti", image<vti>},
                         Target{"graphml", graphml},
                         Target{"cell_patches", cell_patches},
                         Target{"landmarks_csv", landmarks<csv>},
                         Target{"landmarks_json", landmarks<json>},
                         Target{"formula", formula},
                         Target{"shapes", extract_from_shapes},
                         Target{"function", extract_from_function}};

} // namespace

std::span<const Target> targets() {
  return all;
}

const Target& find_target(std::string_view name) {
  const auto* const found =
      std::find_if(all.begin(), all.end(), [&](const Target& target) { return target.name == name; });
  if (found == all.end())
    throw std::invalid_argument("there is no target '" + std::string(name) + "'");
  return *found;
}

} // namespace fuzz
