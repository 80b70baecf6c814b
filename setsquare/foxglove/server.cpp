// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/foxglove/server.hpp"

#include <array>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <map>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/foxglove/protocol.hpp"

namespace setsquare::foxglove {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;

/// Of frames that a client sends: it asks, no more.
constexpr std::size_t kMaxRequestBytes = 1U << 20U;
constexpr std::size_t kMaxSubscriptions = 1000;

}  // namespace

// Not in the anonymous namespace: Server's parts hold them.

using Bytes = std::shared_ptr<const std::string>;

/// A channel with its last message, where late clients want it.
struct ServedChannel {
  Channel channel;
  bool is_latched = false;
  Timestamp stamp;
  Bytes last;
};

/// What all clients share: of the server's thread, but for the counts.
struct Shared {
  std::string name;
  std::string session;
  std::vector<ServedChannel> channels;
  std::atomic<std::uint64_t> num_left_out = 0;
  std::atomic<std::uint64_t> num_refused = 0;
};

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Tcp::socket socket, Shared& shared) : stream_(std::move(socket)), shared_(shared) {}

  /// The handshake, then all that there is.
  void start(std::function<void()> on_ready, std::function<void()> on_end) {
    on_ready_ = std::move(on_ready);
    on_end_ = std::move(on_end);
    beast::get_lowest_layer(stream_).expires_after(std::chrono::seconds(10));
    http::async_read(beast::get_lowest_layer(stream_),
                     buffer_,
                     request_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       if (!error) return self->accept();
                       self->end();
                     });
  }

  [[nodiscard]] const std::map<std::uint32_t, std::uint32_t>& subscriptions() const {
    return subscriptions_;
  }

  void send_text(std::string text) {
    send({std::make_shared<const std::string>(std::move(text)), true});
  }
  void send_message(std::uint32_t subscription, Timestamp stamp, const std::string& cdr) {
    send({std::make_shared<const std::string>(message_frame({subscription, stamp, cdr})), false});
  }
  void close() { beast::get_lowest_layer(stream_).close(); }

 private:
  struct Frame {
    Bytes bytes;
    bool is_text = false;
  };

  void accept() {
    beast::get_lowest_layer(stream_).expires_never();
    const auto field = request_[http::field::sec_websocket_protocol];
    const auto chosen = common_subprotocol({field.data(), field.size()});
    if (!websocket::is_upgrade(request_) || !chosen) {
      ++shared_.num_refused;
      return end();
    }
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.set_option(websocket::stream_base::decorator(
        [name = std::string(*chosen)](websocket::response_type& response) {
          response.set(http::field::sec_websocket_protocol, name);
        }));
    stream_.read_message_max(kMaxRequestBytes);
    stream_.async_accept(request_, [self = shared_from_this()](beast::error_code error) {
      if (error) return self->end();
      self->buffer_.consume(self->buffer_.size());
      self->send_text(server_info(self->shared_.name, self->shared_.session));
      std::vector<Channel> channels;
      for (const ServedChannel& served : self->shared_.channels) channels.push_back(served.channel);
      self->send_text(advertisement(channels));
      self->on_ready_();
      self->read();
    });
  }

  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->end();
      self->take(beast::buffers_to_string(self->buffer_.data()));
      self->buffer_.consume(self->buffer_.size());
      self->read();
    });
  }

  void take(const std::string& frame) {
    const auto request =
        stream_.got_text() ? parse_client_request(frame) : std::optional<ClientRequest>();
    if (!request) {
      ++shared_.num_refused;
      return;
    }
    for (const std::uint32_t id : request->unsubscribed) subscriptions_.erase(id);
    for (const auto& [id, channel] : request->subscribed) {
      if (channel >= shared_.channels.size() || subscriptions_.size() >= kMaxSubscriptions)
        continue;
      subscriptions_[id] = channel;
      const ServedChannel& served = shared_.channels[channel];
      if (served.is_latched && served.last) send_message(id, served.stamp, *served.last);
    }
    on_ready_();
  }

  void send(Frame frame) {
    if (num_bytes_waiting_ + frame.bytes->size() > Server::kMaxBytesWaiting) {
      ++shared_.num_left_out;
      return;
    }
    num_bytes_waiting_ += frame.bytes->size();
    frames_.push_back(std::move(frame));
    if (frames_.size() == 1) write();
  }

  void write() {
    stream_.text(frames_.front().is_text);
    stream_.async_write(asio::buffer(*frames_.front().bytes),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          if (error) return self->end();
                          self->num_bytes_waiting_ -= self->frames_.front().bytes->size();
                          self->frames_.pop_front();
                          if (!self->frames_.empty()) self->write();
                        });
  }

  void end() {
    if (on_end_) std::exchange(on_end_, {})();
  }

  websocket::stream<beast::tcp_stream> stream_;
  Shared& shared_;
  beast::flat_buffer buffer_;
  http::request<http::empty_body> request_;
  std::map<std::uint32_t, std::uint32_t> subscriptions_;  ///< Channels by the client's numbers.
  std::deque<Frame> frames_;
  std::size_t num_bytes_waiting_ = 0;
  std::function<void()> on_ready_;  ///< Subscriptions have changed.
  std::function<void()> on_end_;
};

