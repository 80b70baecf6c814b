// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/sim/svg/floor_plan_svg.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  try {
    // Coarse chords: an input of a few bytes may ask for many curves.
    const SvgPlan plan = floor_plan_from_svg(bytes, "fuzz", {1.0, 10.0});
    fuzz::require(!plan.plan.segments.empty());
    fuzz::require(plan.route_m.empty() || plan.route_m.size() >= 2);
    for (const PlanSegment& segment : plan.plan.segments) {
      fuzz::require(segment.start_m.allFinite() && segment.end_m.allFinite());
      fuzz::require(segment.start_m != segment.end_m);
    }
  } catch (const FormatError&) {
  }
  return 0;
}
