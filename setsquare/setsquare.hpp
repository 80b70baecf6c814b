// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The front door: match two scans, map a log, judge the result.
//
//   const MatchResult match = setsquare::match(reference, current);
//
//   Mapper mapper;
//   const auto log = open_log("intel.clf");
//   while (const auto* record = log->next()) mapper.add(record->scan, record->T_odom_base);
//   save_map(mapper.finish(), "out");
//
//   const MappedLog mapped = map_logs({"intel.clf"});  // The same in one call.
//   save_map(mapped.map, "out", save_options_of(mapped));
//
//   const SavedMap saved = load_map_file("out");  // What map.setsquare there holds.
//   Mapper next_day(saved.map);                   // Goes on with it.
//   const SavedMap both = merge_map_files({"out", "other_wing"});
//   Localizer localizer(std::make_shared<KnownMap>(occupancy_grid(saved.map)));
//   const LocalisedPose pose = localizer.add(scan);  // Anywhere in it, from no start pose.
//
// Link setsquare::setsquare. To match one scan with many, `prepare` each once.
#pragma once

#include "setsquare/eval/evaluate.hpp"             // IWYU pragma: export
#include "setsquare/io/logs/open_log.hpp"          // IWYU pragma: export
#include "setsquare/io/map_file/map_file.hpp"      // IWYU pragma: export
#include "setsquare/io/tables/relations.hpp"       // IWYU pragma: export
#include "setsquare/io/tables/trajectory_tum.hpp"  // IWYU pragma: export
#include "setsquare/localisation/known_map.hpp"    // IWYU pragma: export
#include "setsquare/localisation/localizer.hpp"    // IWYU pragma: export
#include "setsquare/map/map.hpp"                   // IWYU pragma: export
#include "setsquare/mapping/mapper.hpp"            // IWYU pragma: export
#include "setsquare/matching/scan_matcher.hpp"     // IWYU pragma: export
#include "setsquare/pipeline/map_log.hpp"          // IWYU pragma: export
#include "setsquare/pipeline/merge_maps.hpp"       // IWYU pragma: export
#include "setsquare/report/map/save_map.hpp"       // IWYU pragma: export
#include "setsquare/scan/scan.hpp"                 // IWYU pragma: export

/// Everything of Setsquare. Lengths are in m, angles in rad and counterclockwise, times in s,
/// unless a name ends otherwise (`_deg`, `_ns`). A pose T_a_b maps points of frame b into frame a;
/// the frames are those of ROS REP 105: `map`, `odom`, `base` (the robot), `sensor`; x forward, y
/// left.
namespace setsquare {}
