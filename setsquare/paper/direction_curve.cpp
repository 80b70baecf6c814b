// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/direction_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/wider_clones.hpp"

namespace setsquare {
namespace {

struct SinCos {
  double s = 0.0;
  double c = 0.0;
};

/// Sine and cosine of every direction: one exact pair every 32, the rest by the addition theorem
/// (right to a few units in the last place).
std::vector<SinCos> unit_directions(const DirectionGrid& grid) {
  constexpr std::size_t kBlock = 32;
  std::array<SinCos, kBlock> small;
  for (std::size_t b = 0; b < kBlock; ++b) {
    const double angle_rad = static_cast<double>(b) * grid.step_rad;
    small[b] = {std::sin(angle_rad), std::cos(angle_rad)};
  }
  std::vector<SinCos> directions(grid.num_directions);
  for (std::size_t first = 0; first < grid.num_directions; first += kBlock) {
    const double angle_rad = grid.direction_rad(first);
    const SinCos base{std::sin(angle_rad), std::cos(angle_rad)};
    const std::size_t end = std::min(first + kBlock, grid.num_directions);
    for (std::size_t j = first; j < end; ++j) {
      const SinCos& add = small[j - first];
      directions[j] = {base.s * add.c + base.c * add.s, base.c * add.c - base.s * add.s};
    }
  }
  return directions;
}

/// Where the points' coordinates along a direction fall, counted from the upper end of the range.
struct SlotScale {
  double max_distance_m = 0.0;
  double inverse_width = 0.0;
  double last = 0.0;  ///< Slots 1 and last + 2 take what lies outside the range.
};

// Plain arrays and loops, compiled for wider instructions too: half of the curve's time (timed by
// benchmarks/stages/paper_benchmark).
SETSQUARE_WIDER_CLONES void find_slots(const double* x_m,
                                       const double* y_m,
                                       std::size_t num_points,
                                       const SinCos& direction,
                                       const SlotScale& scale,
                                       std::int32_t* slot) {
  const SinCos d = direction;
  const SlotScale to = scale;
  for (std::size_t i = 0; i < num_points; ++i) {
    const double rho_m = x_m[i] * d.s + y_m[i] * d.c;  // Eq. (4)
    const double from_end = (to.max_distance_m - rho_m) * to.inverse_width;
    slot[i] = static_cast<std::int32_t>(std::min(std::max(from_end, -1.0), to.last) + 2.0);
  }
}

SETSQUARE_WIDER_CLONES std::int32_t sum_squared_differences(const std::int16_t* count,
                                                            std::size_t num_differences) {
  std::int32_t sum = 0;
  for (std::size_t k = 0; k < num_differences; ++k) {
    const std::int32_t difference = static_cast<std::int16_t>(count[k + 1] - count[k]);
    sum += difference * difference;
  }
  return sum;
}

std::int64_t sum_squared_differences(const std::int32_t* count, std::size_t num_differences) {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < num_differences; ++k) {
    const std::int64_t difference = count[k + 1] - count[k];
    sum += difference * difference;
  }
  return sum;
}

/// One profile after another of the same points, in plain arrays that stay in the cache (timed by
/// benchmarks/stages/paper_benchmark). `Count` holds a bin's count, `Sum` a sum of squares.
template <class Count, class Sum>
class ProfileSweep {
 public:
  ProfileSweep(const PointSet& points, const ProfileBins& bins)
      : points_(points),
        num_bins_(bins.num_bins()),
        scale_{bins.max_distance_m, 1.0 / bins.bin_width_m, static_cast<double>(num_bins_)},
        slot_(points.size()),
        counts_(num_bins_ + 4) {}

  /// Counts the points along `direction`, from the upper end of the range: the mirrored profile,
  /// whose moment is the same.
  void fill(const SinCos& direction) {
    find_slots(
        points_.x_m.data(), points_.y_m.data(), slot_.size(), direction, scale_, slot_.data());
    std::fill(counts_.begin(), counts_.end(), Count{0});
    Count* const counts = counts_.data();
    for (const std::int32_t slot : slot_) ++counts[slot];
    counts_[1] = 0;
    counts_[num_bins_ + 2] = 0;
  }

  double squared_differences() const {
    return static_cast<double>(sum_squared_differences(counts_.data() + 1, num_bins_ + 1));
  }

  double squared_second_differences() const {
    const Count* const count = counts_.data();
    Sum sum = 0;
    for (std::size_t k = 0; k <= num_bins_ + 1; ++k) {
      const Sum difference =
          static_cast<Sum>(static_cast<Count>(count[k] - 2 * count[k + 1] + count[k + 2]));
      sum += difference * difference;
    }
    return static_cast<double>(sum);
  }

 private:
  const PointSet& points_;
  std::size_t num_bins_;
  SlotScale scale_;
  std::vector<std::int32_t> slot_;
  std::vector<Count> counts_;
};

/// Most points of which every second difference of counts fits 16 bits.
constexpr std::size_t kMaxShortPoints = 8191;

template <class Visit>
void sweep(const PointSet& points,
           const DirectionGrid& grid,
           const ProfileBins& bins,
           const Visit& visit) {
  const std::vector<SinCos> directions = unit_directions(grid);
  const auto run = [&](auto profile) {
    for (std::size_t j = 0; j < directions.size(); ++j) {
      profile.fill(directions[j]);
      visit(j, profile);
    }
  };
  if (points.size() <= kMaxShortPoints) {
    run(ProfileSweep<std::int16_t, std::int32_t>(points, bins));
  } else {
    run(ProfileSweep<std::int32_t, std::int64_t>(points, bins));
  }
}

}  // namespace

std::vector<double> direction_curve(const PointSet& points,
                                    const DirectionGrid& grid,
                                    const ProfileBins& bins) {
  std::vector<double> curve(grid.num_directions);
  sweep(points, grid, bins, [&](std::size_t j, const auto& profile) {
    curve[j] = profile.squared_differences();
  });
  return curve;
}

DirectionCurves direction_curves(const PointSet& points,
                                 const DirectionGrid& grid,
                                 const ProfileBins& bins) {
  // With s = 4 sin^2(omega / 2), omega^2 / s is convex in s, 1 at s = 0 and pi^2 / 4 at s = 4:
  // omega^2 lies above s and below s + (pi^2 - 4) / 16 s^2.
  constexpr double kSecond = (kPi * kPi - 4.0) / 16.0;
  DirectionCurves curves{std::vector<double>(grid.num_directions),
                         std::vector<double>(grid.num_directions)};
  sweep(points, grid, bins, [&](std::size_t j, const auto& profile) {
    curves.neighbour_differences[j] = profile.squared_differences();
    curves.squared_frequency_bound[j] =
        curves.neighbour_differences[j] + kSecond * profile.squared_second_differences();
  });
  return curves;
}

}  // namespace setsquare
