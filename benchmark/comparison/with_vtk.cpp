// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   with_vtk flying_edges FILE.mha     the surface, without normals
//   with_vtk marching_cubes FILE.mha   the surface, with normals
//
// Of the volume as it is, which is in memory already.
#include "Measurement.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkMetaImageReader.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <string>
#include <vector>

namespace {

template <class Contour> void measure(const std::string& file, bool normals) {
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkNew<Contour> contour;
  contour->SetInputData(reader->GetOutput());
  contour->SetComputeNormals(normals);
  contour->SetComputeGradients(false);
  contour->SetComputeScalars(false);
  contour->SetValue(0, 500);
  const double seconds = seconds_of([&] { contour->Update(); });
  report(seconds, std::size_t(contour->GetOutput()->GetNumberOfPoints()));
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 2 && arguments[0] == "flying_edges")
    measure<vtkFlyingEdges3D>(arguments[1], false);
  else if (arguments.size() == 2 && arguments[0] == "marching_cubes")
    measure<vtkMarchingCubes>(arguments[1], true);
  else
    return 2;
}
