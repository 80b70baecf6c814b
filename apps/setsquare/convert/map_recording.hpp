// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "setsquare/io/bags/mcap_writer.hpp"
#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare::app {

struct RecordedMap {
  std::uint64_t num_scans = 0;
  std::uint64_t num_without_pose = 0;  ///< Scans of the log that the map does not hold.
};

/// Writes what `setsquare map` made of a log, with the log's scans, as one MCAP (MapRecording).
/// `folder`: the map's results. Throws FileError, FormatError.
[[nodiscard]] RecordedMap record_map(const std::string& folder,
                                     LogReader& reader,
                                     McapWriter::Sink sink);

}  // namespace setsquare::app
