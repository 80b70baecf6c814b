// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// Which beams have information on the space that they crossed.
struct BeamEndParams {
  double max_return_range_m = 30.0;    ///< Farther returns count as no-returns.
  double max_no_return_range_m = 4.0;  ///< A no-return proves free space only this far, and ...
  /// ... only where this many neighbouring beams returned nothing: a single one is a drop-out,
  /// which may have met a wall.
  int min_neighbouring_no_returns = 3;
  /// Neighbouring returns nearer to each other are taken for one surface.
  double max_joint_m = 0.5;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Where a beam ends, in the sensor frame.
struct BeamEnd {
  double x_m = 0.0;
  double y_m = 0.0;
  bool is_return = false;  ///< Otherwise only free space is known up to there.
  bool is_joined = false;  ///< A return on the same surface as the return before.
};

/// Finds the ends of a scan's beams; the directions of the last scan's geometry are kept, since
/// most logs have only one.
class BeamEndFinder {
 public:
  /// Throws ParameterError.
  explicit BeamEndFinder(const BeamEndParams& params = {});

  /// The ends of all beams that have information, in their order. Valid until the next call.
  [[nodiscard]] const std::vector<BeamEnd>& find(const Scan& scan);

 private:
  /// What a beam is taken for.
  enum class Word : std::uint8_t { kNothing, kReturn, kNoReturn };

  void set_directions(const Scan& scan);
  void set_words(const Scan& scan);
  void drop_lone_no_returns();

  BeamEndParams params_;
  double first_bearing_rad_ = 0.0;
  double bearing_step_rad_ = 0.0;
  std::vector<Eigen::Vector2d> directions_;
  std::vector<Word> words_;
  std::vector<BeamEnd> ends_;
};

/// The ends of one scan's beams.
[[nodiscard]] std::vector<BeamEnd> beam_ends(const Scan& scan, const BeamEndParams& params = {});

}  // namespace setsquare
