// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/mrpt/rawlog.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace setsquare {
namespace {

constexpr std::size_t kFirstWindowBytes = 1 << 14;
constexpr std::size_t kLargestWindowBytes = 1 << 20;  // above 65536 beams of 13 bytes

constexpr std::string_view kScanClass = "CObservation2DRangeScan";
constexpr std::string_view kOdometryClass = "CObservationOdometry";
constexpr std::string_view kMovementClass = "CActionRobotMovement2D";
constexpr std::string_view kFrameClass = "CSensoryFrame";
constexpr std::string_view kActionsClass = "CActionCollection";
constexpr std::array<std::string_view, 5> kKnownClasses = {
    kScanClass, kOdometryClass, kMovementClass, kFrameClass, kActionsClass};

bool is_known(std::string_view class_name) {
  return std::find(kKnownClasses.begin(), kKnownClasses.end(), class_name) != kKnownClasses.end();
}

/// Whether an object that we know begins here, as MRPT writes it since 0.5.5.
bool is_known_object(std::string_view bytes) {
  if (bytes.empty() || (static_cast<unsigned char>(bytes.front()) & 0x80U) == 0) return false;
  ByteCursor cursor(bytes);
  const auto header = read_mrpt_header(cursor);
  return header && is_known(header->class_name);
}

}  // namespace

bool is_mrpt_rawlog(std::string_view beginning) {
  ByteCursor bytes(beginning);
  return read_mrpt_header(bytes).has_value();
}

MrptRawlog::MrptRawlog(std::unique_ptr<InputBuffer> input, const LogOptions& options)
    : input_(std::move(input)), scans_only_(options.scans_only) {}

MrptRawlog::Attempt MrptRawlog::attempt_container(ByteCursor& bytes, const MrptHeader& header) {
  constexpr std::uint32_t kMaxObjects = 1 << 20;
  const bool is_frame = header.class_name == kFrameClass;
  const int newest_version = is_frame ? 2 : 0;
  if (header.version < 0 || header.version > newest_version) return {.reason = "version not known"};
  if (is_frame && header.version < 2) bytes.skip(sizeof(std::uint32_t));
  if (is_frame && header.version == 0) bytes.skip(sizeof(std::uint64_t));
  const auto num_objects = bytes.read<std::uint32_t>();
  if (num_objects > kMaxObjects) return {.reason = "number of objects out of bounds"};
  constexpr std::size_t kMaxDepth = 8;
  if (num_left_in_container_.size() >= kMaxDepth) return {.reason = "containers too deep"};
  if (bytes.is_short()) return {.is_short = true};
  num_left_in_container_.push_back(num_objects);
  is_container_old_format_ = !header.has_end_flag;
  return {.num_bytes = bytes.position()};
}

void MrptRawlog::add_movement(const MrptMovement& movement, LogRecord& record) {
  if (!T_odom_base_) is_odometry_summed_ = true;
  T_odom_base_ = T_odom_base_.value_or(Pose2{}) * movement.T_before_after;
  record.kind = RecordKind::kOdometry;
  record.sensor = "odometry";
  record.stamp = movement.stamp;
  record.forward_m_per_s.reset();
  record.turn_rad_per_s.reset();
  record.T_odom_base = T_odom_base_;
}

MrptRawlog::Attempt MrptRawlog::attempt_body(ByteCursor& bytes,
                                             const MrptHeader& header,
                                             LogRecord& record) {
  MrptMovement movement;
  std::string_view reason;
  record.T_map_base.reset();
  if (header.class_name == kScanClass) {
    reason = read_mrpt_scan(bytes, header.version, record);
  } else if (header.class_name == kOdometryClass) {
    reason = read_mrpt_odometry(bytes, header.version, record);
  } else if (header.class_name == kMovementClass) {
    reason = read_mrpt_movement(bytes, header.version, movement);
  } else {
    return {.reason = "an unknown class whose length is not stated"};
  }
  const bool has_end = read_mrpt_end(bytes, header);
  if (bytes.is_short()) return {.reason = "cut short", .is_short = true};
  if (!reason.empty()) return {.reason = std::string(reason)};
  if (!has_end) return {.reason = "end flag missing"};
  if (header.class_name == kMovementClass) {
    add_movement(movement, record);
  } else if (header.class_name == kOdometryClass) {
    T_odom_base_ = record.T_odom_base;
  } else {
    record.T_odom_base = T_odom_base_;
  }
  if (record.kind != RecordKind::kScan) record.scan.ranges_m.clear();
  const bool is_record = record.kind == RecordKind::kScan || !scans_only_;
  return {.num_bytes = bytes.position(), .is_record = is_record};
}

