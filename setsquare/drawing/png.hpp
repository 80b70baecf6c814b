// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/drawing/image.hpp"

namespace setsquare {

/// The image as a PNG file's bytes, eight bits a channel: RGB, or grey where every pixel is.
/// The same image gives the same bytes.
[[nodiscard]] std::string png_from_image(const Image& image);

}  // namespace setsquare
