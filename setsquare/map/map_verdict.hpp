// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from map: the same words in the terminal and on the page.
#pragma once

#include <string>

#include "setsquare/map/map.hpp"

namespace setsquare {

/// What the audit says of a map in one line: "consistent (312 of 312 independent matches agree)",
/// "doubtful in 2 places (290 of 312 independent matches agree)", or "unconfirmed (...)" where no
/// match agrees. Empty where the map was not audited.
[[nodiscard]] std::string map_verdict(const Map& map);

}  // namespace setsquare
