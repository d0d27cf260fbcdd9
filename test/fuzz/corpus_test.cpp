// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every file of the corpus, once. What the fuzzer found to be wrong is among them.
#include "targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace {

namespace fs = std::filesystem;

class Fuzz_corpus : public testing::TestWithParam<fuzz::Target> {};

std::vector<std::uint8_t> content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST_P(Fuzz_corpus, is_taken_or_refused_without_harm) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(EXTREMAL_MESH_3_CORPUS) / GetParam().name))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NO_THROW(GetParam().run(content_of(file)));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz_corpus, testing::ValuesIn(fuzz::targets().begin(), fuzz::targets().end()),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace
