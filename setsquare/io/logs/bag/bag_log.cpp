// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/bag_log.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "setsquare/core/joined.hpp"
#include "setsquare/io/logs/bag/topic_role.hpp"
#include "setsquare/io/ros/echo_choice.hpp"

namespace setsquare {
namespace {

/// Topics whose log time minus stamp differs by more have stamps of different clocks.
constexpr std::int64_t kMaxClockDifference_ns = 5'000'000'000;

Pose2 flattened(const Eigen::Vector3d& position_m, const Eigen::Quaterniond& orientation) {
  const Eigen::Vector3d forward = orientation.normalized() * Eigen::Vector3d::UnitX();
  return {position_m.x(), position_m.y(), std::atan2(forward.y(), forward.x())};
}

Eigen::Isometry3d in_space(const Eigen::Vector3d& position_m, const Eigen::Quaterniond& q) {
  return Eigen::Translation3d(position_m) * q.normalized();
}

/// A speed in m/s or rad/s; nothing where it is none, whatever a driver's unit is.
std::optional<double> if_possible(double speed) {
  constexpr double kFastest = 1e4;
  return std::abs(speed) <= kFastest ? std::optional(speed) : std::nullopt;
}

std::string text_of_frames(const ros::TransformStamped& transform) {
  return fmt::format("transform {} -> {}", transform.frame_id, transform.child_frame_id);
}

ros::SliceParams slice_params(const CloudSlice& slice) {
  ros::SliceParams params;
  if (slice.ring) {
    params.kind = ros::SliceKind::kRing;
    params.ring = *slice.ring;
  } else if (slice.low_m) {
    params.kind = ros::SliceKind::kHeights;
    params.low_m = *slice.low_m;
    params.high_m = *slice.high_m;
  }
  return params;
}

}  // namespace

BagLog::BagLog(std::unique_ptr<MessageSource> source, const LogOptions& options)
    : source_(std::move(source)),
      options_(options),
      trust_(source_->has_arrival_times()),
      odometry_(options.odometry_topic) {
  source_->set_wanted([](const MessageTopic& topic) { return role_of(topic) != TopicRole::kNone; });
}

bool BagLog::read(LogRecord& record) {
  for (;;) {
    if (!pending_.empty() && is_ready(pending_.front())) {
      const bool is_good = complete(pending_.front());
      if (is_good) std::swap(record, pending_.front().record);
      spare_.push_back(std::move(pending_.front()));
      pending_.pop_front();
      if (is_good) return true;
      continue;
    }
    if (is_at_end_) {
      if (!std::exchange(is_end_told_, true)) remark_at_end();
      return false;
    }
    Message message;
    is_at_end_ = !source_->read(message);
    if (!is_at_end_) take(message);
  }
}

// --- Messages taken in ------------------------------------------------------------------------

void BagLog::take(const Message& message) {
  first_log_time_ = std::min(first_log_time_.value_or(message.log_time), message.log_time);
  last_log_time_ = std::max(last_log_time_, message.log_time);
  const auto entry = readers_.try_emplace(message.topic, source_->topics()[message.topic]);
  const bool is_new = entry.second;
  TopicReader& reader = entry.first->second;
  const TopicRole role = reader.role;
  if (role == TopicRole::kScan || role == TopicRole::kMultiEchoScan) has_scan_topic_ = true;
  std::visit(
      [&](auto& topic) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(topic)>, std::monostate>) {
          if (is_new && !topic.decoder.remark().empty()) {
            remark_once(topic_name(message) + ": " + topic.decoder.remark());
          }
          const std::string_view fault = topic.decoder.decode(message.data, topic.message);
          if (fault.empty()) {
            dispatch(topic.message, message, role);
          } else {
            add_damage(message, fault);
          }
        }
      },
      *reader.decoder);
}

void BagLog::dispatch(ros::LaserScan& scan, const Message& message, TopicRole /*role*/) {
  const Timestamp stamp = stamp_of(scan.stamp, message);
  if (!is_believed(stamp, scan.frame_id, message)) return;
  Pending& pending = add_pending(RecordKind::kScan, message, stamp);
  std::vector<double> memory = std::move(pending.scan.ranges_m);
  pending.scan = std::move(scan);
  scan.ranges_m = std::move(memory);  // For the topic's next message.
  pending.scan.stamp = stamp;
  pending.scan.frame_id = std::string(ros::plain_frame_name(pending.scan.frame_id));
}

