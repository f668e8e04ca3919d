// SPDX-License-Identifier: Apache-2.0
#include "stop_keys_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace tocsin {
namespace {

constexpr const char* digits = "0123456789abcdef";

std::string hex_of(const StopToken& token) {
  std::string text;
  for (const std::uint8_t byte : token) text += {digits[byte >> 4U], digits[byte & 15U]};
  return text;
}

std::optional<StopToken> token_in(const std::string& hex) {
  StopToken token{};
  if (hex.size() != 2 * token.size()) return std::nullopt;
  for (std::size_t i = 0; i < hex.size(); ++i) {
    const std::size_t digit = std::string(digits).find(hex[i]);
    if (digit == std::string::npos) return std::nullopt;
    token[i / 2] = static_cast<std::uint8_t>(unsigned{token[i / 2]} << 4U | digit);
  }
  return token;
}

std::string text_of(const StopKeysFile::Content& content) {
  std::ostringstream text;
  text << ::getppid() << ' ' << content.stands << ' ' << content.others;
  const std::size_t all = content.tokens.size();
  for (std::size_t i = all - std::min(all, StopKeysFile::most_tokens); i < all; ++i) {
    text << ' ' << hex_of(content.tokens[i].token) << ' ' << content.tokens[i].flag;
  }
  return text.str();
}

}  // namespace

StopKeysFile::Content StopKeysFile::load() const {
  std::istringstream text(file_.load().value_or(""));
  pid_t parent = 0;
  Content content;
  if (!(text >> parent >> content.stands >> content.others)) return {};
  if (parent != ::getppid()) content.stands = content.others = false;
  std::string hex;
  for (bool flag = false; text >> hex >> flag;) {
    if (const auto token = token_in(hex)) content.tokens.push_back({*token, flag});
  }
  return content;
}

bool StopKeysFile::save(const Content& content) {
  if (!file_.keeps() || saved_ == content) return true;
  const bool had_failed = std::exchange(failed_, !file_.save(text_of(content)));
  if (!failed_) saved_ = content;
  return !failed_ || had_failed;
}

}  // namespace tocsin
