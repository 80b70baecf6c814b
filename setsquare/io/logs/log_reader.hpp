// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {
/// A record that could not be read and was skipped.
struct LogProblem {
  std::string location;  ///< "line 12" or "offset 3456".
  std::string reason;    ///< What is wrong with it, in lower-case words.
};

/// What is wrong with a log, as far as it has been read.
struct LogProblems {
  /// Damaged records that are kept with their places.
  static constexpr std::size_t kMaxKept = 20;

  std::uint64_t num_damaged = 0;     ///< Records skipped, all of them.
  std::vector<LogProblem> first;     ///< The first kMaxKept of them.
  std::vector<std::string> remarks;  ///< What concerns the whole log, one sentence each.

  /// Whether nothing was wrong.
  [[nodiscard]] bool empty() const { return num_damaged == 0 && remarks.empty(); }
  /// Counts a damaged record, and keeps it where it is one of the first.
  void add(std::string location, std::string reason) {
    ++num_damaged;
    if (first.size() < kMaxKept) first.push_back({std::move(location), std::move(reason)});
  }
};

/// One sentence for the end of a run, naming the first damaged record: "3 damaged records skipped,
/// the first at line 12: ...". Empty where there is none.
[[nodiscard]] std::string summary(const LogProblems& problems);

/// What a record of a log holds.
enum class RecordKind {
  kScan,      ///< One sweep of one laser.
  kOdometry,  ///< A robot pose by odometry alone, without a scan.
  kTruePose,  ///< The robot's true pose, as a simulator writes it, or a reference by other means.
  kTurnRate,  ///< A gyro's sample: how fast the robot turns, counterclockwise seen from above.
};

/// One record of a log, whatever the log's format. Fields that a kind does not use are empty.
struct LogRecord {
  RecordKind kind = RecordKind::kScan;  ///< Which of the fields below are used.
  std::string sensor;  ///< Name in the log: "FLASER", "ROBOTLASER1", a sensor label, "ODOM".
  Timestamp stamp;     ///< Sensor time; equals scan.stamp for a scan.
  Scan scan;  ///< kScan: ranges in m, mounting included; Scan::scanner is another for each sensor.
  /// kScan: the log states no angles of the beams; those of LogOptions stand in.
  bool has_assumed_bearings = false;
  std::optional<Pose2> T_odom_base;       ///< The robot's odometry pose, where the record has one.
  std::optional<Pose2> T_map_base;        ///< kTruePose: the robot's true pose.
  std::optional<double> forward_m_per_s;  ///< kOdometry: speed that the wheels report.
  std::optional<double> turn_rad_per_s;   ///< kOdometry, kTurnRate: by the wheels, by the gyro.
  std::uint64_t position = 0;  ///< Line number from 1 in a text log, byte offset in a binary one.
};

/// A topic of a recording of messages (a bag).
struct RecordingTopic {
  std::string name;                ///< With its slash: "/scan".
  std::string type;                ///< "sensor_msgs/LaserScan".
  std::uint64_t num_messages = 0;  ///< In the whole recording.
  bool is_read = false;            ///< Whether it is one of those that are made into records.
};

/// Where a frame stands in its parent: the last transform that the recording has of it.
struct RecordingFrame {
  std::string name;        ///< As the recording has it: "laser".
  std::string parent;      ///< The frame in which it stands.
  bool is_static = false;  ///< Whether it came by tf_static: it never moves.
  double x_m = 0.0;        ///< Of its origin in the parent.
  double y_m = 0.0;        ///< The same.
  double z_m = 0.0;        ///< The same; up.
  double roll_rad = 0.0;   ///< About the parent's x axis, applied first.
  double pitch_rad = 0.0;  ///< About its y axis, applied second.
  double yaw_rad = 0.0;    ///< About its z axis, applied last.
};

/// What a recording of messages holds, as far as it has been read.
struct RecordingOverview {
  std::vector<RecordingTopic> topics;  ///< All of them, read or not.
  std::vector<RecordingFrame> frames;  ///< All that tf names.
  Timestamp first;                     ///< When its first message was recorded.
  Timestamp last;                      ///< When its last one was.
  std::string odometry;    ///< The topic whose odometry is used; empty where there is none.
  std::string base_frame;  ///< The robot's frame.

  /// Whether there is nothing: the log is none of messages.
  [[nodiscard]] bool empty() const { return topics.empty(); }
};

/// Which part of a log to read. Times below 1e8 s count from the first scan, others are stamps.
struct LogWindow {
  std::optional<double> from_s;       ///< Earlier scans are left out; nothing: from the first.
  std::optional<double> to_s;         ///< Later scans are left out; nothing: to the last.
  std::optional<double> max_rate_hz;  ///< Scans per second of each laser; others are left out.

  /// Whether all of the log is read.
  [[nodiscard]] bool is_open() const { return !from_s && !to_s && !max_rate_hz; }
};

