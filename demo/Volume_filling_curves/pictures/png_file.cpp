// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/png_file.h"

#include <png.h>

#include <stdexcept>

namespace vfc {

std::string to_png(const Rgb_image& image)
{
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string file(size, '\0');
  if(!png_image_write_to_memory(&header, file.data(), &size, 0, image.bytes.data(), 0, nullptr))
    throw std::runtime_error(std::string("libpng: ") + header.message);
  file.resize(size);
  return file;
}

} // namespace vfc
