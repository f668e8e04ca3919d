// SPDX-License-Identifier: Apache-2.0
#include "operator_server/user_role.hpp"

#include <algorithm>
#include <sstream>

#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::foxglove {
namespace {

constexpr std::size_t shortest_token = 16;

/// Of one line; what is wrong with it in `fault`.
AccessToken token_of_line(std::istringstream words, UserRole usual, std::string& fault) {
  AccessToken token{"", usual};
  std::string more;
  words >> token.token;
  if (std::string second; words >> second) {
    const auto role = value_of<UserRole>(token.token);
    if (!role) {
      fault = "'" + printable(token.token, 20) +
              "' is not one of: observer, operator, supervisor; a line is ROLE TOKEN or TOKEN";
      return token;
    }
    token = {second, *role};
  }
  if (words >> more) fault = "more than a role and a token";
  if (token.token.size() < shortest_token) {
    fault = "a token of " + std::to_string(token.token.size()) +
            " characters is too short; at least " + std::to_string(shortest_token);
  }
  return token;
}

}  // namespace

std::vector<AccessToken> parse_tokens(const std::string& file, const std::string& text,
                                      UserRole usual) {
  std::vector<AccessToken> tokens;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos || line[begin] == '#') continue;
    std::string fault;
    const AccessToken token = token_of_line(std::istringstream(line), usual, fault);
    const bool is_known =
        std::any_of(tokens.begin(), tokens.end(),
                    [&token](const AccessToken& one) { return one.token == token.token; });
    if (fault.empty() && is_known) fault = "this token is there already";
    if (!fault.empty()) throw ConfigError(file + ":" + std::to_string(number) + ": " + fault);
    tokens.push_back(token);
  }
  if (tokens.empty()) throw ConfigError(file + ": has no token");
  return tokens;
}

}  // namespace tocsin::foxglove
