# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Logs mapped side by side, a process each."""
import concurrent.futures
import sys


def in_parallel(calls, processes):
    """What each call, (function, argument...), returns, in their order; tells the progress. The first
    error ends all."""
    with concurrent.futures.ProcessPoolExecutor(processes) as pool:
        running = [pool.submit(*call) for call in calls]
        for number, done in enumerate(concurrent.futures.as_completed(running), 1):
            if done.exception():
                pool.shutdown(cancel_futures=True)
                raise done.exception()
            print(f"\r{number} of {len(calls)} logs", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return [done.result() for done in running]
