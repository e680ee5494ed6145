// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/live/live_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <optional>
#include <thread>
#include <utility>  // Asio's coroutine header of Boost 1.74 needs it and does not include it
#include <vector>

#include "fairway/core/error.hpp"

namespace fairway {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using boost::system::error_code;
using net::ip::tcp;

/// What every connection of a server works with.
struct LiveHall {
  LiveServerLimits limits;
  std::function<LiveAnswer(const LiveRequest&)> answer;
  std::vector<class LiveConnection*> connections;
};

std::string joined(const http::request_header<>& head, std::string_view name) {
  std::string values;
  const auto [first, last] = head.equal_range(beast::string_view{name.data(), name.size()});
  for (auto field = first; field != last; ++field) {
    if (field != first) values += ",";
    values.append(field->value().data(), field->value().size());
  }
  return values;
}

LiveRequest request_of(const http::request_header<>& head) {
  return {.method = std::string{head.method_string()},
          .target = std::string{head.target()},
          .host = joined(head, "Host"),
          .origin = joined(head, "Origin"),
          .fetch_site = joined(head, "Sec-Fetch-Site"),
          .fairway = joined(head, "X-Fairway")};
}

http::response<http::string_body> response_of(LiveAnswer answer, unsigned version) {
  http::response<http::string_body> response{http::int_to_status(answer.status), version};
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Referrer-Policy", "no-referrer");
  response.set(http::field::cache_control, "no-store");
  if (!answer.allow.empty()) {
    response.set(http::field::allow, beast::string_view{answer.allow.data(), answer.allow.size()});
  }
  if (!answer.body.empty()) {
    response.set(http::field::content_type, beast::string_view{answer.type.data(), answer.type.size()});
  }
  response.body() = std::move(answer.body);
  if (response.result() != http::status::no_content) response.prepare_payload();
  return response;
}

/// The answer to what is no request that we understand, or nothing where nobody is there to read it.
std::optional<LiveAnswer> complaint_about(const error_code& error) {
  if (error.category() != make_error_code(http::error::bad_method).category()) return std::nullopt;
  if (error == http::error::end_of_stream || error == http::error::partial_message) return std::nullopt;
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    return LiveAnswer{.status = 431, .body = "the request is too long\n"};
  }
  if (error == http::error::unexpected_body) return LiveAnswer{.status = 413, .body = "expected no body\n"};
  return LiveAnswer{.status = 400, .body = "expected a request of HTTP/1.1\n"};
}

/// One after the other, the requests of one connection. It lives as long as something of it is under way.
class LiveConnection : public std::enable_shared_from_this<LiveConnection> {
 public:
  LiveConnection(tcp::socket socket, LiveHall& hall)
      : stream_{std::move(socket)}, buffer_{hall.limits.head_bytes}, hall_{hall} {
    hall_.connections.push_back(this);
  }
  ~LiveConnection() { leave(); }
  LiveConnection(const LiveConnection&) = delete;
  LiveConnection& operator=(const LiveConnection&) = delete;

  void read() {
    busy_ = false;
    since_ = std::chrono::steady_clock::now();
    parser_.emplace();
    parser_->header_limit(hall_.limits.head_bytes);
    stream_.expires_after(hall_.limits.patience);
    http::async_read(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](const error_code& error, std::size_t) { self->answer(error); });
  }

  void drop() {
    leave();
    error_code ignored;
    stream_.socket().close(ignored);
  }

  /// Whoever waits for a request goes before whoever is being answered, and then the older.
  std::pair<bool, std::chrono::steady_clock::time_point> seniority() const { return {busy_, since_}; }

 private:
  void leave() { std::erase(hall_.connections, this); }

  void answer(const error_code& error) {
    if (error) {
      if (std::optional<LiveAnswer> complaint = complaint_about(error))
        write(std::move(*complaint), 11, false);
      return;
    }
    const http::request<http::empty_body>& request = parser_->get();
    write(answer_to(request_of(request)), request.version(), request.keep_alive());
  }

  LiveAnswer answer_to(const LiveRequest& request) const {
    try {
      return hall_.answer(request);
    } catch (const std::exception&) {
      return {.status = 500, .body = "this cannot be answered\n"};
    }
  }

  void write(LiveAnswer answer, unsigned version, bool keep) {
    busy_ = true;
    since_ = std::chrono::steady_clock::now();
    response_ = response_of(std::move(answer), version);
    response_.keep_alive(keep);
    stream_.expires_after(hall_.limits.patience);
    http::async_write(stream_, response_,
                      [self = shared_from_this(), keep](const error_code& error, std::size_t) {
                        if (error) return;
                        self->response_ = {};
                        if (keep) return self->read();
                        error_code ignored;
                        self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
                      });
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::empty_body>> parser_;
  http::response<http::string_body> response_;
  LiveHall& hall_;
  std::chrono::steady_clock::time_point since_;
  bool busy_{false};
};

void make_room(LiveHall& hall) {
  if (hall.connections.size() < hall.limits.connections) return;
  (*std::ranges::min_element(hall.connections, {}, &LiveConnection::seniority))->drop();
}

}  // namespace

struct LiveServer::Loop {
  LiveHall hall;  // outlives the connections, which end with the context
  net::io_context context{1};
  tcp::acceptor acceptor{context};
  net::steady_timer pause{context};
  std::uint16_t port{};
  std::jthread thread;

  void open(std::uint16_t wished) {
    const tcp::endpoint place{net::ip::address_v4::loopback(), wished};
    acceptor.open(place.protocol());
    acceptor.set_option(tcp::acceptor::reuse_address(true));
    acceptor.bind(place);
    acceptor.listen();
    port = acceptor.local_endpoint().port();
  }

  void accept() {
    acceptor.async_accept([this](const error_code& error, tcp::socket socket) {
      if (error) return accept_later();
      accept();
      make_room(hall);
      std::make_shared<LiveConnection>(std::move(socket), hall)->read();
    });
  }

  // What one connection threw, out of memory perhaps, ends that connection alone.
  void run() {
    while (!context.stopped()) {
      try {
        context.run();
      } catch (const std::exception&) {
        continue;
      }
    }
  }

  // Out of descriptors, say: those of others come back.
  void accept_later() {
    pause.expires_after(std::chrono::milliseconds(100));
    pause.async_wait([this](const error_code&) { accept(); });
  }
};

LiveServer::LiveServer(std::uint16_t port, LiveServerLimits limits) : loop_{std::make_unique<Loop>()} {
  loop_->hall.limits = limits;
  try {
    loop_->open(port);
  } catch (const boost::system::system_error& error) {
    throw InputError(
        fmt::format("--port {}: 127.0.0.1:{} cannot be served: {}", port, port, error.code().message()));
  }
}

LiveServer::~LiveServer() { loop_->context.stop(); }

std::uint16_t LiveServer::port() const { return loop_->port; }

void LiveServer::serve(std::function<LiveAnswer(const LiveRequest&)> answer) {
  loop_->hall.answer = std::move(answer);
  loop_->accept();
  loop_->thread = std::jthread{[loop = loop_.get()] { loop->run(); }};
}

}  // namespace fairway
