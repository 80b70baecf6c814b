// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from main, its only caller: where scans with a known place in a map come from.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"

namespace setsquare::experiments {

/// A scan, the map in which it is sought, and where it was taken; nothing where that is elsewhere.
struct KnownPlace {
  const KnownMap& map;
  const Scan& scan;
  std::optional<Pose2> T_map_sensor;
  double overlap = 1.0;  ///< overlap_with_map() there.
};
using VisitPlace = std::function<void(const KnownPlace&)>;

/// A scanner that stands still, with noise of one deviation at any range.
[[nodiscard]] ScannerModel still_scanner(double field_of_view_rad,
                                         std::size_t num_beams,
                                         double noise_m,
                                         double max_range_m);

/// Scans at random free places of a map image (map_server's), the walls being its cells.
void visit_map_image(const std::string& yaml_path,
                     const ScannerModel& scanner,
                     std::size_t num_scans,
                     std::uint64_t seed,
                     const VisitPlace& visit);

/// Scans at random places of a simulated building that was mapped from its route at known poses,
/// with other people in it; `stranger`: in the map of another building.
void visit_building(BuildingClass building_class,
                    std::uint64_t seed,
                    const ScannerModel& scanner,
                    std::size_t num_scans,
                    bool is_partly_mapped,
                    const VisitPlace& visit);

/// A log, the map of one of its halves, and where the map of the whole has its scans in that map's
/// frame.
struct MappedHalf {
  std::vector<Scan> scans;
  std::shared_ptr<const KnownMap> map;
  std::vector<std::optional<Pose2>> T_map_sensor;
};
[[nodiscard]] MappedHalf mapped_half(const std::string& log_path, bool maps_second = false);

/// What a scan must overlap with a map to be found in it.
inline constexpr double kMinOverlap = 0.45;

/// Share of a scan's returns that lie within 12 cm of a wall of the map.
[[nodiscard]] double overlap_with_map(const KnownMap& map,
                                      const Scan& scan,
                                      const Pose2& T_map_sensor);

/// Scans of one half of a log in the map of the other, apart by some way; places by the map of the
/// whole.
void visit_other_half(const std::string& log_path,
                      double every_m,
                      bool maps_second,
                      const VisitPlace& visit);

}  // namespace setsquare::experiments