void BagLog::dispatch(ros::MultiEchoLaserScan& scan, const Message& message, TopicRole role) {
  ros::choose_echoes(
      scan, options_.takes_strongest_echo ? ros::EchoChoice::kStrongest : ros::EchoChoice::kFirst);
  dispatch(static_cast<ros::LaserScan&>(scan), message, role);
}

/// A cloud is too large to wait: it is sliced at once, or left out while its sensor's place may
/// still come.
void BagLog::dispatch(ros::PointCloud2& cloud, const Message& message, TopicRole /*role*/) {
  if (has_scan_topic_ && options_.sensor != topic_name(message)) return;
  const Timestamp stamp = stamp_of(cloud.stamp, message);
  if (!is_believed(stamp, cloud.frame_id, message)) return;
  cloud.stamp = stamp;
  const ros::TransformLookup mounting =
      mounting_of(std::string(ros::plain_frame_name(cloud.frame_id)), stamp);
  if (!mounting.is_found() && is_beginning()) return;
  if (!mounting.is_found()) remark_on_place(topic_name(message), mounting.reason);
  const auto slicer = slicers_.try_emplace(topic_name(message), slice_params(options_.slice)).first;
  Pending& pending = add_pending(RecordKind::kScan, message, stamp);
  pending.is_of_cloud = true;
  const std::string_view fault =
      slicer->second.slice(cloud, mounting.T_target_source, pending.record.scan);
  if (fault.empty()) return;
  add_damage(message, fault);
  spare_.push_back(std::move(pending_.back()));
  pending_.pop_back();
}

void BagLog::dispatch(const ros::Odometry& odometry, const Message& message, TopicRole role) {
  const ros::TransformFault bad = ros::fault_of_pose(odometry.position_m, odometry.orientation);
  if (ros::is_refused(bad)) return add_damage(message, ros::to_text(bad));
  const Timestamp stamp = stamp_of(odometry.stamp, message);
  const Pose2 pose = flattened(odometry.position_m, odometry.orientation);
  if (role == TopicRole::kReferenceOdometry) {
    add_pending(RecordKind::kTruePose, message, stamp).record.T_map_base = pose;
    return;
  }
  const std::string_view fault =
      trust_.fault_of(topic_name(message),
                      {.stamp = stamp,
                       .log_time = message.log_time,
                       .frames = odometry.frame_id + ' ' + odometry.child_frame_id,
                       .pose = in_space(odometry.position_m, odometry.orientation)});
  if (!fault.empty()) return add_damage(message, fault);
  add_odometry(topic_name(message), message, stamp, pose, odometry.child_frame_id);
  if (topic_name(message) != odometry_.chosen()) return;
  LogRecord& record = add_pending(RecordKind::kOdometry, message, stamp).record;
  record.T_odom_base = pose;
  record.forward_m_per_s = if_possible(odometry.velocity_m_per_s.x());
  record.turn_rad_per_s = if_possible(odometry.turn_rate_rad_per_s.z());
}

void BagLog::dispatch(const ros::PoseStamped& pose, const Message& message, TopicRole /*role*/) {
  const ros::TransformFault bad = ros::fault_of_pose(pose.position_m, pose.orientation);
  if (ros::is_refused(bad)) return add_damage(message, ros::to_text(bad));
  add_pending(RecordKind::kTruePose, message, stamp_of(pose.stamp, message)).record.T_map_base =
      flattened(pose.position_m, pose.orientation);
}

void BagLog::dispatch(const ros::Imu& imu, const Message& message, TopicRole /*role*/) {
  if (!imu.has_turn_rate() || !imu.turn_rate_rad_per_s.allFinite()) return;
  if (!if_possible(imu.turn_rate_rad_per_s.norm())) {
    return add_damage(message, "a turn rate that nothing has");
  }
  const Timestamp stamp = stamp_of(imu.stamp, message);
  const std::string_view fault = trust_.fault_of(
      topic_name(message), {.stamp = stamp, .log_time = message.log_time, .frames = imu.frame_id});
  if (!fault.empty()) return add_damage(message, fault);
  const ros::TransformLookup mounting =
      mounting_of(std::string(ros::plain_frame_name(imu.frame_id)), stamp);
  const Eigen::Vector3d of_base = mounting.T_target_source.linear() * imu.turn_rate_rad_per_s;
  add_pending(RecordKind::kTurnRate, message, stamp).record.turn_rad_per_s = of_base.z();
}

