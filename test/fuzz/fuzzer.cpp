// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program that libFuzzer drives. Which target it feeds, the variable FUZZ_TARGET of the environment tells.
#include "targets.h"

#include <cstdlib>
#include <stdexcept>

namespace {

const fuzz::Target& chosen_target() {
  const char* const name = std::getenv("FUZZ_TARGET");
  if (!name)
    throw std::invalid_argument("FUZZ_TARGET must name a target; see targets.cpp");
  return fuzz::find_target(name);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) { // NOLINT(readability-identifier-naming)
  static const fuzz::Target& target = chosen_target();
  target.run({data, size});
  return 0;
}
