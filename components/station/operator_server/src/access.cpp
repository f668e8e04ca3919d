// SPDX-License-Identifier: Apache-2.0
#include "operator_server/access.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::foxglove {
namespace {

/// `localhost` of `localhost:8765`, `[::1]` of `[::1]:8765`.
std::string host_without_port(const std::string& host) {
  const std::size_t bracket = host.rfind(']');
  const std::size_t colon = host.rfind(':');
  const bool has_port =
      colon != std::string::npos && (bracket == std::string::npos || colon > bracket);
  return has_port ? host.substr(0, colon) : host;
}

bool names_this_computer(const std::string& host) {
  std::string name = host_without_port(host);
  if (name == "localhost") return true;
  if (name.size() > 2 && name.front() == '[') name = name.substr(1, name.size() - 2);
  return is_loopback(name);
}

/// Takes as long wherever the two differ.
bool same_secret(const std::string& one, const std::string& other) {
  unsigned difference = one.size() == other.size() ? 0 : 1;
  for (std::size_t i = 0; i < one.size() && i < other.size(); ++i) {
    difference |= static_cast<unsigned char>(one[i]) ^ static_cast<unsigned char>(other[i]);
  }
  return difference == 0;
}

/// What stands behind the question mark of `/?token=abc&x=1`.
std::string query_of(const std::string& target) {
  const std::size_t mark = target.find('?');
  return mark == std::string::npos ? std::string() : target.substr(mark + 1);
}

std::string token_of(const RequestFacts& request) {
  const std::string bearer = "Bearer ";
  if (request.authorization.rfind(bearer, 0) == 0) {
    return request.authorization.substr(bearer.size());
  }
  const auto values = query_values(query_of(request.target));
  const auto token = values.find("token");
  return token == values.end() ? std::string() : token->second;
}

/// The one that both ends know, the newer name before the older one; they mean the same.
std::optional<std::string> choose_protocol(const std::string& offered) {
  for (const char* known : {"foxglove.sdk.v1", "foxglove.websocket.v1"}) {
    for (std::size_t begin = 0; begin <= offered.size();) {
      const std::size_t end = std::min(offered.find(',', begin), offered.size());
      std::string word = offered.substr(begin, end - begin);
      word.erase(0, word.find_first_not_of(' '));
      word.erase(word.find_last_not_of(' ') + 1);
      if (word == known) return word;
      begin = end + 1;
    }
  }
  return std::nullopt;
}

/// Whether the page that connects is our own. Without a token only a page that was reached under a
/// name of this computer is: another name may have been made to lead here (DNS rebinding).
bool is_own_page(const AccessRules& rules, const RequestFacts& request) {
  if (rules.tokens.empty() && !names_this_computer(request.host)) return false;
  const std::string own = (rules.encrypted ? "https://" : "http://") + request.host;
  return request.origin.empty() || request.origin == own;
}

/// Desktop clients, and the pages that their vendors serve; a page of the web cannot claim one of
/// these. "null" is none of them: any page gets it by a frame that it seals off.
bool is_known_client(const AccessRules& rules, const std::string& origin) {
  constexpr std::array<const char*, 5> known{
      "file://", "app://foxglove", "https://app.foxglove.dev", "https://studio.foxglove.dev",
      "http://localhost:8080"};  // Lichtblick's container
  return is_loopback(rules.address) && std::find(known.begin(), known.end(), origin) != known.end();
}

/// None: its token is missing or wrong. Compares it with all of them, whichever it is.
std::optional<UserRole> role_of_token(const AccessRules& rules, const RequestFacts& request) {
  if (rules.tokens.empty()) return rules.role;
  const std::string given = token_of(request);
  std::optional<UserRole> role;
  for (const AccessToken& one : rules.tokens) {
    if (same_secret(one.token, given)) role = one.role;
  }
  return role;
}

/// Who asks for what is not the same everywhere, or why that is refused.
std::variant<UserRole, Refuse> asker_of(const AccessRules& rules, const RequestFacts& request) {
  const bool is_named =
      std::any_of(rules.origins.begin(), rules.origins.end(), [&](const std::string& origin) {
        return origin == "*" || (!request.origin.empty() && origin == request.origin);
      });
  if (!is_named && !is_own_page(rules, request) && !is_known_client(rules, request.origin)) {
    const std::string whose = printable(request.origin.empty() ? request.host : request.origin);
    return Refuse{403, "a page of '" + whose +
                           "' may not connect here; operator_server.origins: [" + whose +
                           "] lets it in"};
  }
  if (const auto role = role_of_token(rules, request)) return *role;
  return Refuse{401, "the token is missing or wrong: give it as ?token=... or as Bearer"};
}

Verdict judge_socket(const AccessRules& rules, const RequestFacts& request) {
  const auto asker = asker_of(rules, request);
  if (const auto* const refusal = std::get_if<Refuse>(&asker)) return *refusal;
  const auto protocol = choose_protocol(request.protocols);
  if (!protocol) {
    return Refuse{400, "subprotocol '" + printable(request.protocols) +
                           "' is not one of: foxglove.sdk.v1, foxglove.websocket.v1"};
  }
  return OpenSocket{*protocol, std::get<UserRole>(asker)};
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '-' || c == '/';
}

/// The topics that a page draws the trail from.
constexpr std::array<const char*, 2> tables{"location", "transmission_state"};

/// A request for what only this run has; none: it is for a file of the page.
std::optional<Verdict> verdict_of_run(const std::string& path, const RequestFacts& request) {
  const std::string folder = "bags/";
  if (path == "bags") return ListBags{};
  if (path == "what_if") return AskWhatIf{query_of(request.target)};
  const std::string table_folder = "tables/";
  if (path.rfind(table_folder, 0) == 0) {
    for (const std::string topic : tables) {
      if (path == table_folder + topic + ".csv") return ServeTable{topic};
    }
    return Refuse{404, "there is no such table"};
  }
  if (path.rfind(folder, 0) != 0) return std::nullopt;
  const std::string file = path.substr(folder.size());
  if (!is_file_name(file)) return Refuse{404, "there is no such recording"};
  return ServeBag{file};
}

}  // namespace

