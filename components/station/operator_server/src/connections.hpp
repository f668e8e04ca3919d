// SPDX-License-Identifier: Apache-2.0
// Connections of the web server, over TCP or TLS. For web_server.cpp only.
#pragma once

#include <array>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "answers.hpp"
#include "web_server.hpp"

namespace tocsin::foxglove {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;

using PlainStream = beast::tcp_stream;
using TlsStream = beast::ssl_stream<beast::tcp_stream>;

/// A client as the server knows it.
class Socket {
 public:
  virtual ~Socket() = default;
  virtual void read_on() = 0;
  virtual void send(std::vector<Frame> frames) = 0;
  virtual void close(const std::string& why) = 0;
};

/// What connections need of their server. One thread.
class Home {
 public:
  virtual ~Home() = default;
  [[nodiscard]] virtual const WebSettings& settings() const = 0;
  [[nodiscard]] virtual const WebEvents& events() const = 0;
  [[nodiscard]] virtual Answer answer(const Request& request, bool wants_socket) = 0;
  /// Calls `done` with what `make` has made, later.
  virtual void make_slowly(SlowResponse make, std::function<void(Response&&)> done) = 0;
  [[nodiscard]] virtual ClientId add(const std::shared_ptr<Socket>& socket) = 0;
  virtual void remove(ClientId client, const std::string& why) = 0;
};

/// A lease on one of the server's connections.
using Lease = std::shared_ptr<void>;

inline std::chrono::milliseconds milliseconds_of(double seconds) {
  return std::chrono::milliseconds(static_cast<long>(seconds * 1000));
}

/// Goes on when bytes can be exchanged: at once, or after TLS's handshake unless that fails.
template <class Stream, class Next>
void when_ready(Stream& stream, Next next) {
  if constexpr (std::is_same_v<Stream, TlsStream>) {
    stream.async_handshake(asio::ssl::stream_base::server,
                           [next = std::move(next)](beast::error_code error) {
                             if (!error) next();
                           });
  } else {
    next();
  }
}

template <class Stream>
class SocketConnection final : public Socket,
                               public std::enable_shared_from_this<SocketConnection<Stream>> {
 public:
  SocketConnection(Home& home, Stream&& stream, Lease lease)
      : home_(home), lease_(std::move(lease)), socket_(std::move(stream)) {}

  void open(const Request& request, const std::string& protocol) {
    const auto& settings = home_.settings();
    beast::get_lowest_layer(socket_).expires_never();
    peer_ = text_of_peer();
    const auto ping = milliseconds_of(settings.ping_s * 2);
    socket_.set_option(
        websocket::stream_base::timeout{milliseconds_of(settings.request_s), ping, true});
    socket_.set_option(
        websocket::stream_base::decorator([protocol](websocket::response_type& response) {
          response.set(http::field::sec_websocket_protocol, protocol);
        }));
    socket_.read_message_max(settings.most_frame_bytes);
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = this->shared_from_this()](beast::error_code error) {
      if (error) return;  // nobody has heard of it yet
      self->id_ = self->home_.add(self);
      self->home_.events().opened(self->id_, self->peer_);
      self->read_on();
    });
  }

  void read_on() override {
    socket_.async_read(
        buffer_, [self = this->shared_from_this()](beast::error_code error, std::size_t /*size*/) {
          if (error) return self->end(error);
          const auto kind = self->socket_.got_text() ? Frame::Kind::text : Frame::Kind::binary;
          std::string bytes = beast::buffers_to_string(self->buffer_.data());
          self->buffer_.consume(self->buffer_.size());
          self->home_.events().received(self->id_, kind, std::move(bytes));
        });
  }

  void send(std::vector<Frame> frames) override {
    frames_ = std::move(frames);
    at_ = 0;
    write_next();
  }

  void close(const std::string& why) override {
    if (closing_) return;
    closing_ = true;
    reason_ = why;
    websocket::close_reason reason(websocket::close_code::policy_error);
    reason.reason.assign(why.substr(0, 120));
    socket_.async_close(
        reason, [self = this->shared_from_this()](beast::error_code error) { self->end(error); });
  }

 private:
  void write_next() {
    if (at_ >= frames_.size()) {
      frames_.clear();
      return home_.events().sent(id_);
    }
    const Frame& frame = frames_[at_++];
    socket_.binary(frame.kind == Frame::Kind::binary);
    const auto payload = frame.payload ? asio::buffer(*frame.payload) : asio::const_buffer();
    const std::array<asio::const_buffer, 2> parts{asio::buffer(frame.head), payload};
    socket_.async_write(
        parts, [self = this->shared_from_this()](beast::error_code error, std::size_t /*size*/) {
          if (error) return self->end(error);
          self->write_next();
        });
  }

  void end(const beast::error_code& error) {
    if (ended_) return;
    ended_ = true;
    home_.remove(id_, !reason_.empty() ? reason_ : error.message());
  }

  [[nodiscard]] std::string text_of_peer() {
    beast::error_code error;
    const auto peer = beast::get_lowest_layer(socket_).socket().remote_endpoint(error);
    return error ? "?" : peer.address().to_string() + ":" + std::to_string(peer.port());
  }

  Home& home_;
  const Lease lease_;
  websocket::stream<Stream> socket_;
  beast::flat_buffer buffer_;
  std::vector<Frame> frames_;
  std::size_t at_ = 0;
  ClientId id_ = 0;
  std::string peer_;
  std::string reason_;
  bool closing_ = false;
  bool ended_ = false;
};