class Server::Parts {
 public:
  explicit Parts(const ServerOptions& options) : acceptor_(context_) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    shared_.name = options.name;
    shared_.session =
        std::to_string(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
    listen(options);
    accept();
    thread_ = std::thread([this] { context_.run(); });
  }
  ~Parts() {
    asio::post(context_, [this] {
      beast::error_code ignored;
      acceptor_.close(ignored);
      for (const auto& client : clients_) client->close();
      context_.stop();
    });
    thread_.join();
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  std::uint32_t add_channel(const std::string& topic,
                            const std::string& type,
                            const std::string& definition,
                            bool is_latched) {
    const std::uint32_t id = num_channels_++;
    latched_[id] = is_latched;
    asio::post(context_, [=, this] {
      const Channel channel{id, topic, "cdr", type, definition};
      shared_.channels.push_back({channel, is_latched, {}, {}});
      for (const auto& client : ready_) client->send_text(advertisement({&channel, 1}));
    });
    return id;
  }

  void publish(std::uint32_t channel, Timestamp stamp, std::string_view cdr) {
    if (!wanted_[channel] && !latched_[channel]) return;
    if (num_bytes_posted_ + cdr.size() > kMaxBytesWaiting) {
      ++shared_.num_left_out;
      return;
    }
    num_bytes_posted_ += cdr.size();
    auto bytes = std::make_shared<const std::string>(cdr);
    asio::post(context_, [this, channel, stamp, bytes = std::move(bytes)] {
      num_bytes_posted_ -= bytes->size();
      ServedChannel& served = shared_.channels[channel];
      if (served.is_latched) served.last = bytes;
      served.stamp = stamp;
      for (const auto& client : ready_) {
        for (const auto& [id, of] : client->subscriptions()) {
          if (of == channel) client->send_message(id, stamp, *bytes);
        }
      }
    });
  }

  [[nodiscard]] bool is_wanted(std::uint32_t channel) const { return wanted_[channel]; }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::size_t num_clients() const { return num_clients_; }
  [[nodiscard]] const Shared& shared() const { return shared_; }

 private:
  static constexpr std::size_t kMaxChannels = 64;

  void listen(const ServerOptions& options) {
    const std::string where = options.address + ":" + std::to_string(options.port);
    beast::error_code error;
    const Tcp::endpoint endpoint(asio::ip::make_address(options.address, error), options.port);
    if (!error) acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error) throw FileError(where, "cannot be listened on: " + error.message());
    port_ = acceptor_.local_endpoint().port();
  }

  void accept() {
    acceptor_.async_accept([this](beast::error_code error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error && clients_.size() < kMaxClients) {
        const auto client = std::make_shared<Connection>(std::move(socket), shared_);
        clients_.insert(client);
        // By its address: a client that holds itself would never go.
        client->start(
            [this, one = client.get()] {
              ready_.insert(one->shared_from_this());
              count();
            },
            [this, one = client.get()] {
              ready_.erase(one->shared_from_this());
              clients_.erase(one->shared_from_this());
              count();
            });
      }
      accept();
    });
  }

  void count() {
    num_clients_ = ready_.size();
    for (std::uint32_t id = 0; id < num_channels_; ++id) wanted_[id] = false;
    for (const auto& client : ready_) {
      for (const auto& [id, channel] : client->subscriptions()) wanted_[channel] = true;
    }
  }

  asio::io_context context_{1};
  Tcp::acceptor acceptor_;
  Shared shared_;
  std::set<std::shared_ptr<Connection>> clients_;
  std::set<std::shared_ptr<Connection>> ready_;  ///< Those that got through the handshake.
  std::atomic<std::uint32_t> num_channels_ = 0;
  std::array<std::atomic<bool>, kMaxChannels> wanted_{};
  std::array<std::atomic<bool>, kMaxChannels> latched_{};
  std::atomic<std::size_t> num_bytes_posted_ = 0;  ///< On their way to the thread.
  std::atomic<std::uint16_t> port_ = 0;
  std::atomic<std::size_t> num_clients_ = 0;
  std::thread thread_;
};

Server::Server(const ServerOptions& options) : parts_(std::make_unique<Parts>(options)) {}
Server::~Server() = default;

std::uint32_t Server::add_channel(const std::string& topic,
                                  const std::string& type,
                                  const std::string& definition,
                                  bool is_latched) {
  return parts_->add_channel(topic, type, definition, is_latched);
}
void Server::publish(std::uint32_t channel, Timestamp stamp, std::string_view cdr) {
  parts_->publish(channel, stamp, cdr);
}
bool Server::is_wanted(std::uint32_t channel) const { return parts_->is_wanted(channel); }
std::uint16_t Server::port() const { return parts_->port(); }
std::size_t Server::num_clients() const { return parts_->num_clients(); }
std::uint64_t Server::num_left_out() const { return parts_->shared().num_left_out; }
std::uint64_t Server::num_refused() const { return parts_->shared().num_refused; }

}  // namespace setsquare::foxglove
