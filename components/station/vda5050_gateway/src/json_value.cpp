// SPDX-License-Identifier: Apache-2.0
#include "json_value.hpp"

#include <cmath>

#include "foundation/printable.hpp"
#include "vda5050_gateway/order.hpp"

namespace tocsin::vda5050 {

void JsonValue::fail(const std::string& what) const {
  throw Malformed((place_.empty() ? "the message" : place_) + " " + what);
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
  if (!value_.is_object()) fail("is not an object");
  const auto found = value_.find(key);
  if (found == value_.end()) return std::nullopt;
  return JsonValue(*found, place_.empty() ? key : place_ + "." + key);
}

JsonValue JsonValue::at(const std::string& key) const {
  if (auto found = find(key)) return *found;
  throw Malformed((place_.empty() ? key : place_ + "." + key) + " is missing");
}

std::vector<JsonValue> JsonValue::items() const {
  if (!value_.is_array()) fail("is not an array");
  if (value_.size() > most_items) {
    fail("has " + std::to_string(value_.size()) + " items, more than " +
         std::to_string(most_items));
  }
  std::vector<JsonValue> items;
  for (const auto& item : value_) {
    items.emplace_back(item, place_ + "[" + std::to_string(items.size()) + "]");
  }
  return items;
}

const std::string& JsonValue::text() const {
  if (!value_.is_string()) fail("is not a string");
  return value_.get_ref<const std::string&>();
}

const std::string& JsonValue::identifier() const {
  const std::string& name = text();
  if (name.empty()) fail("is empty");
  if (name.size() > most_id_bytes) {
    fail("has " + std::to_string(name.size()) + " bytes, more than " +
         std::to_string(most_id_bytes));
  }
  return name;
}

double JsonValue::number() const {
  if (!value_.is_number()) fail("is not a number");
  const auto number = value_.get<double>();
  if (!std::isfinite(number)) fail("is not finite");
  return number;
}

double JsonValue::number_within(double low, double high) const {
  const double value = number();
  if (value < low || value > high) {
    fail("is " + shortest_text(value) + ", outside [" + shortest_text(low) + ", " +
         shortest_text(high) + "]");
  }
  return value;
}

bool JsonValue::flag() const {
  if (!value_.is_boolean()) fail("is not true or false");
  return value_.get<bool>();
}

std::uint32_t JsonValue::count() const {
  if (!value_.is_number_unsigned()) fail("is not a whole number from 0");
  const auto count = value_.get<std::uint64_t>();
  if (count > UINT32_MAX) fail("is " + std::to_string(count) + ", more than 4294967295");
  return static_cast<std::uint32_t>(count);
}

}  // namespace tocsin::vda5050
