// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from main, its only caller: where pairs with a known truth come from.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "experiments/small_worlds.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare::experiments {

/// Two scans, and where the second was taken in the frame of the first; nothing where they come
/// from different places.
struct KnownPair {
  const PreparedScan& reference;
  const PreparedScan& current;
  std::optional<Pose2> T_reference_current;
  double overlap = 0.0;
  bool is_determined = false;  ///< By the floor plan.
};
using VisitPair = std::function<void(const KnownPair&)>;

struct Seeds {
  std::uint64_t first = 1;
  std::uint64_t count = 1;
};

/// Pairs within 5 m of each other in buildings of every class, as `experiment paper` takes them.
void visit_buildings(const ScannerModel& scanner, Seeds seeds, const VisitPair& visit);

/// Pairs of scans of two different buildings.
void visit_strangers(const ScannerModel& scanner, Seeds seeds, const VisitPair& visit);

/// All pairs of a short way through a small world.
void visit_world(SmallWorld world, Seeds seeds, const VisitPair& visit);

/// Furnished rooms of 6 to 9 m by 5 to 8 m, scanned over 180 deg; any overlap.
void visit_rooms(std::uint64_t seed, std::size_t num_pairs, const VisitPair& visit);

/// The ends of corridors, 180 deg: each pair once of two different corridors and once of one.
void visit_corridor_ends(std::uint64_t seed, std::size_t num_pairs, const VisitPair& visit);

/// Pairs of scans of two different buildings, each class with each: some 800 of a seed.
void visit_many_strangers(const ScannerModel& scanner, Seeds seeds, const VisitPair& visit);

/// The loops of intel, aces and fr079 (below the folder of the public logs), and random scans of
/// one of them with random scans of another.
void visit_real_loops(const std::string& data_folder, const VisitPair& visit);
void visit_real_strangers(const std::string& data_folder,
                          std::size_t num_pairs,
                          const VisitPair& visit);

/// A scanner of 180 deg and a beam per degree, with this noise.
[[nodiscard]] ScannerModel half_turn_scanner(double noise_m);

}  // namespace setsquare::experiments
