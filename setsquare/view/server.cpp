// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/view/server.hpp"

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/view/same_origin.hpp"

namespace setsquare::view {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Text = std::shared_ptr<const std::string>;
using Texts = std::array<Text, kNumShown>;

/// Commands that wait for the thread that carries them out.
class CommandQueue {
 public:
  /// Gives the answer back on the command's thread.
  using OnAnswer = std::function<void(std::string)>;

  explicit CommandQueue(Server::OnCommand on_command)
      : on_command_(std::move(on_command)), thread_([this] { run(); }) {}
  ~CommandQueue() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
    }
    has_more_.notify_all();
    thread_.join();
  }
  CommandQueue(const CommandQueue&) = delete;
  CommandQueue& operator=(const CommandQueue&) = delete;

  /// False where too many wait.
  bool add(std::string command, OnAnswer on_answer) {
    {
      const std::lock_guard lock(mutex_);
      if (commands_.size() >= Server::kMaxCommands) return false;
      commands_.emplace_back(std::move(command), std::move(on_answer));
    }
    has_more_.notify_one();
    return true;
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      has_more_.wait(lock, [this] { return is_ending_ || !commands_.empty(); });
      if (is_ending_) return;
      const auto [command, on_answer] = std::move(commands_.front());
      commands_.pop_front();
      lock.unlock();
      on_answer(on_command_(command));
      lock.lock();
    }
  }

  const Server::OnCommand on_command_;
  std::mutex mutex_;  ///< All below.
  std::condition_variable has_more_;
  std::deque<std::pair<std::string, OnAnswer>> commands_;
  bool is_ending_ = false;
  std::thread thread_;
};

/// What all connections share: of the server's thread, but for the counts.
struct ViewShared {
  std::string page;
  Texts last;
  CommandQueue* commands = nullptr;
  std::atomic<std::uint64_t> num_refused = 0;
};

/// A browser: one request for the page, or a WebSocket.
class ViewConnection : public std::enable_shared_from_this<ViewConnection> {
 public:
  ViewConnection(Tcp::socket socket, ViewShared& shared)
      : stream_(std::move(socket)), shared_(shared) {}

