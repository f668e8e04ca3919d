// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "dialect.hpp"
#include "policy_values.hpp"

namespace tocsin::qos_tool {
namespace {

using tinyxml2::XMLElement;

constexpr double ns_in_s = 1e9;

std::string trimmed(const char* text) {
  std::string result = text == nullptr ? "" : text;
  const auto blank = " \t\r\n";
  result.erase(0, result.find_first_not_of(blank));
  result.erase(result.find_last_not_of(blank) + 1);
  return result;
}

template <class Char>
std::string mapped(std::string text, const Char& change) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [&](unsigned char c) { return static_cast<char>(change(c)); });
  return text;
}

std::optional<std::string> read_word(const std::string& text, const std::string& suffix) {
  if (text.size() <= suffix.size()) return std::nullopt;
  const std::size_t length = text.size() - suffix.size();
  if (text.compare(length, suffix.size(), suffix) != 0) return std::nullopt;
  return mapped(text.substr(0, length), [](unsigned char c) { return std::tolower(c); });
}

std::optional<std::int64_t> read_integer(const std::string& text) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
}

/// Unlimited is 0 in a QoS file.
std::optional<std::string> read_number(const std::string& text) {
  if (text == "LENGTH_UNLIMITED" || text == "-1") return "0";
  const auto value = read_integer(text);
  return value ? std::optional(std::to_string(*value)) : std::nullopt;
}

bool is_infinite(const std::string& text) { return text.rfind("DURATION_INFINI", 0) == 0; }

std::optional<std::string> read_seconds(const XMLElement& leaf) {
  if (is_infinite(trimmed(leaf.GetText()))) return ".inf";
  double s = 0;
  bool said = false;
  for (const auto& [name, unit_s] : {std::pair("sec", 1.0), std::pair("nanosec", 1 / ns_in_s)}) {
    const XMLElement* const part = leaf.FirstChildElement(name);
    if (part == nullptr) continue;
    said = true;
    const std::string text = trimmed(part->GetText());
    if (is_infinite(text)) return ".inf";
    const auto value = read_integer(text);
    if (!value) return std::nullopt;
    s += static_cast<double>(*value) * unit_s;
  }
  return said ? std::optional(seconds_text(s)) : std::nullopt;
}

std::optional<std::string> read_flag(const std::string& text, bool opposite) {
  if (text != "true" && text != "1" && text != "false" && text != "0") return std::nullopt;
  const bool value = text == "true" || text == "1";
  return value != opposite ? "true" : "false";
}

std::string read_names(const XMLElement& leaf, const char* child) {
  std::vector<std::string> names;
  for (const auto* one = leaf.FirstChildElement(child); one != nullptr;
       one = one->NextSiblingElement(child)) {
    names.push_back(trimmed(one->GetText()));
  }
  return list_text(names);
}

std::optional<std::string> read_hex(const XMLElement& leaf) {
  const XMLElement* const value = leaf.FirstChildElement("value");
  if (value == nullptr) return std::nullopt;
  const std::string text = trimmed(value->GetText());
  std::string bytes;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('.', at), text.size());
    unsigned byte = 0;
    const auto result = std::from_chars(text.data() + at, text.data() + end, byte, 16);
    if (result.ec != std::errc() || result.ptr != text.data() + end || byte > 255) {
      return std::nullopt;
    }
    bytes += static_cast<char>(byte);
    at = end + 1;
  }
  return bytes;
}

void write_seconds(XMLElement& leaf, double s) {
  const bool infinite = std::isinf(s);
  const auto ns = infinite ? 0 : std::llround(s * ns_in_s);
  const auto part = [&](const char* name, const char* for_ever, std::int64_t value) {
    XMLElement& child = make_at(leaf, name);
    infinite ? child.SetText(for_ever) : child.SetText(value);
  };
  constexpr std::int64_t one_s = 1'000'000'000;
  part("sec", "DURATION_INFINITE_SEC", ns / one_s);
  part("nanosec", "DURATION_INFINITE_NSEC", ns % one_s);
}

void write_hex(XMLElement& leaf, const std::string& bytes) {
  std::string text;
  for (const char byte : bytes) {
    text += fmt::format("{}{:x}", text.empty() ? "" : ".", static_cast<unsigned char>(byte));
  }
  make_at(leaf, "value").SetText(text.c_str());
}

}  // namespace

std::optional<std::string> read_value(const XMLElement& leaf, const Place& place) {
  const std::string text = trimmed(leaf.GetText());
  switch (place.form) {
    case Form::word:
      return read_word(text, place.suffix);
    case Form::seconds:
      return read_seconds(leaf);
    case Form::number:
      return read_number(text);
    case Form::flag:
      return read_flag(text, false);
    case Form::not_flag:
      return read_flag(text, true);
    case Form::names:
      return read_names(leaf, place.suffix);
    case Form::hex:
      return read_hex(leaf);
  }
  return std::nullopt;
}

void write_value(XMLElement& leaf, const Place& place, const std::string& value) {
  switch (place.form) {
    case Form::word: {
      const std::string word = mapped(value, [](unsigned char c) { return std::toupper(c); });
      leaf.SetText((word + place.suffix).c_str());
      return;
    }
    case Form::seconds:
      return write_seconds(leaf, seconds_of(value));
    case Form::number:
    case Form::flag:
      return leaf.SetText(value.c_str());
    case Form::not_flag:
      return leaf.SetText(value == "true" ? "false" : "true");
    case Form::names:
      for (const std::string& name : names_of(value)) {
        XMLElement* const child = leaf.InsertNewChildElement(place.suffix);
        child->SetText(name.c_str());
      }
      return;
    case Form::hex:
      return write_hex(leaf, value);
  }
}

const XMLElement* find_at(const XMLElement& base, const std::string& path) {
  const std::size_t slash = path.find('/');
  const XMLElement* const child = base.FirstChildElement(path.substr(0, slash).c_str());
  if (child == nullptr || slash == std::string::npos) return child;
  return find_at(*child, path.substr(slash + 1));
}

XMLElement& make_at(XMLElement& base, const std::string& path) {
  const std::size_t slash = path.find('/');
  const std::string name = path.substr(0, slash);
  XMLElement* child = base.FirstChildElement(name.c_str());
  if (child == nullptr) child = base.InsertNewChildElement(name.c_str());
  return slash == std::string::npos ? *child : make_at(*child, path.substr(slash + 1));
}

}  // namespace tocsin::qos_tool