bool is_file_name(std::string_view path) {
  return std::all_of(path.begin(), path.end(), is_plain) &&
         path.find("//") == std::string_view::npos && path.find("/.") == std::string_view::npos &&
         !path.empty() && path.front() != '.' && path.front() != '/';
}

std::map<std::string, std::string> query_values(const std::string& query) {
  std::map<std::string, std::string> values;
  for (std::size_t begin = 0; begin < query.size();) {
    const std::size_t end = std::min(query.find('&', begin), query.size());
    const std::string pair = query.substr(begin, end - begin);
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const std::size_t value = std::min(equals + 1, pair.size());
    if (equals > 0) values[pair.substr(0, equals)] = pair.substr(value);
    begin = end + 1;
  }
  return values;
}

bool is_loopback(const std::string& address) {
  in_addr four{};
  if (::inet_pton(AF_INET, address.c_str(), &four) == 1) {
    return (ntohl(four.s_addr) >> 24U) == 127;
  }
  in6_addr six{};
  return ::inet_pton(AF_INET6, address.c_str(), &six) == 1 && IN6_IS_ADDR_LOOPBACK(&six);
}

void check_access(const std::string& owner, const AccessRules& rules) {
  if (is_loopback(rules.address) || (!rules.tokens.empty() && rules.encrypted)) return;
  throw ConfigError(owner + ".address: " + rules.address +
                    " is heard beyond this computer, which needs token_file, certificate and key; "
                    "without them only 127.0.0.1");
}

Verdict judge(const AccessRules& rules, const RequestFacts& request) {
  if (request.wants_socket) return judge_socket(rules, request);
  if (request.method != "GET" && request.method != "HEAD") {
    return Refuse{405, "method " + printable(request.method, 20) + " is not one of: GET, HEAD"};
  }
  if (request.target.empty() || request.target.front() != '/') {
    return Refuse{400, "the target does not begin with /"};
  }
  std::string path = request.target.substr(1, request.target.find('?') - 1);
  if (const auto verdict = verdict_of_run(path, request)) {
    const auto asker = asker_of(rules, request);
    const auto* const refusal = std::get_if<Refuse>(&asker);
    return refusal == nullptr ? *verdict : *refusal;
  }
  if (path.empty() || path.back() == '/') path += "index.html";
  if (!is_file_name(path)) return Refuse{404, "there is no such file"};
  return ServeFile{path};
}

const char* content_type(std::string_view path) {
  static const std::map<std::string_view, const char*> types{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".map", "application/json"},
      {".webmanifest", "application/manifest+json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
      {".txt", "text/plain; charset=utf-8"},
      {".wasm", "application/wasm"}};
  const std::size_t dot = path.rfind('.');
  const auto found = dot == std::string_view::npos ? types.end() : types.find(path.substr(dot));
  return found == types.end() ? "application/octet-stream" : found->second;
}

}  // namespace tocsin::foxglove
