// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace setsquare {

/// Which part of a line of text stands at its position.
enum class TextAnchor { kStart, kMiddle, kEnd };

}  // namespace setsquare
