// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from growing_map, its only caller: it makes a map of a map.
#pragma once

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// The map as a mapper goes on with it: what its sessions show that earlier ones of them cover is
/// forgotten, by the rule of KnownKeyframes, so that a map that is gone on with day after day is
/// bounded by the building. The first session is left as it is, and so are sessions that are not
/// wholly placed.
///
/// 1. Session after session the keyframes are examined against those of earlier sessions.
/// 2. Runs of those that show nothing new are forgotten with the scans kept between. A piece of
///    track may so lose its begin and its end, where nothing has to go on; one of which nothing is
///    left is forgotten with its poses, and so is such a session (Map::forgotten_poses).
/// 3. Over a run the track is as if tracking had followed the map, as in forget_keyframes().
/// 4. Between keyframes that were forgotten, now or before, the newest scans keep their poses
///    (ForgettingParams::max_poses_before).
///
/// Of the map no more than what GrowingMap::add() needs is told. Throws ParameterError where the
/// map does not tell its track (PaperMapper). Any number of threads gives the same.
[[nodiscard]] Map without_known_places(const Map& map, const MapperParams& params);

}  // namespace setsquare
