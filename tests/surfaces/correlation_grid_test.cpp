// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/correlation_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::correlation_grid_test {

using testing::uniform;

constexpr int kHalfWindow = CorrelationGrid::kHalfWindowCells;
constexpr int kHalfExtent = CorrelationGrid::kHalfExtentCells;
constexpr double kCell_m = CorrelationGrid::kCell_m;

enum class Cell { kFree = -1, kUnknown = 0, kNearSurface = 1, kSurface = 2 };

/// The reference scan as a map from cells to what is there, drawn slowly.
class PlainGrid {
 public:
  explicit PlainGrid(const PreparedScan& reference) {
    draw_free_space(reference.image());
    const SurfacePoints& points = reference.points();
    std::vector<std::pair<int, int>> surface;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool is_joined = points.joined[i] != 0;
      const float dx_m = is_joined ? points.x_m[i + 1] - points.x_m[i] : 0.0F;
      const float dy_m = is_joined ? points.y_m[i + 1] - points.y_m[i] : 0.0F;
      const auto num_between =
          static_cast<int>(std::max(std::abs(dx_m), std::abs(dy_m)) * kCellsPerMetre);
      for (int k = 0; k <= num_between; ++k) {
        const float share = static_cast<float>(k) / static_cast<float>(num_between + 1);
        const std::pair cell{cell_of(points.x_m[i] + share * dx_m),
                             cell_of(points.y_m[i] + share * dy_m)};
        if (std::max(std::abs(cell.first), std::abs(cell.second)) < kHalfExtent) {
          surface.push_back(cell);
        }
      }
    }
    for (const auto& [x, y] : surface) {
      for (const auto& near : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
        cells_[near] = Cell::kNearSurface;
      }
    }
    for (const auto& cell : surface) cells_[cell] = Cell::kSurface;
  }

  /// The sum under every sample, moved by a rotation and then by whole cells.
  [[nodiscard]] int correlation(const SurfaceSamples& samples,
                                const Pose2& middle,
                                int shift_x,
                                int shift_y) const {
    const auto c = static_cast<float>(std::cos(middle.theta_rad));
    const auto s = static_cast<float>(std::sin(middle.theta_rad));
    const auto x_m = static_cast<float>(middle.x_m);
    const auto y_m = static_cast<float>(middle.y_m);
    int sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto cell =
          cells_.find({cell_of(c * samples.x_m[i] - s * samples.y_m[i] + x_m) + shift_x,
                       cell_of(s * samples.x_m[i] + c * samples.y_m[i] + y_m) + shift_y});
      if (cell != cells_.end()) sum += static_cast<int>(cell->second);
    }
    return sum;
  }

 private:
  static constexpr auto kCellsPerMetre = static_cast<float>(1.0 / kCell_m);
  static int cell_of(float coordinate_m) {
    return static_cast<int>(std::floor(coordinate_m * kCellsPerMetre));
  }

  /// The cells on the middle lines of 512 sectors, a cell's width apart.
  void draw_free_space(const SurfaceImage& image) {
    const auto num_sectors = image.num_sectors();
    const std::size_t stride = num_sectors / 512;
    for (std::size_t k = stride / 2; k < num_sectors; k += stride) {
      const double angle = (static_cast<double>(k) + 0.5) * 4.0 / static_cast<double>(num_sectors);
      // Along the diamond |x| + |y| = 1 from (0, -1) to the left.
      const Eigen::Vector2d corners[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
      const auto side = static_cast<std::size_t>(angle);
      const double share = angle - static_cast<double>(side);
      const Eigen::Vector2d unit =
          ((1.0 - share) * corners[side] + share * corners[side + 1]).normalized();
      const double free_cells =
          std::min(std::sqrt(image.sector(static_cast<std::int32_t>(k)).free_square_m2) / kCell_m,
                   static_cast<double>(kHalfExtent));
      for (int step = 0; step < free_cells; ++step) {
        cells_[{static_cast<int>(std::floor(step * unit.x())),
                static_cast<int>(std::floor(step * unit.y()))}] = Cell::kFree;
      }
    }
  }

  std::map<std::pair<int, int>, Cell> cells_;
};

struct Pair {
  PreparedScan reference;
  PreparedScan current;
};

Pair random_pair(std::mt19937_64& generator) {
  const auto room = testing::furnished_room(generator);
  const testing::Fan fan{361, rad_from_deg(-90), rad_from_deg(0.5)};
  const auto scan = [&] {
    return prepare(testing::scan_of_walls(
        room.walls, testing::free_pose(room, generator), fan, 0.01, generator(), 0.05));
  };
  return {scan(), scan()};
}

/// A window's middle and rotation.
Pose2 random_middle(std::mt19937_64& generator) {
  return {
      uniform(generator, -6.0, 6.0), uniform(generator, -6.0, 6.0), uniform(generator, -kPi, kPi)};
}

int shift_cells(double translation_m) {
  return static_cast<int>(std::lround(translation_m / kCell_m));
}

// Rays of single precision may cut a cell's corner otherwise than the plain ones: a sample or two.
constexpr int kRoundingSlack = 2;

