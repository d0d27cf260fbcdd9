// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_jets.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <mutex>

namespace CGAL::Extremal_mesh_3 {

Jets fit_jets(const Fit_input& input, const std::vector<Extent>& extents, Thread_pool& pool,
              const std::function<void(double)>& progress) {
  constexpr std::size_t block = 512;
  const std::size_t n = input.vertices.size(), blocks = (n + block - 1) / block;
  Jets jets;
  jets.shapes.shapes.resize(n);
  jets.shapes.fourth.resize(n);
  jets.shapes.quality.resize(n);

  tbb::enumerable_thread_specific<Jet_fitter> fitters(
      [&] { return Jet_fitter(input.vertices, input.adjacency, input.rounding); });
  std::mutex mutex;
  std::size_t done = 0;
  pool.for_each(blocks, 1, [&](std::size_t b) {
    Jet_fitter& fitter = fitters.local();
    for (std::size_t v = b * block; v < std::min(n, (b + 1) * block); ++v)
      fitter.fit(std::uint32_t(v), extents[v], jets.shapes);
    fitter.finish(jets.shapes);
    const std::scoped_lock lock(mutex);
    progress(double(++done) / double(blocks));
  });
  for (const Jet_fitter& fitter : fitters)
    jets.grown += fitter.grown();
  return jets;
}

} // namespace CGAL::Extremal_mesh_3
