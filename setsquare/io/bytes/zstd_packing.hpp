// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace setsquare {

/// The bytes as one Zstandard frame, which BlockUnpacker unpacks. `level`: as the command zstd has
/// it.
[[nodiscard]] std::string zstd_packed(std::string_view bytes, int level);

/// The same into a string whose memory is used again.
void pack_zstd(std::string_view bytes, int level, std::string& packed);

}  // namespace setsquare
