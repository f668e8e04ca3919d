// SPDX-License-Identifier: Apache-2.0
#include "socket_client.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <mutex>
#include <thread>

namespace tocsin {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
  }
  return value;
}

tcp::endpoint endpoint_of(const ClientFacts& facts) {
  return {asio::ip::make_address("127.0.0.1"), static_cast<std::uint16_t>(facts.port)};
}

std::string host_of(const ClientFacts& facts) {
  const auto given = facts.headers.find("Host");
  return given != facts.headers.end() ? given->second : "127.0.0.1:" + std::to_string(facts.port);
}

}  // namespace

struct SocketClient::Core {
  explicit Core(ClientFacts its_facts) : facts(std::move(its_facts)) {}

  void open() {
    beast::get_lowest_layer(socket).async_connect(endpoint_of(facts), [this](auto error) {
      if (error) return end(error.message());
      if (!facts.reads)
        socket.next_layer().socket().set_option(asio::socket_base::receive_buffer_size(4096));
      socket.set_option(websocket::stream_base::decorator([this](websocket::request_type& request) {
        request.set(http::field::sec_websocket_protocol, facts.protocols);
        for (const auto& [name, value] : facts.headers) request.set(name, value);
      }));
      socket.async_handshake(response, host_of(facts), facts.target, [this](auto failure) {
        {
          const std::lock_guard<std::mutex> lock(mutex);
          answered = response.result_int();
          its_protocol = std::string(response[http::field::sec_websocket_protocol]);
          opened = !failure;
        }
        if (failure) return end(failure.message());
        if (facts.reads) read();
      });
    });
  }
  void read() {
    socket.async_read(buffer, [this](auto error, std::size_t) {
      if (error) return end(error.message() + ": " + std::string(socket.reason().reason.c_str()));
      take(beast::buffers_to_string(buffer.data()));
      buffer.consume(buffer.size());
      read();
    });
  }
  void take(const std::string& bytes) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (socket.got_text()) {
      texts.push_back(nlohmann::json::parse(bytes));
    } else {
      binaries.push_back(
          {bytes.at(0), bytes.size() < 5 ? 0 : number_at(bytes, 1), bytes.substr(1)});
    }
  }
  void end(const std::string& why) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!over) over = why;
  }
  void say(const std::string& bytes, bool binary) {
    asio::post(io, [this, bytes, binary] {
      waiting.emplace_back(bytes, binary);
      if (waiting.size() == 1) write();
    });
  }
  void write() {
    socket.binary(waiting.front().second);
    socket.async_write(asio::buffer(waiting.front().first), [this](auto error, std::size_t) {
      if (error) return end(error.message());
      waiting.pop_front();
      if (!waiting.empty()) write();
    });
  }

  const ClientFacts facts;
  asio::io_context io;
  asio::executor_work_guard<asio::io_context::executor_type> work{io.get_executor()};
  websocket::stream<beast::tcp_stream> socket{io};
  websocket::response_type response;
  beast::flat_buffer buffer;
  std::deque<std::pair<std::string, bool>> waiting;
  mutable std::mutex mutex;
  bool opened = false;
  unsigned answered = 0;
  std::string its_protocol;
  std::optional<std::string> over;
  std::vector<nlohmann::json> texts;
  std::vector<BinaryFrame> binaries;
  std::thread thread;
};

SocketClient::SocketClient(const ClientFacts& facts) : core_(std::make_unique<Core>(facts)) {
  core_->open();
  core_->thread = std::thread([this] { core_->io.run(); });
}

SocketClient::~SocketClient() {
  core_->io.stop();
  core_->thread.join();
}

bool SocketClient::is_open() const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  return core_->opened && !core_->over;
}

std::optional<std::string> SocketClient::ended() const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  return core_->over;
}

int SocketClient::status() const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  return static_cast<int>(core_->answered);
}

std::string SocketClient::protocol() const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  return core_->its_protocol;
}

void SocketClient::say_text(const std::string& text) { core_->say(text, false); }
void SocketClient::say_bytes(const std::string& bytes) { core_->say(bytes, true); }

std::vector<nlohmann::json> SocketClient::heard(const std::string& op) const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  std::vector<nlohmann::json> found;
  for (const auto& text : core_->texts) {
    if (text.at("op") == op) found.push_back(text);
  }
  return found;
}

std::vector<BinaryFrame> SocketClient::frames(int opcode) const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  std::vector<BinaryFrame> found;
  for (const auto& frame : core_->binaries) {
    if (frame.opcode == opcode) found.push_back(frame);
  }
  return found;
}

std::optional<std::uint32_t> SocketClient::channel(const std::string& topic) const {
  std::optional<std::uint32_t> id;
  for (const auto& message : heard("advertise")) {
    for (const auto& channel : message.at("channels")) {
      if (channel.at("topic") == topic) id = channel.at("id").get<std::uint32_t>();
    }
  }
  return id;
}

std::optional<std::uint32_t> SocketClient::service(const std::string& name) const {
  std::optional<std::uint32_t> id;
  for (const auto& message : heard("advertiseServices")) {
    for (const auto& service : message.at("services")) {
      if (service.at("name") == name) id = service.at("id").get<std::uint32_t>();
    }
  }
  return id;
}

bool SocketClient::was_told(const std::string& text) const {
  for (const auto& message : heard("status")) {
    if (message.at("message").get<std::string>().find(text) != std::string::npos) return true;
  }
  return false;
}

HttpAnswer fetch(const ClientFacts& facts, const std::string& method) {
  asio::io_context io;
  beast::tcp_stream stream(io);
  stream.connect(endpoint_of(facts));
  http::request<http::string_body> request;
  request.method_string(method);
  request.target(facts.target);
  request.version(11);
  request.set(http::field::host, host_of(facts));
  for (const auto& [name, value] : facts.headers) request.set(name, value);
  http::write(stream, request);
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.skip(method == "HEAD");
  beast::error_code error;
  http::read(stream, buffer, parser, error);
  HttpAnswer answer;
  if (error) return answer;
  answer.status = static_cast<int>(parser.get().result_int());
  answer.body = parser.get().body();
  for (const auto& field : parser.get()) {
    answer.headers[std::string(field.name_string())] = std::string(field.value());
  }
  return answer;
}

std::string bytes_of(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i, value >>= 8U) bytes.push_back(static_cast<char>(value & 0xffU));
  return bytes;
}

}  // namespace tocsin
