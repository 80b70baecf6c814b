// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/changed_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "setsquare/core/error.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "tests/support/rectangular_room.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::changed_cells_test {

constexpr std::int32_t kColumns = 23;
constexpr std::int32_t kRows = 17;
constexpr double kResolution_m = 0.05;

struct Counts {
  std::vector<float> num_passes = std::vector<float>(kColumns * kRows, 0.0F);
  std::vector<std::uint16_t> num_hits = std::vector<std::uint16_t>(kColumns * kRows, 0);
  [[nodiscard]] CellCounts all() { return {num_passes, num_hits}; }
};

std::size_t index(std::int32_t column, std::int32_t row) {
  return static_cast<std::size_t>(row * kColumns + column);
}

/// Of each cell: nothing, surely free, surely occupied, or a little of both.
Counts random_counts(std::mt19937_64& generator) {
  Counts counts;
  for (std::size_t i = 0; i < counts.num_hits.size(); ++i) {
    switch (generator() % 8) {
      case 0:
        counts.num_hits[i] = 5;
        break;
      case 1:
        counts.num_passes[i] = 7.0F;
        counts.num_hits[i] = 1;
        break;
      case 2:
        break;
      default:
        counts.num_passes[i] = 60.0F;
    }
  }
  return counts;
}

/// The plain twin: each cell looks around for itself, until nothing changes.
class Twin {
 public:
  void add_older(Counts& newer, const Counts& older) {
    const auto state = [](const Counts& counts, std::size_t i) {
      const ScanInsertionParams p;
      const double sum = p.hit_log_odds * counts.num_hits[i] +
                         p.pass_log_odds / p.no_returns_per_pass * counts.num_passes[i];
      return sum >= 1.4 ? 1 : sum <= -1.4 ? -1 : 0;
    };
    const auto contradicts = [&](std::size_t i) { return state(newer, i) * state(older, i) == -1; };
    const auto any_about = [&](std::int32_t column, std::int32_t row, int reach, auto is) {
      for (std::int32_t r = row - reach; r <= row + reach; ++r) {
        for (std::int32_t c = column - reach; c <= column + reach; ++c) {
          if (r < 0 || c < 0 || r >= kRows || c >= kColumns) continue;
          if (is(index(c, r))) return true;
        }
      }
      return false;
    };
    std::vector<bool> here(is_changed.size(), false);
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::int32_t row = 0; row < kRows; ++row) {
        for (std::int32_t column = 0; column < kColumns; ++column) {
          const std::size_t i = index(column, row);
          if (is_changed[i] || here[i] || !contradicts(i)) continue;
          const Counts& sees_free = state(newer, i) == -1 ? newer : older;
          const bool has_wall = any_about(
              column, row, 2, [&](std::size_t other) { return state(sees_free, other) == 1; });
          const bool is_beside =
              any_about(column, row, 1, [&](std::size_t other) { return here[other]; });
          if (has_wall && !is_beside) continue;
          here[i] = has_grown = true;
        }
      }
    }
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (here[i]) is_changed[i] = true;
      if (is_changed[i]) continue;
      newer.num_passes[i] += older.num_passes[i];
      newer.num_hits[i] = static_cast<std::uint16_t>(newer.num_hits[i] + older.num_hits[i]);
    }
  }
  std::vector<bool> is_changed = std::vector<bool>(kColumns * kRows, false);
};

ChangedCells changed_cells() { return {kColumns, kRows, kResolution_m, {}, {}}; }

TEST(ChangedCells, AreThoseOfThePlainTwin) {
  std::mt19937_64 generator = testing::make_generator();
  for (int round = 0; round < 50; ++round) {
    Counts fast = random_counts(generator);
    Counts slow = fast;
    ChangedCells changed = changed_cells();
    Twin twin;
    std::size_t num_changed = 0;
    for (int session = 0; session < 3; ++session) {
      Counts older = random_counts(generator);
      twin.add_older(slow, older);
      changed.add_older(fast.all(), older.all());
      ASSERT_EQ(fast.num_hits, slow.num_hits);
      ASSERT_EQ(fast.num_passes, slow.num_passes);
    }
    for (const bool is_changed : twin.is_changed) num_changed += is_changed ? 1 : 0;
    std::size_t num_told = 0;
    for (const ChangedPlace& place : changed.places(fast.all(), {})) num_told += place.num_cells;
    EXPECT_LE(num_told, num_changed);
  }
}

/// A wall along x in row 8; the rest of its rows is free.
Counts wall_in(std::int32_t wall_row, std::int32_t first_column, std::int32_t end_column) {
  Counts counts;
  for (std::int32_t row = 0; row < kRows; ++row) {
    for (std::int32_t column = 0; column < kColumns; ++column) {
      const bool is_wall = row == wall_row && column >= first_column && column < end_column;
      counts.num_hits[index(column, row)] = is_wall ? 9 : 0;
      counts.num_passes[index(column, row)] = is_wall ? 0.0F : 80.0F;
    }
  }
  return counts;
}

TEST(ChangedCells, AWallThatIsSeenALittleOffIsTheSameWall) {
  for (const std::int32_t off : {-2, -1, 0, 1, 2}) {
    Counts newer = wall_in(8, 3, 20);
    Counts older = wall_in(8 + off, 3, 20);
    ChangedCells changed = changed_cells();
    changed.add_older(newer.all(), older.all());
    EXPECT_TRUE(changed.places(newer.all(), {}).empty()) << off;
    EXPECT_EQ(newer.num_hits[index(10, 8)], off == 0 ? 18 : 9);
    EXPECT_EQ(newer.num_hits[index(10, 8 + off)], off == 0 ? 18 : 9);
  }
}

