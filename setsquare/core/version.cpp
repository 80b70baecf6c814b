// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/version.hpp"

namespace setsquare {

const char* version() { return SETSQUARE_VERSION; }

}  // namespace setsquare
