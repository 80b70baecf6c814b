// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/mrpt/poses.hpp"

#include <algorithm>
#include <cmath>

namespace setsquare {
namespace {

bool is_class_name(std::string_view name) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == ':';
  };
  return (name.starts_with('C') || name.starts_with("mrpt::")) &&
         std::all_of(name.begin(), name.end(), is_allowed);
}

/// The header of a part of an object, which must be of this class.
std::optional<MrptHeader> read_part_header(ByteCursor& bytes, std::string_view class_name) {
  const auto header = read_mrpt_header(bytes);
  if (!header || header->class_name != class_name) return std::nullopt;
  return header;
}

/// CMatrix (of float) or CMatrixD: rows, columns, values row by row.
template <typename Value>
bool read_matrix(ByteCursor& bytes, std::array<double, 16>* values_4x4) {
  const auto header = read_mrpt_header(bytes);
  if (!header || !header->class_name.starts_with("CMatrix") || header->version != 0) return false;
  const auto num_rows = bytes.read<std::uint32_t>();
  const auto num_columns = bytes.read<std::uint32_t>();
  constexpr std::uint32_t kMaxSide = 16;
  if (num_rows > kMaxSide || num_columns > kMaxSide) return false;
  if (values_4x4 == nullptr) {
    bytes.skip(sizeof(Value) * num_rows * num_columns);
  } else {
    if (num_rows != 4 || num_columns != 4) return false;
    for (double& value : *values_4x4) value = static_cast<double>(bytes.read<Value>());
  }
  return read_mrpt_end(bytes, *header);
}

MrptPose3 pose3_from_matrix(const std::array<double, 16>& m) {
  return {{m[3], m[7], m[11]}, {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}};
}

/// Position and quaternion (w x y z).
MrptPose3 read_position_and_quaternion(ByteCursor& bytes) {
  MrptPose3 pose;
  for (double& coordinate : pose.position_m) coordinate = bytes.read<double>();
  const auto w = bytes.read<double>();
  const auto x = bytes.read<double>();
  const auto y = bytes.read<double>();
  const auto z = bytes.read<double>();
  pose.rotation = {w * w + x * x - y * y - z * z,
                   2.0 * (x * y - w * z),
                   2.0 * (x * z + w * y),
                   2.0 * (x * y + w * z),
                   w * w - x * x + y * y - z * z,
                   2.0 * (y * z - w * x),
                   2.0 * (x * z - w * y),
                   2.0 * (y * z + w * x),
                   w * w - x * x - y * y + z * z};
  return pose;
}

}  // namespace

std::optional<MrptHeader> read_mrpt_header(ByteCursor& bytes) {
  constexpr std::uint8_t kNewFormat = 0x80;
  constexpr std::size_t kMaxNameBytes = 120;
  const auto length = bytes.read<std::uint8_t>();
  MrptHeader header;
  header.has_end_flag = (length & kNewFormat) != 0;
  if (!header.has_end_flag && bytes.take(3) != std::string_view("\0\0\0", 3)) return std::nullopt;
  const std::size_t num_name_bytes = length & 0x7fU;
  if (num_name_bytes == 0 || num_name_bytes > kMaxNameBytes) return std::nullopt;
  header.class_name = bytes.take(num_name_bytes);
  if (!is_class_name(header.class_name)) return std::nullopt;
  const std::size_t space = header.class_name.rfind(':');
  if (space != std::string_view::npos) header.class_name.remove_prefix(space + 1);
  header.version = header.has_end_flag ? bytes.read<std::uint8_t>() : bytes.read<std::int32_t>();
  if (bytes.is_short()) return std::nullopt;
  return header;
}

bool read_mrpt_end(ByteCursor& bytes, const MrptHeader& header) {
  return !header.has_end_flag || bytes.read<std::uint8_t>() == kMrptEndFlag;
}

std::optional<MrptPose3> read_mrpt_pose3(ByteCursor& bytes) {
  const auto header = read_part_header(bytes, "CPose3D");
  if (!header) return std::nullopt;
  MrptPose3 pose;
  std::array<double, 16> matrix{};
  if (header->version == 0) {
    if (!read_matrix<float>(bytes, &matrix)) return std::nullopt;
    pose = pose3_from_matrix(matrix);
  } else if (header->version == 1) {
    if (!read_matrix<double>(bytes, &matrix)) return std::nullopt;
    pose = pose3_from_matrix(matrix);
  } else if (header->version == 2) {
    pose = read_position_and_quaternion(bytes);
  } else if (header->version == 3) {
    for (double& coordinate : pose.position_m) coordinate = bytes.read<double>();
    for (double& element : pose.rotation) element = bytes.read<double>();
  } else {
    return std::nullopt;
  }
  if (!read_mrpt_end(bytes, *header)) return std::nullopt;
  return pose;
}

std::optional<Pose2> read_mrpt_pose2(ByteCursor& bytes) {
  const auto header = read_part_header(bytes, "CPose2D");
  if (!header || header->version > 1) return std::nullopt;
  std::array<double, 3> values{};
  for (double& value : values) {
    value = header->version == 0 ? static_cast<double>(bytes.read<float>()) : bytes.read<double>();
    if (!std::isfinite(value)) return std::nullopt;
  }
  if (!read_mrpt_end(bytes, *header)) return std::nullopt;
  return Pose2{values[0], values[1], values[2]};
}

bool skip_mrpt_matrix(ByteCursor& bytes) { return read_matrix<float>(bytes, nullptr); }

}  // namespace setsquare
