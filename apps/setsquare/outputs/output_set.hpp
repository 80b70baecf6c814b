// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "apps/setsquare/outputs/ending_signals.hpp"
#include "apps/setsquare/outputs/inputs.hpp"

namespace setsquare::app {

/// The results of one run, which belong together: all of them come into their directory, or none.
///
///   OutputSet outputs(path, {"map.pgm", "map.yaml", "run.json"}, {log_path});
///   outputs.add("run.json", bytes);   // ... and the others: kept aside, in `.setsquare-new`
///   outputs.commit();
///
/// commit() renames, since a set of files cannot be replaced at once:
///
/// 1. `.setsquare-new` becomes `.setsquare-whole`: from here on the new set stands, whatever comes.
/// 2. The files of the last set go, the one named last first; `.setsquare-whole` becomes
///    `.setsquare-move`.
/// 3. The new files take their places, the one named last last; `.setsquare-move` goes.
///
/// A run that is killed before step 1 leaves the last set as it was, or none. One that is killed
/// within the steps (some hundred microseconds) leaves a part of the old set or a part of the new
/// one, never files of both and never the one named last; the next run's OutputSet completes the
/// steps before it begins. What a killed run had kept aside, the next one removes; Ctrl-C, SIGTERM
/// and SIGHUP remove it at once, and wait for the end of the steps.
///
/// Why not one exchange of two directories: the user's directory may hold files of other names,
/// which must stay what they are. A directory to exchange it for would need a hard link to each of
/// them, and would lose what another program writes there meanwhile, sub-directories, and the place
/// of every process that works in it; and not all file systems can exchange. Renames of files keep
/// the promise everywhere.
class OutputSet {
 public:
  /// `names`: every file that a set of this kind may hold; the last one stands for a whole set. A
  /// name that ends with a slash, "pieces/", stands for the numbered files of that folder,
  /// "pieces/1.tum" (numbered_tum_files). Files of other names, there too, are left alone.
  /// `inputs`: what the run reads. Makes the directory where it is absent. Throws FileError where
  /// it cannot be made or written to, another run is about to write there, a directory has one of
  /// the names, or an input does.
  OutputSet(const std::string& path, std::vector<std::string> names, const InputPaths& inputs = {});
  /// Removes what was not committed, and the directories made for it.
  ~OutputSet();
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;

  /// Keeps a file aside; its name is one of the names, or one in a folder of them. Throws
  /// FileError.
  void add(const std::string& name, std::string_view bytes);

  /// The files added replace all of the last set. Throws FileError.
  void commit();

  /// Names of the files added, in their order.
  [[nodiscard]] const std::vector<std::string>& added() const { return added_; }

 private:
  [[nodiscard]] bool is_named(const std::string& name) const;
  void make_directory();
  void lock();
  void refuse(const InputPaths& inputs) const;
  void begin();
  void finish_commit();
  /// Throws FileError where a folder holds files that do not belong to a set of this kind.
  void require_ours(const std::filesystem::path& set) const;
  void discard() noexcept;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::string> added_;
  std::vector<std::filesystem::path> made_;  ///< Directories that were absent, the innermost first.
  int lock_ = -1;                            ///< A descriptor of the directory, locked.
  bool is_begun_ = false;                    ///< Files are kept aside.
  EndingSignals signals_;                    ///< The last member: its thread uses the others.
};

}  // namespace setsquare::app
