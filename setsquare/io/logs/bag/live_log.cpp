// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/live_log.hpp"

#include <utility>

#include "setsquare/io/logs/bag/bag_log.hpp"
#include "setsquare/io/logs/selecting_log_reader.hpp"
#include "setsquare/io/logs/time_window.hpp"

namespace setsquare {

std::unique_ptr<LogReader> open_live_log(std::unique_ptr<MessageSource> source,
                                         const std::string& name,
                                         const LogOptions& options) {
  options.validate();
  constexpr std::size_t kNumHeadScans = 1;
  auto records = std::make_unique<BagLog>(std::move(source), options);
  return within(
      options.window,
      std::make_unique<SelectingLogReader>(std::move(records), name, options, kNumHeadScans),
      name);
}

}  // namespace setsquare
