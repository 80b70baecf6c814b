// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/session_track.hpp"

#include <cmath>

namespace setsquare {
namespace {

/// The motion to the first keyframe of another session: nothing is known of it.
MotionCovariance unknown_motion(const MotionUncertaintyParams& params) {
  return {.translation_m2 =
              params.restart_sigma_m * params.restart_sigma_m * Eigen::Matrix2d::Identity(),
          .rotation_rad2 = params.restart_sigma_rad * params.restart_sigma_rad,
          .slip_sigma_m = params.restart_sigma_m,
          .has_odometry = false};
}

template <typename Element>
void append(const std::vector<Element>& some, std::vector<Element>& all) {
  all.insert(all.end(), some.begin(), some.end());
}

}  // namespace

void append_session(const SessionTrack& session,
                    const MotionUncertaintyParams& params,
                    SessionTrack& all) {
  if (all.size() == 0) {
    all = session;
    return;
  }
  KeyframeTrack& track = all.track;
  const std::size_t begin = track.size();
  const std::size_t next_stretch = track.stretches.back() + 1;
  const std::size_t next_piece = track.pieces.back() + 1;
  const std::size_t next_open_stretch = track.motions.back().open_stretch + 1;
  track.session_begins.push_back(begin);
  append(session.track.keyframes, track.keyframes);
  append(session.track.motions, track.motions);
  track.motions[begin] = unknown_motion(params);
  for (std::size_t k = begin; k < track.size(); ++k) {
    track.motions[k].open_stretch += next_open_stretch;
  }
  for (const std::size_t stretch : session.track.stretches) {
    track.stretches.push_back(next_stretch + stretch);
  }
  for (const std::size_t piece : session.track.pieces) track.pieces.push_back(next_piece + piece);
  append(session.shares_of_place, all.shares_of_place);
  append(session.evidence, all.evidence);
  all.evidence[begin].step_sigma_rad = std::sqrt(track.motions[begin].rotation_rad2);
}

}  // namespace setsquare