MrptRawlog::Attempt MrptRawlog::attempt(std::string_view bytes, LogRecord& record) {
  ByteCursor cursor(bytes);
  const auto header = read_mrpt_header(cursor);
  if (!header) return {.reason = "no object begins here", .is_short = cursor.is_short()};
  const bool is_container =
      header->class_name == kFrameClass || header->class_name == kActionsClass;
  Attempt outcome =
      is_container ? attempt_container(cursor, *header) : attempt_body(cursor, *header, record);
  if (!outcome.reason.empty())
    outcome.reason = std::string(header->class_name) + ": " + outcome.reason;
  return outcome;
}

void MrptRawlog::resynchronise(const std::string& reason) {
  problems().add(fmt::format("offset {}", input_->offset()), reason);
  num_left_in_container_.clear();
  may_stray_flags_follow_ = true;
  constexpr std::size_t kMaxHeaderBytes = 128;
  std::size_t next = 1;
  while (input_->ensure(next + kMaxHeaderBytes) || input_->available().size() > next) {
    const std::string_view bytes = input_->available();
    const bool is_at_end = bytes.size() <= next + kMaxHeaderBytes;
    const std::size_t num_starts = is_at_end ? bytes.size() : bytes.size() - kMaxHeaderBytes;
    while (next < num_starts && !is_known_object(bytes.substr(next, kMaxHeaderBytes))) ++next;
    input_->consume(next);
    if (next < num_starts) return;
    next = 0;
  }
  input_->consume(input_->available().size());
}

MrptRawlog::Step MrptRawlog::read_object(LogRecord& record) {
  for (std::size_t window = kFirstWindowBytes;; window *= 4) {
    const bool is_all = !input_->ensure(window);
    const std::string_view bytes = input_->available();
    if (bytes.empty()) return Step::kEnd;
    const Attempt outcome = attempt(bytes, record);
    if (outcome.num_bytes > 0) {
      input_->consume(outcome.num_bytes);
      return outcome.is_record ? Step::kRecord : Step::kOther;
    }
    const bool may_grow = outcome.is_short && !is_all && window < kLargestWindowBytes;
    if (may_grow) continue;
    if (may_stray_flags_follow_ && static_cast<std::uint8_t>(bytes.front()) == kMrptEndFlag) {
      input_->consume(1);
      return Step::kOther;
    }
    resynchronise(outcome.reason.empty() ? "cut short" : outcome.reason);
    return Step::kOther;
  }
}

bool MrptRawlog::read(LogRecord& record) {
  for (;;) {
    while (!num_left_in_container_.empty() && num_left_in_container_.back() == 0) {
      num_left_in_container_.pop_back();
      const bool has_flag = input_->ensure(1) &&
                            static_cast<std::uint8_t>(input_->available().front()) == kMrptEndFlag;
      if (has_flag && !is_container_old_format_) input_->consume(1);
    }
    if (!num_left_in_container_.empty()) --num_left_in_container_.back();
    const Step step = read_object(record);
    if (step == Step::kEnd) break;
    if (step == Step::kRecord) return true;
  }
  const bool is_inside_container = !num_left_in_container_.empty();
  if (is_inside_container && !is_damage_reported_) {
    problems().add(fmt::format("offset {}", input_->offset()), "the log ends inside a container");
  }
  is_damage_reported_ = true;
  return false;
}

}  // namespace setsquare
