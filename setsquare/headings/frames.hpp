// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from fusion, which shows it: the discrete half of the problem, tested alone.
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/headings/heading_params.hpp"
#include "setsquare/headings/trace.hpp"

namespace setsquare {

/// A part of a building whose walls are square to each other: a wing.
struct HeadingFrame {
  double offset_rad = 0.0;  ///< Of its walls against those of the main frame, modulo the period.
  double sigma_rad = 0.0;   ///< Standard deviation of the offset; 0 of the main frame.
  double support = 0.0;     ///< Keyframes that see it, each counted by its confidence.
};

/// The frames of a building, and the drift by the trace once they are known.
struct HeadingFrames {
  std::vector<HeadingFrame> frames;  ///< The main one first, by falling support; never empty.
  std::vector<double> drift_rad;     ///< One per keyframe, unwrapped; rough, to half a bin or so.
  /// Standard deviation of each tracked rotation: as the evidence has it, widened where it slipped.
  std::vector<double> step_sigma_rad;
  /// Share of the log's proposals, each counted by its confidence, that the trace explains: next
  /// to 1 among straight walls, a third or less among round ones.
  double share = 1.0;
};

/// Separates drift from changes of frame: the trace's pieces between changes are laid end to end,
/// since the tracked heading does not jump where the walls do. A piece whose offset comes out as
/// that of a frame already seen belongs to it; else it begins a frame. A jump too small for another
/// frame is a slip of tracking. Pieces of little support are ignored: they neither begin a frame
/// nor belong to one, and the drift goes on through them. The frame of the most support is the main
/// one, at offset 0.
[[nodiscard]] HeadingFrames find_heading_frames(const std::vector<HeadingEvidence>& keyframes,
                                                const HeadingTrace& trace,
                                                const HeadingTraceParams& trace_params = {},
                                                const HeadingFramesParams& params = {});

}  // namespace setsquare
