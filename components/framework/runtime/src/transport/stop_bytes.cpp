// SPDX-License-Identifier: Apache-2.0
#include "transport/stop_bytes.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

constexpr std::array<std::uint8_t, 3> layout_mark{'T', 'S', 1};  // 1: version of this layout
constexpr std::uint8_t stands_bit = 1;
constexpr std::uint8_t known_bit = 2;
constexpr std::uint8_t site_bit = 4;  // a name follows

void put(std::vector<std::uint8_t>& bytes, std::uint64_t number) {
  bytes.resize(bytes.size() + sizeof number);
  put_number(bytes.data() + bytes.size() - sizeof number, number, true);
}

void put(std::vector<std::uint8_t>& bytes, const std::string& name) {
  const std::size_t length = std::min(name.size(), StopValue::longest_name);
  bytes.push_back(static_cast<std::uint8_t>(length));
  bytes.insert(bytes.end(), name.begin(), name.begin() + static_cast<std::ptrdiff_t>(length));
}

void put(std::vector<std::uint8_t>& bytes, const std::vector<StopToken>& tokens) {
  const std::size_t count = std::min(tokens.size(), StopValue::most_tokens);
  bytes.push_back(static_cast<std::uint8_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    bytes.insert(bytes.end(), tokens[i].begin(), tokens[i].end());
  }
}

/// Reads on as long as there are bytes; `good()` tells whether all of it was there.
class Reader {
 public:
  Reader(const std::uint8_t* bytes, std::size_t size) : begin_(bytes), at_(bytes), left_(size) {}

  std::uint8_t byte() {
    const std::uint8_t* const one = take(1);
    return one == nullptr ? 0 : *one;
  }
  std::uint64_t number() {
    const std::uint8_t* const bytes = take(sizeof(std::uint64_t));
    return bytes == nullptr ? 0 : number_at<std::uint64_t>(bytes, true);
  }
  std::string name() {
    const std::size_t length = byte();
    if (length > StopValue::longest_name) good_ = false;
    const std::uint8_t* const bytes = take(length);
    return bytes == nullptr ? "" : std::string(bytes, bytes + length);
  }
  std::vector<StopToken> tokens() {
    std::vector<StopToken> all(count(StopValue::most_tokens));
    for (StopToken& one : all) {
      if (const auto* const bytes = take(one.size())) std::copy_n(bytes, one.size(), one.begin());
    }
    return all;
  }
  std::vector<std::string> names() {
    std::vector<std::string> all(count(StopValue::most_names));
    for (std::string& one : all) one = name();
    return all;
  }
  [[nodiscard]] bool good() const { return good_; }
  [[nodiscard]] std::size_t read() const { return static_cast<std::size_t>(at_ - begin_); }

 private:
  std::size_t count(std::size_t most) {
    const std::size_t said = byte();
    if (said > most) good_ = false;
    return std::min(said, most);
  }
  const std::uint8_t* take(std::size_t bytes) {
    if (!good_ || bytes > left_) {
      good_ = false;
      return nullptr;
    }
    const std::uint8_t* const here = at_;
    at_ += bytes;
    left_ -= bytes;
    return here;
  }
  const std::uint8_t* begin_;
  const std::uint8_t* at_;
  std::size_t left_;
  bool good_ = true;
};

}  // namespace

std::vector<std::uint8_t> to_bytes(const StopValue& value) {
  std::vector<std::uint8_t> bytes(layout_mark.begin(), layout_mark.end());
  bytes.push_back(static_cast<std::uint8_t>((value.stands ? stands_bit : 0) |
                                            (value.known ? known_bit : 0) |
                                            (value.site.empty() ? 0 : site_bit)));
  bytes.push_back(static_cast<std::uint8_t>(value.role));
  put(bytes, value.instance);
  put(bytes, value.number);
  put(bytes, static_cast<std::uint64_t>(value.since_wall_ns));
  put(bytes, value.locks);
  put(bytes, value.keys);
  put(bytes, value.host);
  const std::size_t names = std::min(value.by.size(), StopValue::most_names);
  bytes.push_back(static_cast<std::uint8_t>(names));
  for (std::size_t i = 0; i < names; ++i) put(bytes, value.by[i]);
  if (!value.site.empty()) put(bytes, value.site);
  return bytes;
}

std::optional<std::pair<StopValue, std::size_t>> stop_value_in(const std::uint8_t* bytes,
                                                               std::size_t size) {
  Reader reader(bytes, size);
  for (const std::uint8_t expected : layout_mark) {
    if (reader.byte() != expected) return std::nullopt;
  }
  StopValue value;
  const std::uint8_t flags = reader.byte();
  value.stands = (flags & stands_bit) != 0;
  value.known = (flags & known_bit) != 0;
  const std::uint8_t role = reader.byte();
  if (role >= roles.size()) return std::nullopt;
  value.role = static_cast<Role>(role);
  value.instance = reader.number();
  value.number = reader.number();
  value.since_wall_ns = static_cast<std::int64_t>(reader.number());
  value.locks = reader.tokens();
  value.keys = reader.tokens();
  value.host = reader.name();
  value.by = reader.names();
  if ((flags & site_bit) != 0) value.site = reader.name();
  if (!reader.good()) return std::nullopt;
  return std::pair(std::move(value), reader.read());
}

}  // namespace tocsin
