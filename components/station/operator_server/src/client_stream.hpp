// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <boost/asio/async_result.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/buffers_range.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace tocsin::foxglove {

namespace asio = boost::asio;
namespace beast = boost::beast;

/// The first few buffers of a sequence; an operation that reads or writes "some" needs no more.
template <class Buffer>
class FewBuffers {
 public:
  using value_type = Buffer;  // NOLINT: Asio's concept names it so
  template <class Sequence>
  explicit FewBuffers(const Sequence& buffers) {
    for (const auto& buffer : beast::buffers_range_ref(buffers)) {
      if (size_ == buffers_.size()) break;
      if (buffer.size() > 0) buffers_[size_++] = buffer;
    }
  }
  [[nodiscard]] const Buffer* begin() const { return buffers_.data(); }
  [[nodiscard]] const Buffer* end() const { return buffers_.data() + size_; }

 private:
  std::array<Buffer, 8> buffers_{};
  std::size_t size_ = 0;
};

/// A connection over TCP or TLS, as an AsyncStream of Boost.Beast for one thread. Buffers and
/// handlers have one type each, so that Beast's HTTP and WebSocket are compiled once, not for each
/// kind of stream.
class ClientStream {
 public:
  using executor_type = beast::tcp_stream::executor_type;  // NOLINT: Asio's concept names it so
  using Done = std::function<void(beast::error_code, std::size_t)>;
  using Ready = std::function<void(beast::error_code)>;

  /// `tls`: of the server; null: plain TCP. It must outlive the stream.
  ClientStream(asio::ip::tcp::socket socket, asio::ssl::context* tls);
  ClientStream(ClientStream&&) noexcept;
  ClientStream& operator=(ClientStream&&) noexcept;
  ~ClientStream();

  [[nodiscard]] beast::tcp_stream& next_layer();
  [[nodiscard]] const beast::tcp_stream& next_layer() const;
  [[nodiscard]] executor_type get_executor() { return next_layer().get_executor(); }

  /// Calls `ready` when bytes can be exchanged: at once, or after the handshake of TLS.
  void handshake(Ready ready);
  /// Ends the connection in order, as WebSocket wants it.
  void teardown(beast::role_type role, Ready ready);

  template <class Buffers, class Handler>
  auto async_read_some(const Buffers& buffers, Handler&& handler) {
    return asio::async_initiate<Handler, void(beast::error_code, std::size_t)>(
        [this](auto&& done, const FewBuffers<asio::mutable_buffer>& few) {
          read_some(few, shared(std::forward<decltype(done)>(done)));
        },
        handler, FewBuffers<asio::mutable_buffer>(buffers));
  }
  template <class Buffers, class Handler>
  auto async_write_some(const Buffers& buffers, Handler&& handler) {
    return asio::async_initiate<Handler, void(beast::error_code, std::size_t)>(
        [this](auto&& done, const FewBuffers<asio::const_buffer>& few) {
          write_some(few, shared(std::forward<decltype(done)>(done)));
        },
        handler, FewBuffers<asio::const_buffer>(buffers));
  }

 private:
  class Io;
  template <class Stream>
  class IoOver;
  /// A handler can be moved only; a function is copied.
  template <class Handler>
  static auto shared(Handler&& handler) {
    return
        [held = std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
            auto&&... results) { std::move (*held)(std::forward<decltype(results)>(results)...); };
  }
  void read_some(const FewBuffers<asio::mutable_buffer>& buffers, Done done);
  void write_some(const FewBuffers<asio::const_buffer>& buffers, Done done);

  template <class Handler>
  friend void async_teardown(beast::role_type role, ClientStream& stream, Handler&& handler) {
    stream.teardown(role, shared(std::forward<Handler>(handler)));
  }

  std::unique_ptr<Io> io_;
};

}  // namespace tocsin::foxglove
