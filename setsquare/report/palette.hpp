// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/drawing/color.hpp"

namespace setsquare::palette {

// One set of colours for every picture; they differ in the common forms of colour blindness.
inline constexpr Color kInk = color(0x1f2933);        ///< Text, axes.
inline constexpr Color kFaintInk = color(0x64707d);   ///< Tick labels, remarks.
inline constexpr Color kGuide = color(0xe3e7eb);      ///< Grid lines.
inline constexpr Color kFrame = color(0xb8c0c8);      ///< Frames of panels.
inline constexpr Color kPaper = color(0xffffff);      ///< Background.
inline constexpr Color kReference = color(0x1f5fa8);  ///< The reference scan: blue.
inline constexpr Color kCurrent = color(0xe0701c);    ///< The current scan: orange.
inline constexpr Color kAnswer = color(0x12805c);     ///< The chosen proposal: green.
inline constexpr Color kRunnerUp = color(0xb0307a);   ///< The runner-up: magenta.
inline constexpr Color kContradiction =
    color(0xff5a5a);                                ///< Returns where the other scan saw through.
inline constexpr Color kWall = color(0x14191f);     ///< Occupied cells.
inline constexpr Color kFree = color(0xffffff);     ///< Free cells.
inline constexpr Color kUnknown = color(0xd5dade);  ///< Cells of which nothing is known.
inline constexpr Color kTracked = color(0x2478c7);  ///< The robot's path.
inline constexpr Color kDegenerate = color(0xf2930d);   ///< The path where a direction is open.
inline constexpr Color kLost = color(0xd02a3c);         ///< The path where no scan matched.
inline constexpr Color kDoubt = color(0xa8201a);        ///< A place where the map may be wrong.
inline constexpr Color kClosure = color(0x23a455);      ///< A loop closure: green.
inline constexpr Color kAxisClosure = color(0xb0307a);  ///< One that binds one axis: magenta.
inline constexpr Color kStart = color(0x12805c);        ///< The path's start.
inline constexpr Color kEnd = color(0x8a2be2);          ///< The path's end.

}  // namespace setsquare::palette
