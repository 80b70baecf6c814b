// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/live/live_pose.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

struct LiveMapperParams {
  MapperParams mapper;
  /// A map to go on with (Mapper), or null. Until the robot's place in it is found, its poses have
  /// no meaning (LivePose::is_placed).
  std::shared_ptr<const Map> known_map = nullptr;
  /// Of known ground so many of the newest poses stay (ForgettingParams::max_known_poses), an hour
  /// at 10 Hz: memory does not grow with the time. 0: all stay.
  std::size_t max_known_poses = 36'000;
  /// Where closing and drawing fall so many scans behind tracking, add() waits: memory is bounded,
  /// whatever the machine.
  std::size_t max_behind = 10'000;
  double map_period_s = 2.0;  ///< A map is drawn no more often.
  /// At most this share of the time goes into maps that are drawn on the way: large ones come less
  /// often. Loops are closed as in Mapper.
  double max_drawing_share = 0.3;
  int drawing_niceness = 10;  ///< How far closing and drawing stand behind tracking (nice(1)).

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// What a live mapper has done so far.
struct LiveCounts {
  bool is_placed = true;        ///< Whether the robot's place in the map is known.
  std::size_t num_scans = 0;    ///< That came.
  std::size_t num_lost = 0;     ///< Of these, not placed.
  std::size_t num_behind = 0;   ///< Tracked, but not yet part of the growing map.
  std::size_t num_maps = 0;     ///< Drawn.
  std::size_t num_undrawn = 0;  ///< Maps that could not be made of what came.
  std::size_t num_again = 0;    ///< Times that all was tracked again.
  double map_duration_s = 0.0;  ///< That drawing the last map took.
};

/// Maps while the robot drives: each scan is placed at once, loops are closed and maps drawn beside
/// it, on a thread that stands back.
///
///   LiveMapper mapper({}, on_map);
///   for each scan: publish(mapper.add(scan, T_wheels_base));
///   const Map map = mapper.finish();  // what Mapper with these parameters gives: the same bytes
///
/// Tracking does not wait for closing, solving or drawing (but for LiveMapperParams::max_behind).
/// Where all that came is to be tracked again (LogTracker: a sweep time was found, the odometry
/// refuted), that is done beside, too, while poses go on by what was known before. Memory grows
/// with the building, not with the time: of known ground the oldest poses are forgotten.
class LiveMapper {
 public:
  /// Told of each new map, on the other thread; must not call the mapper's finish().
  using OnMap = std::function<void(const LiveMapPtr&)>;

  /// Throws ParameterError that names the field, or where the map to go on with does not tell its
  /// track.
  explicit LiveMapper(const LiveMapperParams& params = {}, OnMap on_map = {});
  /// What is not yet part of the map is given up.
  ~LiveMapper();
  LiveMapper(const LiveMapper&) = delete;
  LiveMapper& operator=(const LiveMapper&) = delete;

  // Each is called by one thread at a time.

  /// As Mapper::add(). Throws ParameterError, and what the other thread has thrown.
  LivePose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base = std::nullopt);
  /// As Mapper::add_turn_rate().
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s);
  /// The map of all scans so far, as Mapper::finish(): waits until they are part of it. More may
  /// follow. Throws what the other thread has thrown.
  [[nodiscard]] Map finish();

  // Called by any thread.

  /// A map of all that has come so far, drawn as soon as closing is done with it; null where there
  /// is nothing to draw. Not to be waited for by the thread that adds scans: they go on.
  [[nodiscard]] std::future<LiveMapPtr> request_map();
  /// The last map that was drawn; null before the first.
  [[nodiscard]] LiveMapPtr last_map() const;
  [[nodiscard]] LiveCounts counts() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace setsquare
