// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/io/bytes/input_buffer.hpp"

namespace setsquare {

/// Looks at the first bytes of an input that may be text. Skips UTF-8's byte order mark. Throws
/// FormatError with `name` and what to do where the bytes are UTF-16, or a pointer that Git LFS
/// left in place of the file (its specification's "version" line).
void begin_text(InputBuffer& input, const std::string& name);

}  // namespace setsquare
