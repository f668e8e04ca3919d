// SPDX-License-Identifier: Apache-2.0
// Who may open the page and connect. Pure.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "operator_server/user_role.hpp"

namespace tocsin::foxglove {

/// What the server is set to.
struct AccessRules {
  std::string address;                    ///< IPv4 or IPv6 on which it listens
  std::vector<AccessToken> tokens = {};   ///< empty: none is asked for
  bool encrypted = false;                 ///< TLS
  std::vector<std::string> origins = {};  ///< of other pages that may connect; "*": any
  UserRole role = UserRole::driver;       ///< of everybody, when there are no tokens
};

/// Whether an address is heard by this computer only.
[[nodiscard]] bool is_loopback(const std::string& address);

/// Throws ConfigError, with `owner` in front, when a server that listens beyond loopback would have
/// no token or no TLS.
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
  UserRole role = UserRole::driver;
};
struct ServeFile {
  std::string path;  ///< below the folder of the page, relative: `index.html`
};
/// The recordings of this computer, as JSON.
struct ListBags {};
struct ServeBag {
  std::string path;  ///< below the folder of the recordings, relative: `gcs/bag/bag_0.mcap`
};
/// What this host's recorder has written so far, for a page that is opened late.
struct ServeTable {
  std::string topic;  ///< of this host's recorder: `location`
};
/// What another policy would have decided, as JSON.
struct AskWhatIf {
  std::string query;  ///< what stands behind the question mark
};
/// `reason` is the body of the answer: one line.
struct Refuse {
  unsigned status;
  std::string reason;
};
using Verdict =
    std::variant<OpenSocket, ServeFile, ListBags, ServeBag, ServeTable, AskWhatIf, Refuse>;

/// Files of the page need no token: they are the same everywhere. A socket needs it, and so do
/// `/bags`, `/bags/PATH`, `/tables/NAME` and `/what_if`; each must come from our own page, from one
/// of `origins`, on loopback from a client as Foxglove and Lichtblick ship it, or from a program
/// that is no browser.
[[nodiscard]] Verdict judge(const AccessRules& rules, const RequestFacts& request);

/// Whether it is a relative path of plain characters without a part that begins with a point.
[[nodiscard]] bool is_file_name(std::string_view path);

/// The values of a query, `a=1&b=2`, by key, as they stand; of a key that is there twice the last.
[[nodiscard]] std::map<std::string, std::string> query_values(const std::string& query);

/// `text/html; charset=utf-8` of `index.html`.
[[nodiscard]] const char* content_type(std::string_view path);

}  // namespace tocsin::foxglove