/// Which points of a 3-D scanner's clouds make a scan. By default all of a flat cloud, else those
/// within 0.3 m of the sensor's height.
struct CloudSlice {
  std::optional<int> ring;       ///< Those of one beam of the scanner.
  std::optional<double> low_m;   ///< Those between two heights above the robot's frame, both given.
  std::optional<double> high_m;  ///< See low_m.
};

/// What rows of angles and distances mean, as hobby scanners print them: such a text states
/// nothing.
struct AngleDistanceOptions {
  /// What a line of the text holds.
  enum class Layout {
    kPairs,        ///< A line is one beam: angle, distance and perhaps a quality.
    kRevolutions,  ///< A line is one revolution: angle, distance, angle, distance ...
  };
  Layout layout = Layout::kPairs;  ///< By default a beam a line.
  bool is_in_degrees = true;       ///< Angles; else rad.
  bool is_clockwise = false;       ///< Angles count clockwise, seen from above.
  double range_unit_m = 0.001;     ///< Of the distances.
  double rate_hz = 10.0;           ///< Revolutions per second: revolution k has the stamp k / rate.
};

/// What to read of a log, and what the log itself does not state.
struct LogOptions {
  /// Which laser's scans: its name in the log, several with commas between, "all", or empty for the
  /// front one (the laser whose
  /// mounting looks most nearly forward; of equal ones the first by name).
  std::string sensor;
  /// Which odometry of a recording that has several: its topic, "/tf" for the frames odom and base,
  /// or empty for the likeliest.
  std::string odometry_topic;
  bool scans_only = true;   ///< Leave out the records of kinds other than kScan ...
  bool turn_rates = false;  ///< ... but for kTurnRate.
  /// Angles of a message that carries none (FLASER, RLASER): the sweep is symmetric about straight
  /// ahead. By default 180 degrees, whose step is field of view / n for an even number of beams n
  /// (180, 360) and field of view / (n - 1) for an odd one (181, 361). Where only the step is
  /// given, the field of view is step * (n - 1).
  std::optional<double> field_of_view_rad;
  /// From a beam to the next, instead of the field of view or together with it.
  std::optional<double> bearing_step_rad;
  /// Ranges at or above it are no-returns. By default what the log states, else 50 m (the lowest
  /// code that logs of SICK scanners use for "nothing seen").
  std::optional<double> max_range_m;
  LogWindow window;  ///< By default all of it.
  CloudSlice slice;  ///< Of 3-D scanners; others have none.
  /// Of a scanner that measures several echoes per beam: the strongest instead of the first.
  bool takes_strongest_echo = false;
  /// Read rows of angles and distances. Ignored where the log's format says what it is.
  std::optional<AngleDistanceOptions> angle_distance;
  /// Metres that the log's unit of ranges stands for: 0.001 where they are in millimetres. A reach
  /// that the log states is taken in the same unit, unless it would be below a metre then.
  double range_scale = 1.0;
  /// Ranges that are no measurement, in m as scaled, to half a millimetre: codes below max_range_m.
  std::vector<double> ignored_ranges_m;
  /// Left and right exchanged: a scanner mounted upside down, or one whose beams are counted
  /// clockwise.
  bool mirrors_scans = false;
  /// From a scan's first beam to its last, in s, whatever the log says: negative where the last is
  /// measured first, 0 where all are measured at once.
  std::optional<double> sweep_time_s;
  /// Of stamps in a log that is text.
  StampUnit stamp_unit = StampUnit::kSeconds;

  /// Where scanners are mounted on the robot, by name, whatever the log says.
  std::map<std::string, Pose2> mountings;

  /// Throws ParameterError naming the field that is out of its domain.
  void validate() const;
};

/// Reads a log record by record, in file order, in bounded memory.
///
///   auto reader = open_log(path);
///   while (const LogRecord* record = reader->next()) mapper.add(record->scan);
class LogReader {
 public:
  /// Closes the file.
  virtual ~LogReader() = default;

  /// The next record, or null at the end. It stays valid until the next call; its vectors are used
  /// again. Damaged records are skipped and counted. Throws FileError where the file cannot be
  /// read further, FormatError at the end of a log that held no scan of the wanted sensor.
  [[nodiscard]] virtual const LogRecord* next() = 0;

  /// What was wrong so far.
  [[nodiscard]] virtual const LogProblems& problems() const = 0;

  /// The laser that LogOptions::sensor means when it is empty; empty before the first next().
  [[nodiscard]] virtual std::string front_sensor() const = 0;

  /// What kind of log it is: "CARMEN log", "JSON lines".
  [[nodiscard]] virtual std::string format() const = 0;

  /// How much of the file has been read, 0 to 1; nothing where the size is unknown (a pipe).
  [[nodiscard]] virtual std::optional<double> fraction_read() const = 0;

  /// What else is in a recording of messages (a bag); empty for other logs.
  [[nodiscard]] virtual RecordingOverview overview() const { return {}; }
};

}  // namespace setsquare
