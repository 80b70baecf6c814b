// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/view/same_origin.hpp"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <cctype>
#include <string>

namespace setsquare::view {
namespace {

bool is_port(std::string_view text) {
  constexpr std::size_t kMostDigits = 5;
  return !text.empty() && text.size() <= kMostDigits &&
         text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_equal(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char one, unsigned char other) {
    return std::tolower(one) == std::tolower(other);
  });
}

}  // namespace

bool is_own_host(std::string_view host) {
  boost::system::error_code error;
  if (host.starts_with('[')) {  // an address of IPv6
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos) return false;
    const std::string_view rest = host.substr(end + 1);
    if (!rest.empty() && (rest.front() != ':' || !is_port(rest.substr(1)))) return false;
    (void)boost::asio::ip::make_address_v6(std::string(host.substr(1, end - 1)), error);
    return !error;
  }
  if (const std::size_t colon = host.find(':'); colon != std::string_view::npos) {
    if (!is_port(host.substr(colon + 1))) return false;
    host = host.substr(0, colon);
  }
  if (is_equal(host, "localhost")) return true;
  (void)boost::asio::ip::make_address_v4(std::string(host), error);
  return !error;
}

bool is_same_origin(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  return is_own_host(host) && origin.starts_with(kScheme) &&
         is_equal(origin.substr(kScheme.size()), host);
}

}  // namespace setsquare::view
