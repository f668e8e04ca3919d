// SPDX-License-Identifier: Apache-2.0
#include <cstdint>  // Boost 1.83 needs it and does not say so

#include <array>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>
#include <utility>

#include "connections.hpp"

namespace tocsin::foxglove {
namespace {

/// A connection until it becomes a socket: requests for files, one after the other.
class HttpConnection final : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Home& home, ClientStream stream, Lease lease)
      : home_(home), lease_(std::move(lease)), stream_(std::move(stream)) {}

  void start() {
    set_deadline();
    stream_.handshake([self = shared_from_this()](beast::error_code error) {
      if (!error) self->read();
    });
  }

 private:
  static constexpr std::uint32_t most_header_bytes = 16 * 1024;
  static constexpr std::uint64_t most_body_bytes = 1024;  // nothing is asked for with a body

  void set_deadline() {
    stream_.next_layer().expires_after(milliseconds_of(home_.settings().request_s));
  }

  void read() {
    parser_.emplace();
    parser_->header_limit(most_header_bytes);
    parser_->body_limit(most_body_bytes);
    set_deadline();
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       if (!error) self->answer();
                     });
  }

  void answer() {
    const bool wants_socket = beast::websocket::is_upgrade(parser_->get());
    std::visit([this](auto&& one) { this->give(std::forward<decltype(one)>(one)); },
               home_.answer(parser_->get(), wants_socket));
  }

  void give(const OpenSocket& socket) {
    open_socket(home_, std::move(stream_), lease_, parser_->get(), socket);
  }
  void give(SlowResponse&& make) {
    stream_.next_layer().expires_never();
    home_.make_slowly(std::move(make), [self = shared_from_this()](Response&& response) {
      self->give(std::move(response));
    });
  }
  template <class Body>
  void give(http::response<Body>&& response) {
    write_on(std::make_shared<Outgoing<Body>>(std::move(response)));
  }

  /// An answer while it is sent.
  template <class Body>
  struct Outgoing {
    explicit Outgoing(http::response<Body>&& response) : message(std::move(response)) {}
    http::response<Body> message;
    http::response_serializer<Body> serializer{message};
  };
  /// Part by part: a file may take as long as it likes, but none of its parts.
  template <class Body>
  void write_on(const std::shared_ptr<Outgoing<Body>>& outgoing) {
    set_deadline();
    http::async_write_some(
        stream_, outgoing->serializer,
        [self = shared_from_this(), outgoing](beast::error_code error, std::size_t) {
          if (error) return;
          if (!outgoing->serializer.is_done()) return self->write_on(outgoing);
          if (outgoing->message.keep_alive()) self->read();
        });
  }

  Home& home_;
  const Lease lease_;
  ClientStream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
};

/// A connection that is one too many: told so, for a second at most, whatever it wants. Its last
/// bytes are read: a close before that would take the answer from it, too.
class TurnedAway final : public std::enable_shared_from_this<TurnedAway> {
 public:
  TurnedAway(const std::string& why, ClientStream stream, Lease lease)
      : lease_(std::move(lease)),
        stream_(std::move(stream)),
        answer_(respond(Request{}, Refuse{503, why})) {}

  void start() {
    stream_.next_layer().expires_after(std::chrono::seconds(1));
    stream_.handshake([self = shared_from_this()](beast::error_code error) {
      if (!error) self->tell();
    });
  }

 private:
  void tell() {
    http::async_write(stream_, answer_,
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        if (error) return;
                        auto& socket = self->stream_.next_layer().socket();
                        socket.shutdown(asio::ip::tcp::socket::shutdown_send, error);
                        self->hear_out();
                      });
  }
  void hear_out() {
    stream_.next_layer().async_read_some(
        asio::buffer(ignored_), [self = shared_from_this()](beast::error_code error, std::size_t) {
          if (!error) self->hear_out();
        });
  }

  const Lease lease_;
  ClientStream stream_;
  Response answer_;
  std::array<char, 1024> ignored_{};
};

}  // namespace

void serve_http(Home& home, ClientStream stream, Lease lease) {
  std::make_shared<HttpConnection>(home, std::move(stream), std::move(lease))->start();
}

void turn_away(const std::string& why, ClientStream stream, Lease lease) {
  std::make_shared<TurnedAway>(why, std::move(stream), std::move(lease))->start();
}

}  // namespace tocsin::foxglove
