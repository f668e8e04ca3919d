// SPDX-License-Identifier: Apache-2.0
// A client's WebSocket.
#include <array>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <utility>

#include "connections.hpp"

namespace tocsin::foxglove {
namespace {

namespace websocket = beast::websocket;

class SocketConnection final : public Socket,
                               public std::enable_shared_from_this<SocketConnection> {
 public:
  SocketConnection(Home& home, ClientStream stream, Lease lease)
      : home_(home), lease_(std::move(lease)), socket_(std::move(stream)) {}

  void open(const Request& request, const OpenSocket& verdict) {
    const auto& settings = home_.settings();
    socket_.next_layer().next_layer().expires_never();
    peer_ = {text_of_peer(), verdict.role};
    const auto ping = milliseconds_of(settings.ping_s * 2);
    socket_.set_option(
        websocket::stream_base::timeout{milliseconds_of(settings.request_s), ping, true});
    socket_.set_option(websocket::stream_base::decorator(
        [protocol = verdict.protocol](websocket::response_type& response) {
          response.set(http::field::sec_websocket_protocol, protocol);
        }));
    socket_.read_message_max(settings.most_frame_bytes);
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (error) return;  // nobody has heard of it yet
      self->id_ = self->home_.add(self);
      self->home_.events().opened(self->id_, self->peer_);
      self->read_on();
    });
  }

  void read_on() override {
    socket_.async_read(
        buffer_, [self = shared_from_this()](beast::error_code error, std::size_t /*size*/) {
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
    socket_.async_close(reason,
                        [self = shared_from_this()](beast::error_code error) { self->end(error); });
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
    socket_.async_write(parts,
                        [self = shared_from_this()](beast::error_code error, std::size_t /*size*/) {
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
    const auto peer = socket_.next_layer().next_layer().socket().remote_endpoint(error);
    return error ? "?" : peer.address().to_string() + ":" + std::to_string(peer.port());
  }

  Home& home_;
  const Lease lease_;
  websocket::stream<ClientStream, false> socket_;  // false: no compression
  beast::flat_buffer buffer_;
  std::vector<Frame> frames_;
  std::size_t at_ = 0;
  ClientId id_ = 0;
  WebPeer peer_;
  std::string reason_;
  bool closing_ = false;
  bool ended_ = false;
};

}  // namespace

void open_socket(Home& home, ClientStream stream, Lease lease, const Request& request,
                 const OpenSocket& verdict) {
  std::make_shared<SocketConnection>(home, std::move(stream), std::move(lease))
      ->open(request, verdict);
}

}  // namespace tocsin::foxglove
