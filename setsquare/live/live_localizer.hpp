// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/live/live_pose.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/localizer.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// Finds and follows a robot in a map while it drives: each scan is placed at once by what is known
/// of the place so far, the map is searched beside it, on a thread that stands back.
///
///   LiveLocalizer localizer(map, {}, on_place);
///   for each scan: publish(localizer.add(scan, T_wheels_base));
///   localizer.finish();  // on_place was told what Localizer::add() would have given, scan by scan
///
/// Memory is bounded: where the search falls too far behind, it leaves out the oldest scans that
/// wait, so that tracking never waits for it.
class LiveLocalizer {
 public:
  /// How far the search may fall behind.
  struct Behind {
    /// Scans that may wait for being placed: 25 s of a fast scanner's, some 10 MB. Not 0.
    std::size_t max_scans = 1024;
    /// add() waits where so many do, and none is left out: for a log that nobody drives.
    bool waits = false;
  };

  /// Told of each scan's place in its turn, on the other thread; must not call the localizer.
  using OnPlace = std::function<void(const LocalisedPose&)>;

  /// Throws ParameterError that names the field.
  LiveLocalizer(std::shared_ptr<const KnownMap> map,
                const LocalisationParams& params,
                OnPlace on_place,
                const Behind& behind);
  /// The same, with the usual Behind.
  LiveLocalizer(std::shared_ptr<const KnownMap> map,
                const LocalisationParams& params,
                OnPlace on_place);
  /// What is not yet placed is given up.
  ~LiveLocalizer();
  LiveLocalizer(const LiveLocalizer&) = delete;
  LiveLocalizer& operator=(const LiveLocalizer&) = delete;

  // Each is called by one thread at a time.

  /// As Localizer::add(). Throws ParameterError, and what the other thread has thrown.
  LivePose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base = std::nullopt);
  /// Waits until all scans are placed. Throws what the other thread has thrown.
  void finish();

  // Called by any thread.

  /// As Localizer::set_pose(), at the next scan. Throws ParameterError.
  void set_pose(const Pose2& T_map_base);
  /// Scans that wait for being placed.
  [[nodiscard]] std::size_t num_behind() const;
  /// Scans that were left out: the search was too far behind. Nobody was told their places.
  [[nodiscard]] std::size_t num_left_out() const;
  /// Of the last scan that is placed.
  [[nodiscard]] std::optional<LocalisedPose> last_place() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace setsquare
