// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/poses_tsv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kHeader =
    "stamp\tx_m\ty_m\theading_deg\tsigma_x_m\tsigma_y_m\tcorrelation_xy\tsigma_heading_deg\t"
    "status\tpiece\tplaced\tdoubts\n";

/// For each scan its piece, from 1.
std::vector<std::size_t> pieces_of_scans(const Map& map) {
  std::vector<std::size_t> pieces(map.scans.size(), 1);
  for (std::size_t k = 0; k < map.pieces.size(); ++k) {
    const TrackPiece& piece = map.pieces[k];
    const std::size_t end = std::min(pieces.size(), piece.first_scan + piece.num_scans);
    for (std::size_t i = piece.first_scan; i < end; ++i) pieces[i] = k + 1;
  }
  return pieces;
}

/// For each scan whether it lies in a stretch whose length is open.
std::vector<bool> has_open_length(const Map& map) {
  std::vector<bool> is_open(map.scans.size(), false);
  for (const OpenStretch& stretch : map.open_stretches) {
    if (stretch.is_turn) continue;
    const std::size_t end = std::min(is_open.size(), stretch.first_scan + stretch.num_scans);
    for (std::size_t i = stretch.first_scan; i < end; ++i) is_open[i] = true;
  }
  return is_open;
}

std::string doubts_of(const MappedScan& scan, bool has_open_length) {
  std::string doubts;
  const auto add = [&](bool is_there, std::string_view name) {
    if (!is_there) return;
    if (!doubts.empty()) doubts += ',';
    doubts += name;
  };
  add(!scan.is_placed, "not_joined");
  add(scan.status == TrackStatus::kLost, "lost");
  add(has_open_length, "length_open");
  add(scan.is_placed && scan.heading_sigma_rad > kOpenHeading_rad, "heading_open");
  return doubts.empty() ? "-" : doubts;
}

/// Positive: infinity and NaN as Python and C read them.
std::string decimal(double value, int digits) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return "inf";
  return fmt::format("{:.{}f}", value, digits);
}

}  // namespace

std::string poses_tsv(const Map& map, PoseOf pose_of) {
  const std::vector<std::size_t> pieces = pieces_of_scans(map);
  const std::vector<bool> is_length_open = has_open_length(map);
  std::string text(kHeader);
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const MappedScan& scan = map.scans[i];
    const Pose2& pose = pose_of == PoseOf::kSensor ? scan.T_map_sensor : scan.T_map_base;
    const Eigen::Matrix2d& covariance_m2 = scan.position_covariance_m2;
    const double sigma_x_m = std::sqrt(covariance_m2(0, 0));
    const double sigma_y_m = std::sqrt(covariance_m2(1, 1));
    const double product_m2 = sigma_x_m * sigma_y_m;
    const bool is_known = std::isfinite(product_m2) && product_m2 > 0.0;
    const double correlation =
        is_known ? std::clamp(covariance_m2(0, 1) / product_m2, -1.0, 1.0) : 0.0;
    fmt::format_to(std::back_inserter(text),
                   "{}\t{:.6f}\t{:.6f}\t{:.5f}\t{}\t{}\t{:.4f}\t{}\t{}\t{}\t{}\t{}\n",
                   to_string(scan.stamp),
                   pose.x_m,
                   pose.y_m,
                   deg_from_rad(wrap_to_pi(pose.theta_rad)),
                   decimal(sigma_x_m, 4),
                   decimal(sigma_y_m, 4),
                   correlation,
                   decimal(deg_from_rad(scan.heading_sigma_rad), 3),
                   to_string(scan.status),
                   pieces[i],
                   scan.is_placed ? 1 : 0,
                   doubts_of(scan, is_length_open[i]));
  }
  return text;
}

}  // namespace setsquare
