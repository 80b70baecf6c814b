// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/chain_errors.hpp"
#include "experiments/full_mapper.hpp"
#include "experiments/scan_chain.hpp"
#include "experiments/tally.hpp"
#include "setsquare/core/parallel.hpp"
#include "setsquare/sim/building/building.hpp"

namespace setsquare::experiments {

/// bando2014, section 5.2: the large building, scan to scan; and by the full mapper.
struct CircuitStudyParams {
  std::size_t num_seeds = 20;  ///< Seeds 1 ... num_seeds; the first one's map is drawn.
  std::size_t max_num_scans = 2800;
  double spacing_m = 0.4;
  double spacing_rad = rad_from_deg(10.0);
};

/// A circuit of the track between the scans nearest to its start and its end.
struct CircuitScans {
  std::string order;
  std::size_t start = 0;
  std::size_t end = 0;
  double length_m = 0.0;  ///< Travelled in between.
};

/// One matcher's way through the building, in the frame of the truth.
struct ChainOutcome {
  ScanChain chain;
  std::array<Eigen::Vector2d, 2> closure_m;  ///< Error after each circuit, along the map's axes.
  HeadingErrors heading;
};

struct CircuitRun {
  std::uint64_t seed = 0;
  std::vector<Pose2> truth;  ///< T_map_base, one per scan.
  std::array<CircuitScans, 2> circuits;
  ChainOutcome paper;          ///< As `setsquare map --preset paper` takes a sequence of scans.
  ChainOutcome paper_literal;  ///< With all four offsets, as printed.
  ChainOutcome ours;
  ChainOutcome mapper;  ///< The full mapper, without odometry ...
  MapErrors mapper_errors;
  ChainOutcome wheeled;  ///< ... and with wheels that drift.
  MapErrors wheeled_errors;
};

struct CircuitStudy {
  std::vector<CircuitRun> runs;
  FloorPlan plan;           ///< Of the first run.
  std::string paper_map;    ///< PNG of the first run's map by the paper's method ...
  std::string default_map;  ///< ... and by the default matcher,
  std::string mapper_map;   ///< and by the full mapper, without odometry.
};

[[nodiscard]] CircuitStudy study_circuits(const CircuitStudyParams& params,
                                          std::size_t num_threads,
                                          const Progress& progress = {});

/// Medians over the seeds, one per circuit.
struct ClosureMedians {
  std::array<double, 2> x_m{};     ///< Of the absolute errors along the map's x ...
  std::array<double, 2> y_m{};     ///< ... its y ...
  std::array<double, 2> norm_m{};  ///< ... and of their norms.
};
[[nodiscard]] ClosureMedians closure_medians(const CircuitStudy& study,
                                             ChainOutcome CircuitRun::*outcome);

/// The full mapper's maps over the seeds, the first pose laid onto the truth.
struct MapMedians {
  double final_m = 0.0;  ///< Error of the last pose: median,
  double worst_final_m = 0.0;
  double mean_m = 0.0;  ///< mean error of all poses: median,
  double worst_mean_m = 0.0;
};
[[nodiscard]] MapMedians map_medians(const CircuitStudy& study, MapErrors CircuitRun::*errors);

/// Heading error at the end of the track that a run may have, in deg.
inline constexpr double kMaxEndHeading_deg = 0.5;

/// A method's headings over the seeds.
struct HeadingJudgement {
  double median_end_deg = 0.0;              ///< Of the absolute errors of the last scan.
  double worst_end_deg = 0.0;               ///< Of the same.
  double median_slope_deg_per_100_m = 0.0;  ///< Of the absolute slopes, nothing taken modulo.
  std::size_t num_wrong_turns = 0;          ///< Over all seeds.
  std::vector<const CircuitRun*> failing;   ///< Beyond kMaxEndHeading_deg at the end.
};
[[nodiscard]] HeadingJudgement judge_headings(const CircuitStudy& study,
                                              ChainOutcome CircuitRun::*outcome);

/// Medians of the seeds and every run.
[[nodiscard]] Json json_from(const CircuitStudy& study);

}  // namespace setsquare::experiments
