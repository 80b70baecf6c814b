// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/png.hpp"

#include <png.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

bool is_grey(const Image& image) {
  return std::all_of(image.pixels().begin(), image.pixels().end(), [](Color pixel) {
    return pixel.red == pixel.green && pixel.green == pixel.blue;
  });
}

/// The pixels in grey, one byte each.
std::vector<std::uint8_t> grey_bytes_of(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels().size());
  for (const Color pixel : image.pixels()) bytes.push_back(pixel.red);
  return bytes;
}

}  // namespace

std::string png_from_image(const Image& image) {
  const bool grey = is_grey(image);
  const std::vector<std::uint8_t> grey_bytes =
      grey ? grey_bytes_of(image) : std::vector<std::uint8_t>();
  static_assert(sizeof(Color) == 3, "libpng takes the pixels as they are");
  const void* const bytes =
      grey ? static_cast<const void*>(grey_bytes.data()) : image.pixels().data();
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width_px());
  header.height = static_cast<png_uint_32>(image.height_px());
  header.format = grey ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
  header.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t num_bytes = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string file(num_bytes, '\0');
  if (png_image_write_to_memory(&header, file.data(), &num_bytes, 0, bytes, 0, nullptr) == 0) {
    throw Error(std::string("PNG encoding failed: ") + header.message);
  }
  file.resize(num_bytes);
  return file;
}

}  // namespace setsquare
