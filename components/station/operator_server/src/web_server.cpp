// SPDX-License-Identifier: Apache-2.0
#include "web_server.hpp"

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <map>
#include <thread>

#include "connections.hpp"
#include "foundation/error.hpp"

namespace tocsin::foxglove {
namespace {

using asio::ip::tcp;

RequestFacts facts_of(const Request& request, bool wants_socket) {
  return {std::string(request.method_string()),
          std::string(request.target()),
          field(request, http::field::host),
          field(request, http::field::origin),
          field(request, http::field::authorization),
          field(request, http::field::sec_websocket_protocol),
          wants_socket};
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
    ends_ = true;
    io_.stop();
    if (thread_.joinable()) thread_.join();
    if (slow_) slow_->stop();
    if (slow_) slow_->join();
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

  [[nodiscard]] Answer answer(const Request& request, bool wants_socket) override {
    const Verdict verdict = judge(settings_.access, facts_of(request, wants_socket));
    if (wants_socket && std::holds_alternative<Refuse>(verdict)) {
      events_.refused(std::get<Refuse>(verdict).reason);
    }
    return std::visit(AnswerTo{*this, request}, verdict);
  }
  void make_slowly(SlowResponse make, std::function<void(Response&&)> done) override {
    if (!slow_) slow_.emplace(1);
    asio::post(*slow_, [this, make = std::move(make), done = std::move(done)]() mutable {
      asio::post(io_, [done = std::move(done), made = std::make_shared<Response>(make())] {
        done(std::move(*made));
      });
    });
  }

 private:
  /// What a verdict comes to.
  struct AnswerTo {
    Core& core;
    const Request& request;
    Answer operator()(const OpenSocket& socket) const { return socket; }
    Answer operator()(const Refuse& refusal) const { return respond(request, refusal); }
    Answer operator()(const ServeFile& wanted) const {
      return page_answer(core.settings_.page, wanted.path, request);
    }
    Answer operator()(const ListBags&) const {
      return SlowResponse([&settings = core.settings_, asked = request] {
        return bag_list_answer(settings.bags, asked);
      });
    }
    Answer operator()(const ServeBag& wanted) const {
      return bag_answer(core.settings_.bags, wanted.path, request);
    }
    Answer operator()(const ServeTable& wanted) const {
      return SlowResponse([&settings = core.settings_, topic = wanted.topic, asked = request] {
        return table_answer(settings.recorded, topic, asked);
      });
    }
    Answer operator()(const AskWhatIf& question) const {
      return SlowResponse([&self = core, query = question.query, asked = request] {
        return what_if_answer(self.settings_, query, asked, self.ends_);
      });
    }
  };

  void accept() {
    acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) return accept_later();  // no descriptor left, perhaps
      greet(std::move(socket));
      if (turned_away_ < most_turned_away) accept();
    });
  }
  void accept_later() {
    later_.expires_after(std::chrono::milliseconds(100));
    later_.async_wait([this](boost::system::error_code error) {
      if (!error) accept();
    });
  }
  void greet(tcp::socket socket) {
    if (connections_ >= settings_.most_connections) return turn_away(std::move(socket));
    ++connections_;
    const Lease lease(nullptr, [this](void*) { --connections_; });
    // What waits in the kernel is old when a slow client reads it.
    boost::system::error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    socket.set_option(asio::socket_base::send_buffer_size(128 * 1024), ignored);
    serve_http(*this, stream_of(std::move(socket)), lease);
  }
  void turn_away(tcp::socket socket) {
    const std::string why =
        "more than " + std::to_string(settings_.most_connections) + " connections";
    events_.refused(why);
    ++turned_away_;
    const Lease lease(nullptr, [this](void*) {
      if (turned_away_-- == most_turned_away && !ends_) asio::post(io_, [this] { accept(); });
    });
    foxglove::turn_away(why, stream_of(std::move(socket)), lease);
  }
  [[nodiscard]] ClientStream stream_of(tcp::socket socket) {
    return ClientStream(std::move(socket), tls_ ? &*tls_ : nullptr);
  }

  /// At once; the kernel's queue holds those that come after them.
  static constexpr std::size_t most_turned_away = 64;

  const WebSettings settings_;
  const WebEvents events_;
  std::optional<asio::ssl::context> tls_;
  std::size_t connections_ = 0;  // before io_, whose handlers hold leases
  std::size_t turned_away_ = 0;  // as well
  std::atomic<bool> ends_{false};
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
  asio::steady_timer later_{io_};
  ClientId last_ = 0;
  std::map<ClientId, std::shared_ptr<Socket>> sockets_;
  std::thread thread_;
  std::optional<asio::thread_pool> slow_;  ///< since it was first needed
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