void BagLog::dispatch(const ros::TfMessage& transforms, const Message& message, TopicRole role) {
  for (const ros::TransformStamped& transform : transforms.transforms) {
    add_transform(transform, message, role);
  }
}

void BagLog::add_transform(const ros::TransformStamped& transform,
                           const Message& message,
                           TopicRole role) {
  const bool is_static = role == TopicRole::kStaticTransforms;
  if (!is_static && !is_believed(transform, message)) return;
  const ros::TransformFault fault = frames_.add(transform, is_static);
  if (ros::is_refused(fault)) {
    return add_damage(message, ros::to_text(fault), text_of_frames(transform));
  }
  if (fault != ros::TransformFault::kNone) {
    remark_once(fmt::format(
        "{}: {}: {}", topic_name(message), text_of_frames(transform), ros::to_text(fault)));
  }
  if (is_static || !frames_.is_odometry(transform, message.log_time)) return;
  const Pose2 pose = flattened(transform.translation_m, transform.rotation);
  const Timestamp stamp = stamp_of(transform.stamp, message);
  add_odometry(BagOdometry::kTransforms, message, stamp, pose, transform.child_frame_id);
  if (odometry_.chosen() == BagOdometry::kTransforms) {
    add_pending(RecordKind::kOdometry, message, stamp).record.T_odom_base = pose;
  }
}

bool BagLog::is_believed(const ros::TransformStamped& transform, const Message& message) {
  const bool is_pose =
      !ros::is_refused(ros::fault_of_pose(transform.translation_m, transform.rotation));
  if (!is_pose || !frames_.must_go_on(transform)) return true;
  const bool has_stamp = transform.stamp.ns != 0 && is_possible(transform.stamp);
  const std::string_view fault =
      trust_.fault_of(std::string(ros::plain_frame_name(transform.child_frame_id)),
                      {.stamp = has_stamp ? transform.stamp : message.log_time,
                       .log_time = message.log_time,
                       .frames = std::string(ros::plain_frame_name(transform.frame_id)),
                       .pose = in_space(transform.translation_m, transform.rotation)});
  if (!fault.empty()) add_damage(message, fault, text_of_frames(transform));
  return fault.empty();
}

bool BagLog::is_believed(Timestamp stamp, const std::string& frame_id, const Message& message) {
  const std::string frame(ros::plain_frame_name(frame_id));
  const std::string_view fault = trust_.fault_of(topic_name(message),
                                                 {.stamp = stamp,
                                                  .log_time = message.log_time,
                                                  .frames = frame,
                                                  .is_placed = frames_.is_known(frame)});
  if (!fault.empty()) add_damage(message, fault);
  return fault.empty();
}

void BagLog::add_odometry(const std::string& topic,
                          const Message& message,
                          Timestamp stamp,
                          const Pose2& T_odom_base,
                          std::string_view base_frame) {
  odometry_clock_offset_ns_[topic] = message.log_time.ns - stamp.ns;
  odometry_arrivals_[topic] = message.log_time;
  odometry_.add(topic, stamp, T_odom_base, std::string(ros::plain_frame_name(base_frame)));
}

BagLog::Pending& BagLog::add_pending(RecordKind kind, const Message& message, Timestamp stamp) {
  if (spare_.empty()) {
    pending_.emplace_back();
  } else {
    pending_.push_back(std::move(spare_.back()));
    spare_.pop_back();
  }
  Pending& pending = pending_.back();
  LogRecord& record = pending.record;
  record.kind = kind;
  record.sensor = topic_name(message);
  record.stamp = stamp;
  record.T_odom_base.reset();
  record.T_map_base.reset();
  record.forward_m_per_s.reset();
  record.turn_rad_per_s.reset();
  record.position = message.position;
  pending.arrival = message.log_time;
  pending.newest_of_topic = &newest_stamps_[record.sensor];
  *pending.newest_of_topic = std::max(*pending.newest_of_topic, stamp);
  pending.clock_offset_ns = message.log_time.ns - stamp.ns;
  pending.is_of_cloud = false;
  record.has_assumed_bearings = false;
  return pending;
}

