// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace setsquare {

/// Zero-mean normalised cross-correlation of two profiles of equal length, bin by bin, in [-1, 1]:
/// their covariance over the product of their standard deviations. 0 where either is flat or empty.
[[nodiscard]] double zncc(std::span<const std::int32_t> reference,
                          std::span<const std::int32_t> current);

}  // namespace setsquare
