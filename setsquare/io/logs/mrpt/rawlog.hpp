// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/bytes/input_buffer.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/logs/mrpt/objects.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {

/// Whether the first bytes are an MRPT object's header.
[[nodiscard]] bool is_mrpt_rawlog(std::string_view beginning);

/// The records of an MRPT rawlog: serialised objects, one behind another, some inside a
/// CSensoryFrame or CActionCollection.
///
/// Objects carry no length, so an object can only be skipped by a reader that knows its class
/// and version. At any other the reader looks for the next object that it knows, by class name, and
/// goes on there; each such gap is counted in problems(). Odometry: the absolute poses of
/// CObservationOdometry, or the sum of the increments of CActionRobotMovement2D.
class MrptRawlog final : public RecordStream {
 public:
  MrptRawlog(std::unique_ptr<InputBuffer> input, const LogOptions& options);

  bool read(LogRecord& record) override;
  double mounting_rounding() const override { return 0.0; }
  bool is_odometry_summed() const override { return is_odometry_summed_; }
  std::string format() const override { return "MRPT rawlog"; }
  std::optional<double> fraction_read() const override { return input_->source().fraction_read(); }
  std::string damage() const override { return input_->source().damage(); }

 private:
  enum class Step { kRecord, kOther, kEnd };

  /// One object, or the head of a container, at the front of `bytes`.
  struct Attempt {
    std::string reason = {};    ///< Why the object cannot be read; empty where it was.
    std::size_t num_bytes = 0;  ///< What it took.
    bool is_short = false;      ///< The bytes ended before the object did.
    bool is_record = false;     ///< The record was filled.
  };

  Attempt attempt(std::string_view bytes, LogRecord& record);
  Attempt attempt_container(ByteCursor& bytes, const MrptHeader& header);
  Attempt attempt_body(ByteCursor& bytes, const MrptHeader& header, LogRecord& record);
  void add_movement(const MrptMovement& movement, LogRecord& record);
  Step read_object(LogRecord& record);
  void resynchronise(const std::string& reason);

  std::unique_ptr<InputBuffer> input_;
  bool scans_only_ = true;
  /// Objects that the containers around the next one still hold, and whether end flags follow.
  std::vector<std::uint32_t> num_left_in_container_;
  bool is_container_old_format_ = false;
  bool may_stray_flags_follow_ = false;  ///< Of containers lost when resynchronising.
  bool is_damage_reported_ = false;
  std::optional<Pose2> T_odom_base_;
  bool is_odometry_summed_ = false;
};

}  // namespace setsquare
