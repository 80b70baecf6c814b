// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace setsquare {

/// The CRC-32 of gzip, PNG and MCAP. To go on behind bytes before, give their sum.
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes, std::uint32_t sum_before = 0);

}  // namespace setsquare
