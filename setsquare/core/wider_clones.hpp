// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Before a function: also compile it for the wider instructions that most x86-64 machines have,
/// and choose when the program starts. The same arithmetic, so the same bits. Without effect where
/// the compiler or the machine knows no such choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SETSQUARE_WIDER_CLONES [[gnu::target_clones("default", "avx2")]]
#else
#define SETSQUARE_WIDER_CLONES
#endif
