// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "setsquare/core/pose2.hpp"
#include "setsquare/io/bytes/byte_cursor.hpp"

namespace setsquare {

/// What stands before every serialised MRPT object: class name and version.
struct MrptHeader {
  std::string_view class_name;  ///< Without namespaces; points into the bytes read.
  int version = 0;
  bool has_end_flag = true;  ///< Not before MRPT 0.5.5.
};

/// Closes every object since MRPT 0.5.5.
inline constexpr std::uint8_t kMrptEndFlag = 0x88;

/// Reads an object's header; nothing where the bytes are not a header.
[[nodiscard]] std::optional<MrptHeader> read_mrpt_header(ByteCursor& bytes);

/// Reads the end flag of an object with this header; false where it is missing.
[[nodiscard]] bool read_mrpt_end(ByteCursor& bytes, const MrptHeader& header);

/// A pose in space: position (m) and rotation matrix, row by row.
struct MrptPose3 {
  std::array<double, 3> position_m{};
  std::array<double, 9> rotation{};
};

/// A whole CPose3D, versions 0 to 3; nothing where there is none.
[[nodiscard]] std::optional<MrptPose3> read_mrpt_pose3(ByteCursor& bytes);

/// A whole CPose2D, versions 0 and 1, finite; nothing where there is none.
[[nodiscard]] std::optional<Pose2> read_mrpt_pose2(ByteCursor& bytes);

/// Skips a whole matrix of float (the covariance that old scans carry).
[[nodiscard]] bool skip_mrpt_matrix(ByteCursor& bytes);

}  // namespace setsquare
