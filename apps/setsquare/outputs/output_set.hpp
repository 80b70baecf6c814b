// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "apps/setsquare/outputs/output_directory.hpp"

namespace setsquare::app {

/// The results of one run, which belong together: all of them come into their directory, or none.
///
///   OutputSet outputs(path, {"map.pgm", "map.yaml", "run.json"});
///   outputs.add("run.json", bytes);   // ... and the others: kept aside, in `.setsquare-new`
///   outputs.commit();
///
/// commit() renames, for a set of files cannot be replaced at once:
///
/// 1. `.setsquare-new` becomes `.setsquare-whole`: from here on the new set stands, whatever comes.
/// 2. The files of the last set go, the one named last first; `.setsquare-whole` becomes
///    `.setsquare-move`.
/// 3. The new files take their places, the one named last last; `.setsquare-move` goes.
///
/// A run that is killed before step 1 leaves the last set as it was, or none. One that is killed
/// within the steps (some hundred microseconds) leaves a part of the old set or a part of the new
/// one, never files of both and never the one named last, and the next run's OutputSet completes
/// the steps before it begins. What a killed run had kept aside, it removes.
class OutputSet {
 public:
  /// `names`: every file that a set of this kind may hold, the one that tells it whole last. Files
  /// of other names in the directory are left alone. Throws FileError where the directory cannot be
  /// made or written to, another run is about to write there, or a directory has one of the names.
  OutputSet(const std::string& path, std::vector<std::string> names);
  /// Removes what was not committed, and the directories made for it.
  ~OutputSet();
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;

  /// Keeps a file aside; its name is one of the names. Throws FileError.
  void add(const std::string& name, std::string_view bytes);

  /// The files added replace all of the last set. Throws FileError.
  void commit();

  /// Names of the files added, in their order.
  [[nodiscard]] const std::vector<std::string>& added() const { return added_; }

 private:
  void lock();
  void finish_commit();

  OutputDirectory directory_;
  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::string> added_;
  int lock_ = -1;  ///< A descriptor of the directory, locked.
};

}  // namespace setsquare::app
