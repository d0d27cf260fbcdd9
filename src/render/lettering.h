// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_RENDER_LETTERING_H
#define EXTREMAL_MESH_3_SRC_RENDER_LETTERING_H

#include "../io/colours.h"
#include "Picture.h"

#include <string_view>

namespace CGAL::Extremal_mesh_3 {

constexpr int text_height = 8; ///< of letters, in dots

/// how many pixels a text is wide.
/// \param scale  pixels to a dot of a letter
int text_width(std::string_view text, int scale);

/// writes small letters, digits and some signs; others become blanks. What is outside of the picture is left out.
/// \param x,y  the upper left corner
void write_text(Picture& picture, int x, int y, std::string_view text, int scale);

/// fills a rectangle, as far as it is in the picture.
void fill(Picture& picture, int x, int y, int width, int height, const Colour& colour);

} // namespace CGAL::Extremal_mesh_3

#endif // EXTREMAL_MESH_3_SRC_RENDER_LETTERING_H