// --- Records handed on ------------------------------------------------------------------------

bool BagLog::is_ready(const Pending& pending) const {
  if (is_at_end_ || pending_.size() >= kMaxPending) return true;
  if (pending.record.kind != RecordKind::kScan) return true;
  if (pending.is_of_cloud && is_beginning()) return false;  // a topic of scans may come
  return is_mounting_settled(pending) && is_odometry_settled(pending);
}

bool BagLog::is_beginning() const {
  return seconds_between(*first_log_time_, last_log_time_) < kMaxWaitForFrame_s;
}

bool BagLog::is_mounting_settled(const Pending& pending) const {
  const std::string& frame = pending.scan.frame_id;
  // A program that makes a recording of another file is done in no time by its own clock.
  const double waited_s = std::max(seconds_between(pending.arrival, last_log_time_),
                                   seconds_between(pending.record.stamp, *pending.newest_of_topic));
  if (pending.is_of_cloud || frame.empty() || unplaced_frames_.contains(frame) ||
      waited_s > kMaxWaitForFrame_s) {
    return true;
  }
  const ros::TransformLookup mounting = mounting_of(frame, pending.record.stamp);
  if (mounting.is_found()) return true;
  const bool may_come_soon = mounting.status == ros::LookupStatus::kOutsideOfTime;
  return may_come_soon && waited_s > kMaxWaitForOdometry_s;
}

bool BagLog::is_odometry_settled(const Pending& pending) const {
  const double waited_s = seconds_between(pending.arrival, last_log_time_);
  if (odometry_.chosen().empty()) return !is_beginning();
  const auto last = odometry_arrivals_.find(odometry_.chosen());
  if (last != odometry_arrivals_.end() &&
      seconds_between(last->second, pending.arrival) > kSilentOdometry_s) {
    return true;
  }
  return waited_s > kMaxWaitForOdometry_s || odometry_.reaches(in_odometry_clock(pending));
}

bool BagLog::complete(Pending& pending) {
  if (pending.record.kind != RecordKind::kScan) return true;
  if (pending.is_of_cloud && has_scan_topic_ && options_.sensor != pending.record.sensor) {
    return false;
  }
  odometry_.settle();
  pending.record.T_odom_base = odometry_.at(in_odometry_clock(pending));
  ++num_scans_;
  if (!pending.record.T_odom_base) ++num_without_odometry_;
  if (pending.is_of_cloud) return true;
  const std::string& frame = pending.scan.frame_id;
  ros::TransformLookup mounting;
  if (!unplaced_frames_.contains(frame)) mounting = mounting_of(frame, pending.record.stamp);
  if (!mounting.is_found() && unplaced_frames_.insert(frame).second) {
    remark_on_place(pending.record.sensor, mounting.reason);
  }
  const std::string_view fault = placed_[pending.record.sensor].place(
      std::move(pending.scan), mounting.T_target_source, pending.record.scan);
  if (!fault.empty()) {
    add_damage(pending.record.sensor, pending.record.position, fault);
  } else if (mounting.is_found()) {
    frames_.add_placed(frame, odometry_.base_frame(), mounting.T_target_source);
  }
  return fault.empty();
}

ros::TransformLookup BagLog::mounting_of(const std::string& frame, Timestamp stamp) const {
  return frames_.mounting_of(frame, odometry_.base_frame(), stamp, kMaxWaitForOdometry_s);
}

Timestamp BagLog::in_odometry_clock(const Pending& pending) const {
  const auto offset = odometry_clock_offset_ns_.find(odometry_.chosen());
  if (offset == odometry_clock_offset_ns_.end()) return pending.record.stamp;
  const std::int64_t difference_ns = pending.clock_offset_ns - offset->second;
  if (std::abs(difference_ns) <= kMaxClockDifference_ns) return pending.record.stamp;
  return {pending.record.stamp.ns + difference_ns};
}

// --- What is told -----------------------------------------------------------------------------

const std::string& BagLog::topic_name(const Message& message) const {
  return source_->topics()[message.topic].name;
}