TEST(ChangedCells, AWallFartherOffIsGoneThereAndNewHere) {
  Counts newer = wall_in(12, 3, 20);
  Counts older = wall_in(4, 5, 15);
  ChangedCells changed = changed_cells();
  changed.add_older(newer.all(), older.all());
  const auto places = changed.places(newer.all(), {10.0, 20.0, 0.0});
  ASSERT_EQ(places.size(), 2U);
  EXPECT_FALSE(places[0].is_gone);
  EXPECT_EQ(places[0].num_cells, 17U);
  EXPECT_NEAR(places[0].place_m.x(), 10.0 + 0.05 * 11.5, 1e-9);
  EXPECT_NEAR(places[0].place_m.y(), 20.0 + 0.05 * 12.5, 1e-9);
  EXPECT_TRUE(places[1].is_gone);
  EXPECT_EQ(places[1].num_cells, 10U);
  EXPECT_EQ(newer.num_hits[index(10, 4)], 0);
  EXPECT_EQ(newer.num_passes[index(10, 12)], 0.0F);
}

TEST(ChangedCells, ADoorOpensUpToItsFrame) {
  // A wall with a door from column 8 to 15, which was closed.
  Counts newer = wall_in(8, 0, kColumns);
  for (std::int32_t column = 8; column < 15; ++column) {
    newer.num_hits[index(column, 8)] = 0;
    newer.num_passes[index(column, 8)] = 80.0F;
  }
  Counts older = wall_in(8, 0, kColumns);
  ChangedCells changed = changed_cells();
  changed.add_older(newer.all(), older.all());
  for (std::int32_t column = 0; column < kColumns; ++column) {
    EXPECT_EQ(newer.num_hits[index(column, 8)], column >= 8 && column < 15 ? 0 : 18) << column;
  }
  const auto places = changed.places(newer.all(), {});
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].num_cells, 7U);
}

TEST(ChangedCells, AGlimpseDoesNotCount) {
  // One hit, or three beams, do not outweigh what was surely seen.
  Counts newer;
  Counts older = wall_in(8, 3, 20);
  for (std::size_t i = 0; i < newer.num_hits.size(); ++i) newer.num_passes[i] = 12.0F;
  ChangedCells changed = changed_cells();
  changed.add_older(newer.all(), older.all());
  EXPECT_TRUE(changed.places(newer.all(), {}).empty());
  EXPECT_EQ(newer.num_hits[index(10, 8)], 9);
}

TEST(ChangedCells, RefusesParametersThatAreNone) {
  EXPECT_THROW((ChangedCells{1, 1, 0.05, {}, {.sure_log_odds = 0.0}}), ParameterError);
  EXPECT_THROW((ChangedCells{1, 1, 0.05, {}, {.same_wall_m = -1.0}}), ParameterError);
}

/// Scans on a way through a room of the given depth.
struct Visit {
  Visit(double depth_m, std::size_t recency) {
    for (int i = 0; i < 20; ++i) {
      const Pose2 pose{1.0 + 0.35 * i, 2.0, 0.2 * i};
      scans.push_back(testing::scan_of_room(pose, 9.97, depth_m, 360));
      poses.push_back(pose);
    }
    for (std::size_t i = 0; i < scans.size(); ++i) {
      placed.push_back({&scans[i], poses[i], recency});
    }
  }
  std::vector<Scan> scans;
  std::vector<Pose2> poses;
  std::vector<PlacedScan> placed;
};

std::vector<PlacedScan> together(const Visit& a, const Visit& b) {
  std::vector<PlacedScan> all = a.placed;
  all.insert(all.end(), b.placed.begin(), b.placed.end());
  return all;
}

TEST(GridOfSessions, IsThatOfOneWhereNothingChanged) {
  const Visit once(6.97, 0);
  const Visit again(6.97, 1);
  const Visit same(6.97, 0);
  const GridWithChanges sessions = grid_with_changes(together(once, again));
  EXPECT_TRUE(sessions.changes.empty());
  EXPECT_EQ(sessions.grid.values(), grid_from_scans(together(once, same)).values());
  // Which recency the only session has does not matter.
  EXPECT_EQ(grid_from_scans(Visit(6.97, 7).placed).values(), grid_from_scans(once.placed).values());
}

TEST(GridOfSessions, AnyNumberOfThreadsGivesTheSame) {
  const Visit before(6.97, 0);
  const Visit after(5.5, 1);
  const std::vector<PlacedScan> all = together(before, after);
  const GridWithChanges one = grid_with_changes(all);
  const GridWithChanges four = grid_with_changes(all, 0.0, {.num_threads = 4});
  EXPECT_EQ(one.grid.values(), four.grid.values());
  EXPECT_EQ(one.changes.size(), four.changes.size());
}

TEST(GridOfSessions, TheOrderOfTheScansDoesNotMatterButTheirRecency) {
  const Visit before(6.97, 0);
  const Visit after(5.5, 1);
  const GridWithChanges there = grid_with_changes(together(before, after));
  const GridWithChanges back = grid_with_changes(together(after, before));
  EXPECT_EQ(there.grid.values(), back.grid.values());
  ASSERT_FALSE(there.changes.empty());
  EXPECT_FALSE(there.changes.front().is_gone) << "the room is less deep";
  // The other way round the wall is gone.
  Visit newer_deep(6.97, 2);
  const GridWithChanges deep = grid_with_changes(together(newer_deep, after));
  ASSERT_FALSE(deep.changes.empty());
  EXPECT_TRUE(deep.changes.front().is_gone);
}

}  // namespace setsquare::changed_cells_test