TEST(CorrelationGrid, ProposesWhatThePlainSumsSay) {
  auto generator = testing::make_generator();
  std::size_t num_proposals = 0;
  std::size_t num_different = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Pair pair = random_pair(generator);
    const CorrelationGrid grid(pair.reference.points(), pair.reference.image());
    const PlainGrid plain(pair.reference);
    const Pose2 middle = random_middle(generator);
    std::vector<TranslationProposal> proposals;
    grid.propose_translations(pair.current.coarse, middle, 1, proposals);
    for (const TranslationProposal& proposal : proposals) {
      const Pose2& T = proposal.T_reference_current;
      EXPECT_EQ(T.theta_rad, middle.theta_rad);
      const int sum = plain.correlation(pair.current.coarse,
                                        middle,
                                        shift_cells(T.x_m - middle.x_m),
                                        shift_cells(T.y_m - middle.y_m));
      EXPECT_NEAR(proposal.correlation, sum, kRoundingSlack);
      num_different += proposal.correlation != sum;
      ++num_proposals;
    }
  }
  EXPECT_GT(num_proposals, 100U);
  EXPECT_LE(num_different, num_proposals / 20);
}

TEST(CorrelationGrid, MissesNoPeakOfTheWindow) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 6; ++trial) {
    const Pair pair = random_pair(generator);
    const CorrelationGrid grid(pair.reference.points(), pair.reference.image());
    const PlainGrid plain(pair.reference);
    const Pose2 middle = random_middle(generator);
    int highest = 0;
    for (int y = -kHalfWindow; y < kHalfWindow; ++y) {
      for (int x = -kHalfWindow; x < kHalfWindow; ++x) {
        highest = std::max(highest, plain.correlation(pair.current.coarse, middle, x, y));
      }
    }
    std::vector<TranslationProposal> proposals;
    grid.propose_translations(pair.current.coarse, middle, 1, proposals);
    int highest_proposed = 0;
    for (const auto& proposal : proposals) {
      highest_proposed = std::max(highest_proposed, proposal.correlation);
    }
    EXPECT_NEAR(highest_proposed, highest, kRoundingSlack);
  }
}

TEST(CorrelationGrid, AsksForNoLessThanTheMinimumAndKeepsWhatWasThere) {
  auto generator = testing::make_generator();
  const Pair pair = random_pair(generator);
  const CorrelationGrid grid(pair.reference.points(), pair.reference.image());
  std::vector<TranslationProposal> all;
  grid.propose_translations(pair.current.coarse, {0.0, 0.0, 0.3}, 1, all);
  ASSERT_FALSE(all.empty());
  const int minimum = all[all.size() / 2].correlation;
  std::vector<TranslationProposal> some(3);
  grid.propose_translations(pair.current.coarse, {0.0, 0.0, 0.3}, minimum, some);
  const auto num_reaching = std::count_if(
      all.begin(), all.end(), [&](const auto& one) { return one.correlation >= minimum; });
  EXPECT_EQ(some.size(), 3U + static_cast<std::size_t>(num_reaching));
  grid.propose_translations(pair.current.coarse, {0.0, 0.0, 0.3}, 1000, some);
  EXPECT_EQ(some.size(), 3U + static_cast<std::size_t>(num_reaching));
}

TEST(CorrelationGrid, ScanOnItselfPeaksAtTheTruth) {
  auto generator = testing::make_generator();
  const Pair pair = random_pair(generator);
  const CorrelationGrid grid(pair.reference.points(), pair.reference.image());
  std::vector<TranslationProposal> proposals;
  grid.propose_translations(pair.reference.coarse, Pose2{}, 1, proposals);
  const auto best =
      std::max_element(proposals.begin(), proposals.end(), [](const auto& a, const auto& b) {
        return a.correlation < b.correlation;
      });
  ASSERT_NE(best, proposals.end());
  EXPECT_NEAR(best->T_reference_current.x_m, 0.0, 1e-12);
  EXPECT_NEAR(best->T_reference_current.y_m, 0.0, 1e-12);
  EXPECT_EQ(best->correlation, 2 * static_cast<int>(pair.reference.coarse.size()));
}

TEST(CorrelationGrid, RefusesMoreSamplesThanItsBytesCanSum) {
  auto generator = testing::make_generator();
  const Pair pair = random_pair(generator);
  const CorrelationGrid grid(pair.reference.points(), pair.reference.image());
  ASSERT_GT(pair.current.fine.size(), CorrelationGrid::kMaxSamples);
  std::vector<TranslationProposal> proposals;
  EXPECT_THROW(grid.propose_translations(pair.current.fine, Pose2{}, 1, proposals),
               std::invalid_argument);
}

TEST(CorrelationGrid, KeepsWithinItsBordersHoweverFarTheReturns) {
  testing::Fan fan{360, -kPi, rad_from_deg(1)};
  for (const double side_m : {12.7, 12.9, 18.9, 19.3, 25.0, 58.0}) {
    const auto far = prepare(testing::scan_of_walls(
        testing::empty_rectangle(side_m, side_m), {0.5 * side_m, 0.5 * side_m, 0.0}, fan));
    const CorrelationGrid grid(far.points(), far.image());
    std::vector<TranslationProposal> proposals;
    for (int turn = 0; turn < 8; ++turn) {
      grid.propose_translations(far.coarse, {0.0, 0.0, 0.785 * turn}, 1, proposals);
    }
    for (const auto& proposal : proposals) {
      EXPECT_LE(std::abs(proposal.T_reference_current.x_m), kHalfWindow * kCell_m + 1e-9);
      EXPECT_LE(std::abs(proposal.T_reference_current.y_m), kHalfWindow * kCell_m + 1e-9);
    }
  }
}

}  // namespace setsquare::correlation_grid_test
