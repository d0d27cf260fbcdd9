// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   with_itk derivatives FILE.mha   the 20 derivatives up to order 3 of the smoothed volume, by recursive Gaussians
//   with_itk accuracy               the error of the third ones, interpolated linearly between the nodes
//
// One thread. A filter has order 2 at most: a third derivative along an axis is the first one of the second, each with σ/√2.
// Passes along x and y serve all the volumes that need them.
#include "Measurement.h"
#include "Waves.h"

#include <itkImage.h>
#include <itkImageFileReader.h>
#include <itkLinearInterpolateImageFunction.h>
#include <itkMetaImageIO.h>
#include <itkMultiThreaderBase.h>
#include <itkRecursiveGaussianImageFilter.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using Volume = itk::Image<float, 3>;
using Filter = itk::RecursiveGaussianImageFilter<Volume, Volume>;

Volume::Pointer one_pass(Volume* in, unsigned axis, unsigned order, double sigma) {
  const auto filter = Filter::New();
  filter->SetInput(in);
  filter->SetDirection(axis);
  filter->SetSigma(sigma);
  filter->SetOrder(order == 0   ? itk::RecursiveGaussianImageFilterEnums::GaussianOrder::ZeroOrder
                   : order == 1 ? itk::RecursiveGaussianImageFilterEnums::GaussianOrder::FirstOrder
                                : itk::RecursiveGaussianImageFilterEnums::GaussianOrder::SecondOrder);
  filter->Update();
  const Volume::Pointer out = filter->GetOutput();
  out->DisconnectPipeline();
  return out;
}

Volume::Pointer pass(Volume* in, unsigned axis, unsigned order) {
  if (order < 3)
    return one_pass(in, axis, order, Waves::sigma);
  const double half = Waves::sigma / std::sqrt(2.0);
  return one_pass(one_pass(in, axis, 2, half), axis, 1, half);
}

struct Derivative {
  std::array<int, 3> orders;
  Volume::Pointer volume;
};

std::vector<Derivative> derivatives(Volume* image) {
  std::vector<Derivative> result;
  for (unsigned a = 0; a <= 3; ++a) {
    const Volume::Pointer along_x = pass(image, 0, a);
    for (unsigned b = 0; a + b <= 3; ++b) {
      const Volume::Pointer along_y = pass(along_x, 1, b);
      for (unsigned c = 0; a + b + c <= 3; ++c)
        result.push_back({{int(a), int(b), int(c)}, pass(along_y, 2, c)});
    }
  }
  return result;
}

void measure(const std::string& file) {
  const auto reader = itk::ImageFileReader<Volume>::New();
  reader->SetImageIO(itk::MetaImageIO::New());
  reader->SetFileName(file);
  reader->Update();
  std::vector<Derivative> found;
  const double seconds = seconds_of([&] { found = derivatives(reader->GetOutput()); });
  report(seconds, found.size());
}

void accuracy() {
  const Waves waves;
  constexpr std::size_t n = Waves::size, margin = Waves::margin;
  const auto image = Volume::New();
  image->SetRegions(Volume::SizeType{{n, n, n}});
  image->Allocate();
  const std::vector<float> voxels = waves.voxels();
  std::copy(voxels.begin(), voxels.end(), image->GetBufferPointer());
  Relative_error error;
  for (const Derivative& d : derivatives(image)) {
    if (d.orders[0] + d.orders[1] + d.orders[2] != 3)
      continue;
    const auto interpolation = itk::LinearInterpolateImageFunction<Volume>::New();
    interpolation->SetInputImage(d.volume);
    for (std::size_t k = margin; k < n - margin; ++k)
      for (std::size_t j = margin; j < n - margin; ++j)
        for (std::size_t i = margin; i < n - margin; ++i) {
          const std::array<double, 3> p{double(i) + 0.3, double(j) + 0.4, double(k) + 0.1};
          itk::ContinuousIndex<double, 3> at;
          std::copy(p.begin(), p.end(), at.Begin());
          error.add(interpolation->EvaluateAtContinuousIndex(at), waves.derivative(p, d.orders));
        }
  }
  report_error(error.value());
}

} // namespace

int main(int argc, char** argv) {
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(1);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(1);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 2 && arguments[0] == "derivatives")
    measure(arguments[1]);
  else if (arguments.size() == 1 && arguments[0] == "accuracy")
    accuracy();
  else
    return 2;
}
