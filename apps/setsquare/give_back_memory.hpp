// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// For the programs: what a library's user does with freed memory is theirs to decide.
#pragma once

#include <cstdlib>  // Says whose library this is.

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace setsquare::app {

/// Gives memory that was freed back to the system. glibc keeps what lies between pieces in use: of
/// a mapper's keyframes as much as all outputs of the map take.
inline void give_back_memory() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

}  // namespace setsquare::app
