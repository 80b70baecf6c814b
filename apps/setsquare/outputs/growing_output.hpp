// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/setsquare/outputs/ending_signals.hpp"
#include "apps/setsquare/outputs/inputs.hpp"
#include "setsquare/core/save_file.hpp"

namespace setsquare::app {

/// The one file of a run that is too large for memory: written piece by piece under a temporary
/// name, or to standard output. Ctrl-C, SIGTERM and SIGHUP remove what is not whole.
class GrowingOutput {
 public:
  /// `path` is "-" for standard output. Throws FileError where it names an input or a directory, or
  /// where no file of that name can be made.
  GrowingOutput(const std::string& path, const InputPaths& inputs);

  /// Throws FileError.
  void append(std::string_view bytes);

  /// The file takes its name. Throws FileError.
  void commit();

 private:
  std::optional<GrowingFile> file_;  ///< Nothing for standard output.
  EndingSignals signals_;            ///< The last member: its thread uses the file.
};

}  // namespace setsquare::app
