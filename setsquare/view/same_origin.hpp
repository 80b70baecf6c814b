// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace setsquare::view {

/// Whether a request's Host names this machine by an address, or as "localhost": a name that
/// somebody else's name server may have led here does not count. With a port or without.
[[nodiscard]] bool is_own_host(std::string_view host);

/// Whether a request comes from a page of that host itself: browsers tell of every WebSocket from
/// which site the page is that opens it. One that does not tell is refused, too.
[[nodiscard]] bool is_same_origin(std::string_view origin, std::string_view host);

}  // namespace setsquare::view
