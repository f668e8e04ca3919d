// SPDX-License-Identifier: Apache-2.0
#include "web_server.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <map>
#include <thread>

#include "connections.hpp"
#include "foundation/error.hpp"
#include "page_files.hpp"

namespace tocsin::foxglove {
namespace {

using asio::ip::tcp;

std::string field(const Request& request, http::field name) {
  const auto found = request.find(name);
  return found == request.end() ? std::string() : std::string(found->value());
}

RequestFacts facts_of(const Request& request, bool wants_socket) {
  return {std::string(request.method_string()),
          std::string(request.target()),
          field(request, http::field::host),
          field(request, http::field::origin),
          field(request, http::field::authorization),
          field(request, http::field::sec_websocket_protocol),
          wants_socket};
}

Response respond(const Request& request, unsigned status, const char* type, std::string body) {
  Response response{static_cast<http::status>(status), request.version()};
  response.set(http::field::content_type, type);
  response.set(http::field::cache_control, "no-cache");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("X-Frame-Options", "DENY");
  response.keep_alive(request.keep_alive() && status < 400);
  response.content_length(body.size());
  if (request.method() != http::verb::head) response.body() = std::move(body);
  return response;
}

std::optional<asio::ssl::context> tls_of(const WebSettings& settings) {
  if (settings.certificate.empty()) return std::nullopt;
  asio::ssl::context context(asio::ssl::context::tls_server);
  context.set_options(asio::ssl::context::default_workarounds | asio::ssl::context::no_tlsv1 |
                      asio::ssl::context::no_tlsv1_1);
  boost::system::error_code error;
  context.use_certificate_chain_file(settings.certificate, error);
  if (error) throw ConfigError("certificate " + settings.certificate + ": " + error.message());
  context.use_private_key_file(settings.key, asio::ssl::context::pem, error);
  if (error) throw ConfigError("key " + settings.key + ": " + error.message());
  return context;
}

}  // namespace

class WebServer::Core final : public Home {
 public:
  Core(const WebSettings& settings, WebEvents events)
      : settings_(settings), events_(std::move(events)), tls_(tls_of(settings)) {}
  ~Core() override {
    io_.stop();
    if (thread_.joinable()) thread_.join();
  }
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  void start(FileDescriptor socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    ::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size);
    acceptor_.assign(address.ss_family == AF_INET6 ? tcp::v6() : tcp::v4(), socket.release());
    accept();
    thread_ = std::thread([this] { io_.run(); });
  }

  /// Does something with a client on the server's thread, if it is still there.
  template <class Action>
  void with(ClientId client, Action action) {
    asio::post(io_, [this, client, action = std::move(action)]() mutable {
      const auto found = sockets_.find(client);
      if (found != sockets_.end()) action(*found->second);
    });
  }

  [[nodiscard]] const WebSettings& settings() const override { return settings_; }
  [[nodiscard]] const WebEvents& events() const override { return events_; }
  [[nodiscard]] ClientId add(const std::shared_ptr<Socket>& socket) override {
    sockets_[++last_] = socket;
    return last_;
  }
  void remove(ClientId client, const std::string& why) override {
    if (sockets_.erase(client) != 0) events_.closed(client, why);
  }

  [[nodiscard]] std::optional<Response> answer(const Request& request, bool wants_socket,
                                               std::string& protocol) override {
    const Verdict verdict = judge(settings_.access, facts_of(request, wants_socket));
    if (const auto* open = std::get_if<OpenSocket>(&verdict)) {
      protocol = open->protocol;
      return std::nullopt;
    }
    if (const auto* refusal = std::get_if<Refuse>(&verdict)) {
      if (wants_socket) events_.refused(refusal->reason);
      return respond(request, refusal->status, "text/plain; charset=utf-8", refusal->reason + "\n");
    }
    const std::string& path = std::get<ServeFile>(verdict).path;
    PageFile file =
        page_file(settings_.page, path,
                  field(request, http::field::accept_encoding).find("gzip") != std::string::npos);
    Response response = respond(request, file.status, file.type, std::move(file.bytes));
    if (file.zipped) response.set(http::field::content_encoding, "gzip");
    response.set("Content-Security-Policy", page_policy);
    return response;
  }

 private:
  void accept() {
    acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) return accept_later();  // no descriptor left, perhaps
      greet(std::move(socket));
      accept();
    });
  }
  void accept_later() {
    later_.expires_after(std::chrono::milliseconds(100));
    later_.async_wait([this](boost::system::error_code error) {
      if (!error) accept();
    });
  }
  void greet(tcp::socket socket) {
    if (connections_ >= settings_.most_connections) {
      return events_.refused("more than " + std::to_string(settings_.most_connections) +
                             " connections");  // the socket closes
    }
    ++connections_;
    const Lease lease(nullptr, [this](void*) { --connections_; });
    // What waits in the kernel is old when a slow client reads it.
    boost::system::error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    socket.set_option(asio::socket_base::send_buffer_size(128 * 1024), ignored);
    if (tls_) {
      std::make_shared<HttpConnection<TlsStream>>(*this, TlsStream(std::move(socket), *tls_), lease)
          ->start();
    } else {
      std::make_shared<HttpConnection<PlainStream>>(*this, PlainStream(std::move(socket)), lease)
          ->start();
    }
  }

  const WebSettings settings_;
  const WebEvents events_;
  std::optional<asio::ssl::context> tls_;
  std::size_t connections_ = 0;  // before io_, whose handlers hold leases
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
  asio::steady_timer later_{io_};
  ClientId last_ = 0;
  std::map<ClientId, std::shared_ptr<Socket>> sockets_;
  std::thread thread_;
};

WebServer::WebServer(const WebSettings& settings, WebEvents events)
    : core_(std::make_unique<Core>(settings, std::move(events))) {}
WebServer::~WebServer() = default;

void WebServer::start(FileDescriptor listening_socket) {
  core_->start(std::move(listening_socket));
}

void WebServer::read_on(ClientId client) {
  core_->with(client, [](Socket& socket) { socket.read_on(); });
}

void WebServer::send(ClientId client, std::vector<Frame> frames) {
  core_->with(client, [frames = std::move(frames)](Socket& socket) mutable {
    socket.send(std::move(frames));
  });
}

void WebServer::close(ClientId client, const std::string& why) {
  core_->with(client, [why](Socket& socket) { socket.close(why); });
}

}  // namespace tocsin::foxglove
