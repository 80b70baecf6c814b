// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "apps/setsquare/map/timing.hpp"
#include "apps/setsquare/outputs/output_set.hpp"
#include "setsquare/pipeline/map_log.hpp"

namespace setsquare::app {

/// Every file that `setsquare map` may write, as OutputSet wants them: in the order in which they
/// come. run.json is the last: where it is, the set is whole. docs/formats.md describes each.
[[nodiscard]] std::vector<std::string> map_output_names();

/// Makes and adds everything that a run leaves and commits the set. `clock` has the stages until
/// now; what is made here becomes stages of it, and all go into timing.json. Throws FileError;
/// nothing has changed then.
void write_map_outputs(OutputSet& outputs,
                       const MappedLog& mapped,
                       PoseOf pose_of,
                       StageClock& clock);

/// The line that tells which files were written.
[[nodiscard]] std::string written_text(const std::string& folder, const OutputSet& outputs);

}  // namespace setsquare::app
