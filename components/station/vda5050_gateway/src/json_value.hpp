// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tocsin::vda5050 {

/// A message that is not as the standard has it; the text names the field.
struct Malformed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A value of a message of others with its place in it. What it is not throws Malformed.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string place)
      : value_(value), place_(std::move(place)) {}

  [[nodiscard]] std::optional<JsonValue> find(const std::string& key) const;
  [[nodiscard]] JsonValue at(const std::string& key) const;
  [[nodiscard]] std::vector<JsonValue> items() const;  ///< at most `most_items`
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] const std::string& identifier() const;  ///< neither empty nor long
  [[nodiscard]] double number() const;
  [[nodiscard]] double number_within(double low, double high) const;
  [[nodiscard]] bool flag() const;
  [[nodiscard]] std::uint32_t count() const;
  [[nodiscard]] const nlohmann::json& json() const { return value_; }
  [[nodiscard]] const std::string& place() const { return place_; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  static constexpr std::size_t most_items = 4096;
  const nlohmann::json& value_;
  std::string place_;
};

}  // namespace tocsin::vda5050
