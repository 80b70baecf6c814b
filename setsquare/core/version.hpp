// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace setsquare {

/// Of this library, "1.2.3".
[[nodiscard]] const char* version();

}  // namespace setsquare
