// SPDX-License-Identifier: Apache-2.0
#include "client_stream.hpp"

#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <type_traits>

namespace tocsin::foxglove {

using TlsStream = beast::ssl_stream<beast::tcp_stream>;

class ClientStream::Io {
 public:
  virtual ~Io() = default;
  [[nodiscard]] virtual beast::tcp_stream& tcp() = 0;
  virtual void handshake(Ready ready) = 0;
  virtual void teardown(beast::role_type role, Ready ready) = 0;
  virtual void read_some(const FewBuffers<asio::mutable_buffer>& buffers, Done done) = 0;
  virtual void write_some(const FewBuffers<asio::const_buffer>& buffers, Done done) = 0;
};

template <class Stream>
class ClientStream::IoOver final : public Io {
 public:
  explicit IoOver(Stream stream) : stream_(std::move(stream)) {}
  beast::tcp_stream& tcp() override { return beast::get_lowest_layer(stream_); }
  void handshake(Ready ready) override {
    if constexpr (std::is_same_v<Stream, TlsStream>) {
      stream_.async_handshake(asio::ssl::stream_base::server, std::move(ready));
    } else {
      ready({});
    }
  }
  void teardown(beast::role_type role, Ready ready) override {
    using beast::websocket::async_teardown;
    async_teardown(role, stream_, std::move(ready));
  }
  void read_some(const FewBuffers<asio::mutable_buffer>& buffers, Done done) override {
    stream_.async_read_some(buffers, std::move(done));
  }
  void write_some(const FewBuffers<asio::const_buffer>& buffers, Done done) override {
    stream_.async_write_some(buffers, std::move(done));
  }

 private:
  Stream stream_;
};

ClientStream::ClientStream(asio::ip::tcp::socket socket, asio::ssl::context* tls) {
  if (tls != nullptr) {
    io_ = std::make_unique<IoOver<TlsStream>>(TlsStream(std::move(socket), *tls));
  } else {
    io_ = std::make_unique<IoOver<beast::tcp_stream>>(beast::tcp_stream(std::move(socket)));
  }
}
ClientStream::ClientStream(ClientStream&&) noexcept = default;
ClientStream& ClientStream::operator=(ClientStream&&) noexcept = default;
ClientStream::~ClientStream() = default;

beast::tcp_stream& ClientStream::next_layer() { return io_->tcp(); }
const beast::tcp_stream& ClientStream::next_layer() const { return io_->tcp(); }
void ClientStream::handshake(Ready ready) { io_->handshake(std::move(ready)); }
void ClientStream::teardown(beast::role_type role, Ready ready) {
  io_->teardown(role, std::move(ready));
}
void ClientStream::read_some(const FewBuffers<asio::mutable_buffer>& buffers, Done done) {
  io_->read_some(buffers, std::move(done));
}
void ClientStream::write_some(const FewBuffers<asio::const_buffer>& buffers, Done done) {
  io_->write_some(buffers, std::move(done));
}

}  // namespace tocsin::foxglove
