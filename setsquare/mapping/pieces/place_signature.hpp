// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from piece_joining, its only caller, because tests compare signatures of known places.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/surfaces/surface_samples.hpp"

namespace setsquare {

/// What a place looks like, whatever the position that it is seen from: power spectra of the
/// projected profiles along the building's two axes, which a translation leaves as they are.
struct PlaceSignature {
  static constexpr std::size_t kNumFrequencies = 16;
  using Spectrum = std::array<float, kNumFrequencies>;
  Spectrum along_x{};  ///< Both together have the length 1.
  Spectrum along_y{};
};

/// The signature of samples whose frame has the heading `heading_rad` in the map.
[[nodiscard]] PlaceSignature place_signature(const SurfaceSamples& samples, double heading_rad);

/// 0 for the same, at most sqrt(2); the better of both orders of the axes, since a heading may be
/// known modulo a quarter turn only.
[[nodiscard]] double signature_distance(const PlaceSignature& a, const PlaceSignature& b);

/// Indices of the `num` nearest of the signatures, nearest first.
[[nodiscard]] std::vector<std::size_t> nearest_signatures(const PlaceSignature& query,
                                                          std::span<const PlaceSignature> among,
                                                          std::size_t num);

}  // namespace setsquare
