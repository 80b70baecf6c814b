// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What the page of the live view is told, as JSON; what it asks for is in view/command. Lengths in
// m, angles in rad, all in the map frame but the scan's points.
#pragma once

#include <string>

#include "setsquare/core/trajectory.hpp"
#include "setsquare/live/live_pose.hpp"
#include "setsquare/live/live_session.hpp"

namespace setsquare::live_app {

/// {"type": "map", ...}: its picture (map_report_image), closures and doubts. Empty where nothing
/// is known yet.
[[nodiscard]] std::string view_map(const LiveMap& map);

/// {"type": "way", "points": [x, y, ...]}, thinned where it is long.
[[nodiscard]] std::string view_way(const Trajectory& way);

/// {"type": "pose", ...} with the scan's points in the robot's frame.
[[nodiscard]] std::string view_pose(const LivePose& pose, const Scan& scan);

/// {"type": "report", ...}: how it goes, and what may be asked for.
[[nodiscard]] std::string view_report(const LiveSession& session, bool can_save);

/// {"type": "answer", "ok": true, "text": "..."}.
[[nodiscard]] std::string view_answer(bool is_done, const std::string& text);

}  // namespace setsquare::live_app
