// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from log_intake, its only caller: which scans, against what is done with them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// Which scans of a log with several scanners a map is made of. The leader's come first: it is the
/// one by which the others are judged. A sweep that the log holds under two names, as CARMEN logs
/// do, counts once.
class ChosenScans {
 public:
  /// `wanted`: LogOptions::sensor, which names several.
  explicit ChosenScans(const std::string& wanted) : wanted_(wanted) {}

  /// Whether to map the scan, the log's next one. `front_sensor`: LogReader::front_sensor().
  [[nodiscard]] bool takes(const LogRecord& record, const std::string& front_sensor);

  /// Sensors that repeat another one: their names, and the other's.
  [[nodiscard]] const std::map<std::string, std::string>& repeated() const { return repeated_; }

  /// Sensors that were named and of which no scan came.
  [[nodiscard]] std::vector<std::string> absent() const;

 private:
  void find_repeated(const LogRecord& record);

  std::string wanted_;
  std::string leader_;
  bool has_leader_come_ = false;
  std::map<std::string, Scan> last_;  ///< By sensor.
  std::map<std::string, int>
      num_compared_;  ///< Scans of a sensor that the others' were compared with.
  std::map<std::string, std::string> repeated_;
};

/// Whether an option's value names several sensors: "all", or a list with commas.
[[nodiscard]] bool names_several(const std::string& sensor);

}  // namespace setsquare
