// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "setsquare/live/driven_way.hpp"
#include "setsquare/live/live_localizer.hpp"
#include "setsquare/live/live_session.hpp"
#include "setsquare/pipeline/chosen_scans.hpp"
#include "setsquare/pipeline/localize_log.hpp"

namespace setsquare {

/// A run in a map that is known: from a log that comes while the robot drives to where it was. What
/// localize_log() does, with poses on the way.
class LocalizingSession final : public LiveSession {
 public:
  struct Options {
    LocalizeLogOptions localising = {};
    double way_period_s = 2.0;  ///< LiveWatcher::on_way is told no more often.
    /// Of so many of the newest scans run() gives the poses, and no more memory is taken; of the
    /// others it counts how they ended (LocalizedLog::left_out). 0: of none.
    std::size_t max_poses = std::numeric_limits<std::size_t>::max();
    LiveLocalizer::Behind behind = {};
  };

  /// `name`: of the log. `map`: read_map_to_localise_in(). Throws ParameterError.
  LocalizingSession(std::string name,
                    MapToLocaliseIn map,
                    const Options& options,
                    LiveWatcher watcher);

  /// Reads the log until it ends; then what localize_log() would have given, but for scans that the
  /// search left out (LiveLocalizer::Behind): a remark tells how many. Throws FileError,
  /// FormatError, ParameterError; FileError, too, where no scan came.
  [[nodiscard]] LocalizedLog run(LogReader& reader);

  // Called by any thread, while run() is.

  /// A pose outside of the map is none.
  bool set_pose(const Pose2& T_map_base) override;
  /// Its grid, and nothing else: there is no more of a map.yaml.
  [[nodiscard]] LiveMapPtr last_map() const override { return map_; }
  [[nodiscard]] LiveReport report() const override;
  /// How many scans ended in each status; as of now, not of LocalizedLog.
  [[nodiscard]] LocalisationCounts counts() const;
  /// Of the last scan that is placed.
  [[nodiscard]] std::optional<LocalisedPose> last_place() const {
    return localizer()->last_place();
  }

 private:
  [[nodiscard]] bool takes(const LogRecord& record, const LogReader& reader) override;
  [[nodiscard]] LivePose add_scan(const LogRecord& record) override;
  void begin_again() override;
  [[nodiscard]] bool knows_start() const override { return false; }

  [[nodiscard]] std::shared_ptr<LiveLocalizer> made_localizer();
  [[nodiscard]] std::shared_ptr<LiveLocalizer> localizer() const;
  void take(const LocalisedPose& place);
  [[nodiscard]] std::size_t num_left_out() const;

  std::string name_;
  Options options_;
  LiveMapPtr map_;
  std::shared_ptr<const KnownMap> known_map_;
  ChosenScans chosen_;
  std::optional<std::uint32_t> scanner_;

  // Of the thread that places.
  DrivenWay way_;
  std::chrono::steady_clock::time_point next_way_;

  mutable std::mutex mutex_;         ///< All below.
  std::deque<LocalisedPose> poses_;  ///< The newest.
  LocalisationCounts left_out_;      ///< Of the scans before these.
  LocalisationCounts counts_;        ///< Of all.
  std::size_t num_scans_ = 0;
  std::size_t num_left_out_before_ = 0;       ///< By localizers before this one.
  std::shared_ptr<LiveLocalizer> localizer_;  ///< The last: its thread uses the others.
};

}  // namespace setsquare
