// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tocsin {

/// What a test client says of itself.
struct ClientFacts {
  int port = 0;
  std::string target = "/";
  std::string protocols = "foxglove.sdk.v1";
  std::map<std::string, std::string> headers = {};
  bool reads = true;  ///< false: it takes nothing off its socket
};

struct HttpAnswer {
  int status = 0;
  std::string body;
  std::map<std::string, std::string> headers;
};

struct BinaryFrame {
  int opcode = 0;
  std::uint32_t id = 0;  ///< subscription or service
  std::string bytes;     ///< all behind the opcode
};

/// A client on Boost.Beast with a thread of its own, which keeps all that comes.
class SocketClient {
 public:
  explicit SocketClient(const ClientFacts& facts);
  ~SocketClient();
  SocketClient(const SocketClient&) = delete;
  SocketClient& operator=(const SocketClient&) = delete;

  /// The socket is open.
  [[nodiscard]] bool is_open() const;
  /// It has ended, or was never opened, and why.
  [[nodiscard]] std::optional<std::string> ended() const;
  /// The status of the answer to the request for a socket; 101: it was opened.
  [[nodiscard]] int status() const;
  [[nodiscard]] std::string protocol() const;
  void say(const nlohmann::json& message) { say_text(message.dump()); }
  void say_text(const std::string& text);
  void say_bytes(const std::string& bytes);

  /// What came with this operation.
  [[nodiscard]] std::vector<nlohmann::json> heard(const std::string& op) const;
  [[nodiscard]] std::vector<BinaryFrame> frames(int opcode) const;
  /// The number of an advertised channel, or service.
  [[nodiscard]] std::optional<std::uint32_t> channel(const std::string& topic) const;
  [[nodiscard]] std::optional<std::uint32_t> service(const std::string& name) const;
  [[nodiscard]] bool was_told(const std::string& text) const;  ///< in a status

 private:
  struct Core;
  std::unique_ptr<Core> core_;
};

/// One request of HTTP, to its end; `headers` may have a method. Blocks.
[[nodiscard]] HttpAnswer fetch(const ClientFacts& facts, const std::string& method = "GET");

/// Numbers as they stand in frames.
[[nodiscard]] std::string bytes_of(std::uint32_t value);

}  // namespace tocsin
