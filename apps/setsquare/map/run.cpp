// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/run.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "apps/setsquare/progress_bar.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/paper_mapper.hpp"

namespace setsquare::app {
namespace {

/// Keeps the keyframes, and the scans that moved on since the last one kept, by 0.1 m or 5 deg:
/// whole, in memory, so that it grows with the way driven.
class PictureScans {
 public:
  void add(const Scan& scan, const TrackedPose& tracked, std::size_t index) {
    constexpr double kSpacing_m = 0.1;
    constexpr double kTurn_rad = rad_from_deg(5.0);
    if (!kept_.empty() && !tracked.is_keyframe) {
      const Pose2 moved = T_odom_last_.inverse() * tracked.T_odom_sensor;
      if (std::hypot(moved.x_m, moved.y_m) < kSpacing_m && std::abs(moved.theta_rad) < kTurn_rad) {
        return;
      }
    }
    T_odom_last_ = tracked.T_odom_sensor;
    kept_.push_back({scan, index});
  }

  [[nodiscard]] std::vector<PictureScan> take() { return std::move(kept_); }

 private:
  std::vector<PictureScan> kept_;
  Pose2 T_odom_last_;
};

/// Feeds the log to a mapper; `add` takes a record and gives the TrackedPose.
template <typename Add>
void feed(LogReader& reader, MapRun& run, Add add) {
  PictureScans picture_scans;
  ProgressBar progress("mapping");
  std::size_t index = 0;
  while (const LogRecord* record = reader.next()) {
    const TrackedPose tracked = add(*record);
    picture_scans.add(record->scan, tracked, index++);
    progress.advance(reader.fraction_read());
  }
  run.picture_scans = picture_scans.take();
}

}  // namespace

MapRun run_map(LogReader& reader, const MapOptions& options, StageClock& clock) {
  MapRun run;
  clock.begin("tracking and closing");
  if (options.preset == Preset::kPaper) {
    PaperMapper mapper;
    feed(reader, run, [&](const LogRecord& record) { return mapper.add(record.scan); });
    clock.begin("finishing");
    run.track = mapper.finish();
  } else {
    MapperParams params;
    params.num_threads = options.num_threads;
    Mapper mapper(params);
    feed(reader, run, [&](const LogRecord& record) {
      const std::optional<Pose2> T_wheels_base =
          options.uses_odometry ? record.T_odom_base : std::nullopt;
      run.num_with_odometry += T_wheels_base.has_value();
      return mapper.add(record.scan, T_wheels_base);
    });
    clock.begin("finishing");
    run.track = mapper.finish();
  }
  run.open_stretches = open_stretches(run.track);
  run.format = reader.format();
  run.sensor = options.log.sensor.empty() ? reader.front_sensor() : options.log.sensor;
  run.problems = reader.problems();
  return run;
}

}  // namespace setsquare::app
