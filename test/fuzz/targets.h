// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is fed with hostile bytes: by libFuzzer (fuzzer.cpp), and by a test that replays the corpus (corpus_test.cpp).
#ifndef EXTREMAL_MESH_3_TEST_FUZZ_TARGETS_H
#define EXTREMAL_MESH_3_TEST_FUZZ_TARGETS_H

#include <cstdint>
#include <span>
#include <string_view>

namespace fuzz {

using Bytes = std::span<const std::uint8_t>;

struct Target {
  std::string_view name;
  /// returns, whether the bytes make sense or are refused with an error of the kind that is documented; everything else, such as
  /// another exception, is a finding.
  void (*run)(Bytes);
};

std::span<const Target> targets();
/// \throws std::invalid_argument if there is none with this name
const Target& find_target(std::string_view name);

// extraction_targets.cpp
void extract_from_shapes(Bytes);
void extract_from_function(Bytes);

} // namespace fuzz

#endif // EXTREMAL_MESH_3_TEST_FUZZ_TARGETS_H