  void start(std::function<void()> on_ready, std::function<void()> on_end) {
    on_ready_ = std::move(on_ready);
    on_end_ = std::move(on_end);
    parser_.header_limit(Server::kMaxRequestBytes);
    tcp().expires_after(std::chrono::seconds(10));
    http::async_read(
        tcp(), buffer_, parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
          if (!error) return self->answer();
          ++self->shared_.num_refused;
          self->end();
        });
  }

  /// Sends it when what was sent before is read; of its kind it replaces what waits.
  void send(Shown kind, Text text) {
    waiting_[static_cast<std::size_t>(kind)] = std::move(text);
    if (!is_writing_) write();
  }
  void close() { tcp().close(); }

 private:
  beast::tcp_stream& tcp() { return beast::get_lowest_layer(stream_); }

  std::string_view field(http::field name) const {
    const auto value = parser_.get()[name];
    return {value.data(), value.size()};
  }

  void answer() {
    const auto& request = parser_.get();
    const std::string_view host = field(http::field::host);
    if (!is_own_host(host)) return refuse(http::status::forbidden);
    if (request.method() != http::verb::get) return refuse(http::status::method_not_allowed);
    const std::string_view target(request.target().data(), request.target().size());
    if (target == "/live") {
      if (!websocket::is_upgrade(request)) return refuse(http::status::upgrade_required);
      if (!is_same_origin(field(http::field::origin), host)) return refuse(http::status::forbidden);
      return accept();
    }
    if (target != "/") return refuse(http::status::not_found);
    reply(http::status::ok, shared_.page);
  }

  void refuse(http::status status) {
    ++shared_.num_refused;
    reply(status,
          "<!DOCTYPE html><title>Setsquare</title><p>" +
              std::string(http::obsolete_reason(status)) + "\n");
  }

  void reply(http::status status, std::string body) {
    response_.result(status);
    response_.set(http::field::content_type, "text/html; charset=utf-8");
    response_.set(http::field::cache_control, "no-store");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("X-Frame-Options", "DENY");  // Nobody is led to click what is not seen.
    response_.keep_alive(false);
    response_.body() = std::move(body);
    response_.prepare_payload();
    http::async_write(
        tcp(), response_, [self = shared_from_this()](beast::error_code, std::size_t) {
          beast::error_code ignored;
          self->tcp().socket().shutdown(Tcp::socket::shutdown_send, ignored);
          self->end();
        });
  }

  void accept() {
    tcp().expires_never();
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.read_message_max(Server::kMaxRequestBytes);
    stream_.async_accept(parser_.get(), [self = shared_from_this()](beast::error_code error) {
      if (error) return self->end();
      self->is_open_ = true;
      self->buffer_.consume(self->buffer_.size());
      self->waiting_ = self->shared_.last;
      self->on_ready_();
      self->write();
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

  /// A command; its answer comes back to this thread.
  void take(std::string command) {
    const bool is_taken = shared_.commands->add(
        std::move(command),
        [one = weak_from_this(), executor = stream_.get_executor()](std::string text) {
          asio::post(executor, [one, text = std::move(text)]() mutable {
            const auto self = one.lock();
            if (!self) return;
            self->answers_.push_back(std::make_shared<const std::string>(std::move(text)));
            if (!self->is_writing_) self->write();
          });
        });
    if (!is_taken) ++shared_.num_refused;
  }

  /// What is to be sent next: answers first, then what is shown, in the order of its kinds.
  Text next() {
    if (!answers_.empty()) {
      Text text = std::move(answers_.front());
      answers_.pop_front();
      return text;
    }
    for (Text& text : waiting_) {
      if (text) return std::exchange(text, nullptr);
    }
    return nullptr;
  }

  void write() {
    sent_ = is_open_ ? next() : nullptr;
    is_writing_ = sent_ != nullptr;
    if (!is_writing_) return;
    stream_.text(true);
    stream_.async_write(asio::buffer(*sent_),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          if (error) return self->end();
                          self->write();
                        });
  }

  void end() {
    is_open_ = false;
    if (on_end_) std::exchange(on_end_, {})();
  }

  websocket::stream<beast::tcp_stream> stream_;
  ViewShared& shared_;
  beast::flat_buffer buffer_{2 * Server::kMaxRequestBytes};
  http::request_parser<http::empty_body> parser_;
  http::response<http::string_body> response_;
  bool is_open_ = false;  ///< As a WebSocket.
  bool is_writing_ = false;
  Text sent_;                 ///< Now.
  std::deque<Text> answers_;  ///< At most as many as commands wait.
  Texts waiting_;
  std::function<void()> on_ready_;
  std::function<void()> on_end_;
};

class Server::Parts {
 public:
  Parts(const ServerOptions& options, std::string page, OnCommand on_command)
      : acceptor_(context_), commands_(std::move(on_command)) {
    shared_.page = std::move(page);
    shared_.commands = &commands_;
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

  /// Of texts that the thread has not come to only the newest of a kind is kept, too.
  void show(Shown kind, std::string text) {
    {
      const std::lock_guard lock(mutex_);
      coming_[static_cast<std::size_t>(kind)] =
          std::make_shared<const std::string>(std::move(text));
      if (std::exchange(is_coming_, true)) return;
    }
    asio::post(context_, [this] { hand_on(); });
  }
  [[nodiscard]] std::size_t num_clients() const { return num_ready_; }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::uint64_t num_refused() const { return shared_.num_refused; }

 private:
  void hand_on() {
    Texts texts;
    {
      const std::lock_guard lock(mutex_);
      texts = std::exchange(coming_, {});
      is_coming_ = false;
    }
    for (std::size_t kind = 0; kind < kNumShown; ++kind) {
      if (!texts[kind]) continue;
      shared_.last[kind] = texts[kind];
      for (const auto& client : ready_) client->send(static_cast<Shown>(kind), texts[kind]);
    }
  }

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
        const auto client = std::make_shared<ViewConnection>(std::move(socket), shared_);
        clients_.insert(client);
        // By its address: a client that holds itself would never go.
        client->start(
            [this, one = client.get()] {
              ready_.insert(one->shared_from_this());
              num_ready_ = ready_.size();
            },
            [this, one = client.get()] {
              ready_.erase(one->shared_from_this());
              clients_.erase(one->shared_from_this());
              num_ready_ = ready_.size();
            });
      }
      accept();
    });
  }

  asio::io_context context_{1};
  Tcp::acceptor acceptor_;
  ViewShared shared_;
  std::set<std::shared_ptr<ViewConnection>> clients_;
  std::set<std::shared_ptr<ViewConnection>> ready_;  ///< Those that show the page.
  std::atomic<std::size_t> num_ready_ = 0;
  std::atomic<std::uint16_t> port_ = 0;
  std::mutex mutex_;  ///< The two below.
  Texts coming_;
  bool is_coming_ = false;
  CommandQueue commands_;
  std::thread thread_;  ///< The last: it uses the others.
};

Server::Server(const ServerOptions& options, std::string page, OnCommand on_command)
    : parts_(std::make_unique<Parts>(options, std::move(page), std::move(on_command))) {}
Server::~Server() = default;

void Server::show(Shown kind, std::string text) { parts_->show(kind, std::move(text)); }
std::size_t Server::num_clients() const { return parts_->num_clients(); }
std::uint16_t Server::port() const { return parts_->port(); }
std::uint64_t Server::num_refused() const { return parts_->num_refused(); }

}  // namespace setsquare::view
