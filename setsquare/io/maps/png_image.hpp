// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/maps/pgm_image.hpp"

namespace setsquare {

/// Whether bytes begin as a PNG image does; eight are enough.
[[nodiscard]] bool is_png(std::string_view beginning);

/// Reads a PNG image of any kind as grey, one byte per pixel, white being 255: colours by their
/// brightness, what is transparent on white. Throws FileError; FormatError for a file that is not a
/// PNG, is damaged or cut short, or has more than 100 million pixels.
[[nodiscard]] PgmImage read_png(std::unique_ptr<ByteSource> source, const std::string& name);

}  // namespace setsquare
