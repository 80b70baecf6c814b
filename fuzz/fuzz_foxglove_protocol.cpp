// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "fuzz/fuzz_target.hpp"
#include "setsquare/foxglove/protocol.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  if (const auto request = foxglove::parse_client_request(bytes)) {
    const auto again =
        foxglove::parse_client_request(foxglove::subscription_request(request->subscribed));
    fuzz::require(again && again->subscribed == request->subscribed);
  }
  if (const auto channels = foxglove::parse_server_text(bytes)) {
    const auto again = foxglove::parse_server_text(foxglove::advertisement(*channels));
    fuzz::require(again && *again == *channels);
  }
  if (const auto frame = foxglove::parse_message_frame(bytes)) {
    fuzz::require(foxglove::message_frame(*frame) == bytes);
  }
  if (const auto chosen = foxglove::common_subprotocol(bytes)) {
    fuzz::require(bytes.find(*chosen) != std::string::npos);
  }
  return 0;
}
