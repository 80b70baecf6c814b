// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

#include "setsquare/drawing/image.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare {

/// A place in an image, in pixels: (0, 0) is the upper left corner of the first pixel, x to the
/// right, y down; that pixel's centre is (0.5, 0.5).
using PixelPoint = Eigen::Vector2d;

/// A line through the points with round joints and ends, edges smoothed. One point makes a dot.
/// Parts outside the image are cut off; points that are not finite break the line.
void draw_polyline(Image& image, std::span<const PixelPoint> points, double width_px, Color value);

/// A disc with a smoothed edge.
void fill_disc(Image& image, const PixelPoint& centre, double radius_px, Color value);

/// All pixels whose centres lie in the rectangle between two opposite corners.
void fill_rectangle(Image& image, const PixelPoint& corner, const PixelPoint& other, Color value);

/// A line of text in the stroke font; `position` is on the baseline. `cap_height_px` is the height
/// of a capital letter.
void draw_text(Image& image,
               const PixelPoint& position,
               std::string_view text,
               double cap_height_px,
               Color value,
               TextAnchor anchor = TextAnchor::kStart);

}  // namespace setsquare
