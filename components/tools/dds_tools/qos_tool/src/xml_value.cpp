// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dialect.hpp"
#include "policy_values.hpp"

namespace tocsin::qos_tool {
namespace {

using tinyxml2::XMLElement;

constexpr double ns_in_s = 1e9;

template <class Char>
std::string mapped(std::string text, const Char& change) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [&](unsigned char c) { return static_cast<char>(change(c)); });
  return text;
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

XMLElement& make_at(XMLElement& base, const std::string& path) {
  const std::size_t slash = path.find('/');
  const std::string name = path.substr(0, slash);
  XMLElement* child = base.FirstChildElement(name.c_str());
  if (child == nullptr) child = base.InsertNewChildElement(name.c_str());
  return slash == std::string::npos ? *child : make_at(*child, path.substr(slash + 1));
}

}  // namespace tocsin::qos_tool
