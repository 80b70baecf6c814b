// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/survey/repeated_ranges.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace setsquare {
namespace {

constexpr std::uint64_t kScansPerLook = 4;
constexpr unsigned kSlotBits = 12;
constexpr double kBin_m = 0.05;
constexpr std::size_t kNumBins = 2000;
constexpr std::size_t kBinsAround = 5;

std::size_t slot_of(double range_m) {
  // Fibonacci hashing: the high bits of the product depend on all bits of the value.
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;
  return (std::bit_cast<std::uint64_t>(range_m) * kGolden) >> (64 - kSlotBits);
}

std::size_t bin_of(double range_m) {
  return std::min(kNumBins - 1, static_cast<std::size_t>(range_m / kBin_m));
}

}  // namespace

RepeatedRanges::RepeatedRanges() : slots_(std::size_t{1} << kSlotBits), num_per_bin_(kNumBins) {}

void RepeatedRanges::add(const Scan& scan) {
  if (num_scans_++ % kScansPerLook != 0) return;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const double range_m = scan.ranges_m[beam];
    if (scan.outcome(beam) != BeamOutcome::kReturn || range_m > kBin_m * kNumBins) continue;
    vote(range_m);
  }
}

void RepeatedRanges::vote(double range_m) {
  ++num_returns_;
  ++num_per_bin_[bin_of(range_m)];
  Slot& slot = slots_[slot_of(range_m)];
  if (slot.range_m == range_m) {
    ++slot.votes;
  } else if (slot.votes == 0) {
    slot = {range_m, 1};
  } else {
    --slot.votes;
  }
}

std::uint64_t RepeatedRanges::num_around(double range_m) const {
  const std::size_t bin = bin_of(range_m);
  const std::size_t first = bin > kBinsAround ? bin - kBinsAround : 0;
  const std::size_t end = std::min(kNumBins, bin + kBinsAround + 1);
  return std::accumulate(num_per_bin_.begin() + static_cast<std::ptrdiff_t>(first),
                         num_per_bin_.begin() + static_cast<std::ptrdiff_t>(end),
                         std::uint64_t{0});
}

std::optional<RepeatedRange> RepeatedRanges::most_striking() const {
  constexpr double kLeastShare = 0.005;
  constexpr std::uint64_t kLeastVotes = 50;
  const Slot best = *std::ranges::max_element(slots_, {}, &Slot::votes);
  const auto num_returns = static_cast<double>(num_returns_);
  const double share = static_cast<double>(best.votes) / std::max(1.0, num_returns);
  const bool is_frequent = best.votes >= kLeastVotes && share >= kLeastShare;
  if (!is_frequent || num_around(best.range_m) > 2 * best.votes) return std::nullopt;
  const auto beyond = num_per_bin_.begin() + static_cast<std::ptrdiff_t>(bin_of(best.range_m)) + 1;
  const auto num_beyond = std::accumulate(beyond, num_per_bin_.end(), std::uint64_t{0});
  return RepeatedRange{best.range_m, share, static_cast<double>(num_beyond) / num_returns};
}

}  // namespace setsquare
