// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/localizer.hpp"

#include <utility>

#include "setsquare/localisation/localizer_tracker.hpp"
#include "setsquare/localisation/place_hypotheses.hpp"

namespace setsquare {

class Localizer::Parts {
 public:
  Parts(std::shared_ptr<const KnownMap> map, const LocalisationParams& params)
      : hypotheses(std::move(map), params) {}

  LocalizerTracker tracker;
  PlaceHypotheses hypotheses;
};

Localizer::Localizer(std::shared_ptr<const KnownMap> map, const LocalisationParams& params)
    : parts_(std::make_unique<Parts>(std::move(map), params)) {}
Localizer::~Localizer() = default;
Localizer::Localizer(Localizer&&) noexcept = default;
Localizer& Localizer::operator=(Localizer&&) noexcept = default;

LocalisedPose Localizer::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  const TrackedPose tracked = parts_->tracker.track(scan, T_wheels_base);
  return parts_->hypotheses.add(tracked, parts_->tracker.seen(scan));
}

void Localizer::set_pose(const Pose2& T_map_base) { parts_->hypotheses.set_pose(T_map_base); }

}  // namespace setsquare
