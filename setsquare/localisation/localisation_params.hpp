// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace setsquare {

/// How the places of a map are searched.
struct PlaceSearchParams {
  std::size_t num_proposals = 200;  ///< Best of the correlation.
  std::size_t num_verified = 40;    ///< Best of those, all different.
};

}  // namespace setsquare
