// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/headings/evidence.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"

namespace setsquare {

/// The track of one session, or of several one behind the other, with what each keyframe told.
struct SessionTrack {
  KeyframeTrack track;
  std::vector<double> shares_of_place;    ///< One per keyframe.
  std::vector<HeadingEvidence> evidence;  ///< One per keyframe.

  [[nodiscard]] std::size_t size() const { return track.size(); }
  [[nodiscard]] std::size_t num_sessions() const {
    return track.size() == 0 ? 0 : track.session_begins.size() + 1;
  }
};

/// Appends a session that has a keyframe at least. Nothing is known of the way to it.
void append_session(const SessionTrack& session,
                    const MotionUncertaintyParams& params,
                    SessionTrack& all);

}  // namespace setsquare
