// SPDX-License-Identifier: Apache-2.0
// Who may open the page and connect. Pure.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tocsin::foxglove {

/// What the server is set to.
struct AccessRules {
  std::string address;                    ///< IPv4 or IPv6 on which it listens
  std::string token = {};                 ///< empty: none is asked for
  bool encrypted = false;                 ///< TLS
  std::vector<std::string> origins = {};  ///< of other pages that may connect; "*": any
};

/// Whether an address is heard by this computer only.
[[nodiscard]] bool is_loopback(const std::string& address);

/// Throws ConfigError, with `owner` in front, when a server that listens beyond loopback would have
/// no token or no TLS, or when the token is too short to be one.
void check_access(const std::string& owner, const AccessRules& rules);

/// What a HTTP request says that matters here; empty is absent.
struct RequestFacts {
  std::string method;
  std::string target;  ///< `/index.html?token=...`
  std::string host;
  std::string origin;
  std::string authorization;
  std::string protocols;      ///< Sec-WebSocket-Protocol
  bool wants_socket = false;  ///< asks for an upgrade to WebSocket
};

struct OpenSocket {
  std::string protocol;  ///< the subprotocol, which the answer repeats
};
struct ServeFile {
  std::string path;  ///< below the folder of the page, relative: `index.html`
};
/// `reason` is the body of the answer: one line.
struct Refuse {
  unsigned status;
  std::string reason;
};
using Verdict = std::variant<OpenSocket, ServeFile, Refuse>;

/// Files of the page need no token: they are the same everywhere. A socket needs it, and must come
/// from our own page, from one of `origins`, or from a program that is no browser.
[[nodiscard]] Verdict judge(const AccessRules& rules, const RequestFacts& request);

/// `text/html; charset=utf-8` of `index.html`.
[[nodiscard]] const char* content_type(std::string_view path);

}  // namespace tocsin::foxglove