/// A connection until it becomes a socket: requests for files, one after the other.
template <class Stream>
class HttpConnection final : public std::enable_shared_from_this<HttpConnection<Stream>> {
 public:
  HttpConnection(Home& home, Stream&& stream, Lease lease)
      : home_(home), lease_(std::move(lease)), stream_(std::move(stream)) {}

  void start() {
    set_deadline();
    when_ready(stream_, [self = this->shared_from_this()] { self->read(); });
  }

 private:
  static constexpr std::uint32_t most_header_bytes = 16 * 1024;
  static constexpr std::uint64_t most_body_bytes = 1024;  // nothing is asked for with a body

  void set_deadline() {
    beast::get_lowest_layer(stream_).expires_after(milliseconds_of(home_.settings().request_s));
  }

  void read() {
    parser_.emplace();
    parser_->header_limit(most_header_bytes);
    parser_->body_limit(most_body_bytes);
    set_deadline();
    http::async_read(stream_, buffer_, *parser_,
                     [self = this->shared_from_this()](beast::error_code error, std::size_t) {
                       if (!error) self->answer();
                     });
  }

  void answer() {
    const bool wants_socket = websocket::is_upgrade(parser_->get());
    std::visit([this](auto&& one) { this->give(std::forward<decltype(one)>(one)); },
               home_.answer(parser_->get(), wants_socket));
  }

  void give(const OpenSocket& socket) {
    auto made = std::make_shared<SocketConnection<Stream>>(home_, std::move(stream_), lease_);
    made->open(parser_->get(), socket.protocol);
  }
  void give(SlowResponse&& make) {
    beast::get_lowest_layer(stream_).expires_never();
    home_.make_slowly(std::move(make), [self = this->shared_from_this()](Response&& response) {
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
        [self = this->shared_from_this(), outgoing](beast::error_code error, std::size_t) {
          if (error) return;
          if (!outgoing->serializer.is_done()) return self->write_on(outgoing);
          if (outgoing->message.keep_alive()) self->read();
        });
  }

  Home& home_;
  const Lease lease_;
  Stream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
};

/// A connection that is one too many: told so, for a second at most, whatever it wants. Its last
/// bytes are read: a close before that would take the answer from it, too.
template <class Stream>
class TurnedAway final : public std::enable_shared_from_this<TurnedAway<Stream>> {
 public:
  TurnedAway(const std::string& why, Stream&& stream, Lease lease)
      : lease_(std::move(lease)),
        stream_(std::move(stream)),
        answer_(respond(Request{}, Refuse{503, why})) {}

  void start() {
    beast::get_lowest_layer(stream_).expires_after(std::chrono::seconds(1));
    when_ready(stream_, [self = this->shared_from_this()] { self->tell(); });
  }

 private:
  void tell() {
    http::async_write(stream_, answer_,
                      [self = this->shared_from_this()](beast::error_code error, std::size_t) {
                        if (error) return;
                        auto& socket = beast::get_lowest_layer(self->stream_).socket();
                        socket.shutdown(asio::ip::tcp::socket::shutdown_send, error);
                        self->hear_out();
                      });
  }
  void hear_out() {
    beast::get_lowest_layer(stream_).async_read_some(
        asio::buffer(ignored_),
        [self = this->shared_from_this()](beast::error_code error, std::size_t) {
          if (!error) self->hear_out();
        });
  }

  const Lease lease_;
  Stream stream_;
  Response answer_;
  std::array<char, 1024> ignored_{};
};

}  // namespace tocsin::foxglove
