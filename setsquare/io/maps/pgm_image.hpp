// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "setsquare/io/bytes/byte_source.hpp"

namespace setsquare {

/// A grey image.
struct PgmImage {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::uint16_t white = 255;          ///< The value that stands for white; 0 is black.
  std::vector<std::uint16_t> values;  ///< One per pixel, row by row from the top.
};

/// Reads a PGM image, binary (P5, one or two bytes per pixel) or plain text (P2); what follows it
/// is not looked at. Memory grows with what is read, whatever the header promises. Throws
/// FileError; FormatError with the byte offset for a file that is not a PGM, is cut short, or has
/// more than 100 million pixels. Header lines may end in CR LF.
[[nodiscard]] PgmImage read_pgm(std::unique_ptr<ByteSource> source, const std::string& name);

/// The image as a binary PGM file's bytes (P5): one byte per pixel where white is at most 255, else
/// two, the higher first. Throws ParameterError where the sides are not positive, do not give the
/// number of values, or a pixel is brighter than white.
[[nodiscard]] std::string pgm_from_image(const PgmImage& image);

}  // namespace setsquare
