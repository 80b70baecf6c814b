// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "apps/setsquare/outputs/inputs.hpp"

namespace setsquare::app {

/// The one file that a run writes. It is made before the work begins, so that a name that cannot
/// be written is reported at once.
class OutputFile {
 public:
  /// `path` is "-" for standard output. Throws FileError where it names an input or a directory,
  /// or where no file of that name can be made.
  OutputFile(std::string path, const InputPaths& inputs);

  /// Writes the file in full or not at all (save_file). Throws FileError.
  void write(std::string_view bytes) const;

 private:
  std::string path_;
};

}  // namespace setsquare::app
