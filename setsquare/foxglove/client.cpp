// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/foxglove/client.hpp"

#include <array>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare::foxglove {

ServerAddress parse_server_address(const std::string& url) {
  constexpr std::string_view kScheme = "ws://";
  const auto refuse = [&] {
    throw ParameterError("address", "'" + url + "' is no ws://HOST:PORT");
  };
  if (!url.starts_with(kScheme)) refuse();
  ServerAddress address;
  std::string rest = url.substr(kScheme.size());
  if (const std::size_t slash = rest.find('/'); slash != std::string::npos) {
    address.path = rest.substr(slash);
    rest.resize(slash);
  }
  const std::size_t bracket = rest.rfind(']');  // of an address of IPv6
  const std::size_t colon = rest.rfind(':');
  if (colon != std::string::npos && (bracket == std::string::npos || colon > bracket)) {
    address.port = rest.substr(colon + 1);
    rest.resize(colon);
  }
  if (rest.size() > 1 && rest.front() == '[' && rest.back() == ']') {
    rest = rest.substr(1, rest.size() - 2);
  }
  address.host = rest;
  const bool is_port = !address.port.empty() && address.port.size() <= 5 &&
                       address.port.find_first_not_of("0123456789") == std::string::npos;
  if (address.host.empty() || !is_port) refuse();
  return address;
}

/// Each function is a step on the client's thread; on_failure leads back to the first.
class Client::Parts {
  using Tcp = boost::asio::ip::tcp;
  using Error = boost::beast::error_code;
  using Stream = boost::beast::websocket::stream<boost::beast::tcp_stream>;

 public:
  Parts(const std::string& url, Calls calls)
      : url_(url),
        address_(parse_server_address(url)),
        calls_(std::move(calls)),
        resolver_(context_),
        timer_(context_) {
    connect();
    thread_ = std::thread([this] { context_.run(); });
  }
  ~Parts() {
    boost::asio::post(context_, [this] { context_.stop(); });
    thread_.join();
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  [[nodiscard]] std::uint64_t num_refused() const { return num_refused_; }

 private:
  void connect() {
    stream_.emplace(context_);
    buffer_.clear();
    numbers_.clear();
    resolver_.async_resolve(address_.host,
                            address_.port,
                            [this](Error error, const Tcp::resolver::results_type& found) {
                              if (error) return fail(error);
                              auto& socket = boost::beast::get_lowest_layer(*stream_);
                              socket.expires_after(std::chrono::seconds(10));
                              socket.async_connect(found,
                                                   [this](Error refused, const Tcp::endpoint&) {
                                                     if (refused) return fail(refused);
                                                     shake_hands();
                                                   });
                            });
  }

  void shake_hands() {
    namespace websocket = boost::beast::websocket;
    boost::beast::get_lowest_layer(*stream_).expires_never();
    stream_->set_option(
        websocket::stream_base::timeout::suggested(boost::beast::role_type::client));
    stream_->set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
      std::string names;
      for (const std::string_view name : kSubprotocols) {
        names += (names.empty() ? "" : ", ") + std::string(name);
      }
      request.set(boost::beast::http::field::sec_websocket_protocol, names);
    }));
    stream_->read_message_max(kMaxMessageBytes);
    stream_->async_handshake(
        address_.host + ":" + address_.port, address_.path, [this](Error error) {
          if (error) return fail(error);
          tell("connected");
          read();
        });
  }

  void read() {
    stream_->async_read(buffer_, [this](Error error, std::size_t) {
      if (error) return fail(error);
      const auto bytes = buffer_.cdata();
      const std::string_view frame(static_cast<const char*>(bytes.data()), bytes.size());
      if (stream_->got_text()) {
        take_text(frame);
      } else {
        take_message(frame);
      }
      buffer_.consume(buffer_.size());
      read();
    });
  }

  void take_text(std::string_view text) {
    const auto channels = parse_server_text(text);
    if (!channels) {
      ++num_refused_;
      return;
    }
    std::vector<Subscription> wanted;
    for (const Channel& channel : *channels) {
      const std::optional<std::size_t> number = calls_.on_channel(channel);
      if (!number || numbers_.size() >= kMaxSubscriptions) continue;
      const Subscription subscription{.id = static_cast<std::uint32_t>(numbers_.size()),
                                      .channel = channel.id};
      numbers_.push_back(*number);
      wanted.push_back(subscription);
    }
    if (wanted.empty()) return;
    // A few hundred bytes, and the server reads them or the connection is none.
    stream_->text(true);
    Error error;
    stream_->write(boost::asio::buffer(subscription_request(wanted)), error);
  }

  void take_message(std::string_view frame) {
    const auto message = parse_message_frame(frame);
    if (!message || message->subscription >= numbers_.size()) {
      ++num_refused_;
      return;
    }
    calls_.on_message(numbers_[message->subscription], message->data);
  }

  void fail(Error error) {
    constexpr std::chrono::seconds kPause(1);
    tell(error.message());
    timer_.expires_after(kPause);
    timer_.async_wait([this](Error stopped) {
      if (!stopped) connect();
    });
  }

  void tell(const std::string& state) {
    if (std::exchange(told_, state) != state) calls_.on_state(url_ + ": " + state);
  }

  static constexpr std::size_t kMaxSubscriptions = 1000;

  const std::string url_;
  const ServerAddress address_;
  const Calls calls_;
  boost::asio::io_context context_{1};
  Tcp::resolver resolver_;
  boost::asio::steady_timer timer_;
  std::optional<Stream> stream_;
  boost::beast::flat_buffer buffer_;
  std::vector<std::size_t> numbers_;  ///< Ours, by subscription.
  std::string told_;
  std::atomic<std::uint64_t> num_refused_ = 0;
  std::thread thread_;
};

Client::Client(const std::string& url, Calls calls)
    : parts_(std::make_unique<Parts>(url, std::move(calls))) {}
Client::~Client() = default;

std::uint64_t Client::num_refused() const { return parts_->num_refused(); }

}  // namespace setsquare::foxglove
