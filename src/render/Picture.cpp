// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Picture.h"

#include "../io/Atomic_file.h"

#include <CGAL/Extremal_mesh_3/errors.h>

#include <fmt/format.h>
#include <png.h>

namespace CGAL::Extremal_mesh_3 {

void Picture::write_png(const std::string& file) const {
  Atomic_file out(file);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(width_);
  image.height = png_uint_32(height_);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string png(size, '\0');
  if (!png_image_write_to_memory(&image, png.data(), &size, 0, bytes_.data(), 0, nullptr))
    throw Io_error(fmt::format("cannot write '{}': {}", file, image.message));
  out.write(std::string_view(png).substr(0, size));
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