Timestamp BagLog::stamp_of(Timestamp header, const Message& message) {
  if (header.ns != 0 && is_possible(header)) return header;
  ++num_without_stamp_[topic_name(message)];
  return message.log_time;
}

void BagLog::add_damage(const Message& message, std::string_view reason, const std::string& place) {
  add_damage(topic_name(message), message.position, reason, place);
}

void BagLog::add_damage(const std::string& topic,
                        std::uint64_t position,
                        std::string_view reason,
                        const std::string& place) {
  problems().add(fmt::format("offset {}", position),
                 fmt::format("{}: {}{}{}", topic, place, place.empty() ? "" : ": ", reason));
  trust_.count(topic, reason);
  source_->left_out();
}

void BagLog::remark_once(const std::string& remark) {
  constexpr std::size_t kMaxRemarks = 100;
  if (remarks_made_.size() < kMaxRemarks && remarks_made_.insert(remark).second) {
    problems().remarks.push_back(remark);
  }
}

void BagLog::remark_on_place(const std::string& topic, const std::string& reason) {
  remark_once(fmt::format(
      "{}: the laser's place on the robot is not known ({}); taken to be at the robot's frame",
      topic,
      reason.empty() ? "its messages name no frame" : reason));
}

void BagLog::remark_at_end() {
  for (const auto& [topic, count] : num_without_stamp_) {
    remark_once(fmt::format(
        "{}: {} messages carry no usable stamp; the time of recording is used", topic, count));
  }
  for (const std::string& remark : trust_.remarks()) problems().remarks.push_back(remark);
  for (const auto& [topic, scans] : placed_) {
    for (const std::string& remark : scans.remarks()) remark_once(topic + ": " + remark);
  }
  if (!odometry_.others().empty() && options_.odometry_topic.empty()) {
    remark_once(fmt::format("odometry is taken from {}, not from {} (--odometry-topic chooses)",
                            odometry_.chosen(),
                            joined(odometry_.others())));
  }
  for (const LogProblem& problem : source_->problems().first) {
    problems().add(problem.location, problem.reason);
  }
  problems().num_damaged += source_->problems().num_damaged - source_->problems().first.size();
  for (const std::string& remark : source_->problems().remarks) remark_once(remark);
  remark_on_odometry();
}

void BagLog::remark_on_odometry() {
  constexpr double kWorthTelling = 0.1;  // At a recording's ends a few scans have none.
  const double share = static_cast<double>(num_without_odometry_) / static_cast<double>(num_scans_);
  if (odometry_.chosen().empty() || !(share > kWorthTelling)) return;
  remark_once(
      fmt::format("{} has no pose near the stamps of {} of the {} scans: they are taken "
                  "without odometry",
                  odometry_.chosen(),
                  num_without_odometry_,
                  num_scans_));
}

RecordingFrame BagLog::frame_of(const ros::TransformTree::Link& link) const {
  constexpr double kAnyTime_s = 1e12;
  const Eigen::Isometry3d T =
      frames_.tree().look_up(link.parent, link.child, last_log_time_, kAnyTime_s).T_target_source;
  const Eigen::Matrix3d& R = T.linear();
  return {.name = link.child,
          .parent = link.parent,
          .is_static = link.is_static,
          .x_m = T.translation().x(),
          .y_m = T.translation().y(),
          .z_m = T.translation().z(),
          .roll_rad = std::atan2(R(2, 1), R(2, 2)),
          .pitch_rad = std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2))),
          .yaw_rad = std::atan2(R(1, 0), R(0, 0))};
}

RecordingOverview BagLog::overview() const {
  RecordingOverview overview;
  for (std::size_t i = 0; i < source_->topics().size(); ++i) {
    const MessageTopic& topic = source_->topics()[i];
    overview.topics.push_back(
        {topic.name, topic.type, source_->num_messages()[i], role_of(topic) != TopicRole::kNone});
  }
  for (const ros::TransformTree::Link& link : frames_.tree().links()) {
    overview.frames.push_back(frame_of(link));
  }
  overview.first = first_log_time_.value_or(Timestamp{});
  overview.last = last_log_time_;
  overview.odometry = odometry_.chosen();
  overview.base_frame = odometry_.base_frame();
  return overview;
}

}  // namespace setsquare
