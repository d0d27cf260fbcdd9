// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/tool/Progress_bar.h"

#include <gtest/gtest.h>

using CGAL::Extremal_mesh_3::tool::progress_line;

TEST(Progress_bar, tells_rate_and_time_left) {
  // a quarter in 10 s: 2.5 % in a second, 30 s for the rest
  EXPECT_EQ(progress_line("lines", 0.25, 10), "lines      [#######.......................]  25 %  2.5 %/s  0:30 left");
  // 2 % in 100 s: 4900 s for the rest
  EXPECT_EQ(progress_line("surface", 0.02, 100),
            "surface    [..............................]   2 %  0.02 %/s  1:21:40 left");
}

TEST(Progress_bar, tells_no_rate_before_anything_can_be_said) {
  EXPECT_EQ(progress_line("lines", 0.25, 0.2), "lines      [#######.......................]  25 %");
  EXPECT_EQ(progress_line("lines", 0, 10), "lines      [..............................]   0 %");
}

TEST(Progress_bar, has_room_in_80_columns) {
  EXPECT_LE(progress_line("fitting", 0.00123, 1234.5).size(), 80U);
  EXPECT_LE(progress_line("fitting", 1, 1234.5).size(), 80U);
}
