// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/scans/findings.hpp"

namespace setsquare::app {

void print_findings(const std::vector<LogFinding>& findings, std::ostream& out) {
  for (const LogFinding& finding : findings) out << "  " << text_of(finding) << "\n";
}

}  // namespace setsquare::app
