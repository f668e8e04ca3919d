// SPDX-License-Identifier: Apache-2.0
#include "control.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"

namespace tocsin::link {
namespace {

std::optional<double> finite_number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

Command parse_set(const std::string& key, const std::string& value) {
  if (key != "outage") return SetParameter{key, value};
  const auto length_s = finite_number(value);
  if (!length_s || *length_s <= 0 || *length_s > 86400) return std::monostate{};
  return BeginOutage{*length_s};
}

/// Visits the parameters and replaces the one that is named.
class Setter {
 public:
  explicit Setter(const SetParameter& command) : command_(command) {}
  [[nodiscard]] bool done() const { return done_; }

  void operator()(const char* name, double& value, Range range, const char*) {
    const auto wanted = number(name, range);
    if (wanted) value = *wanted;
  }
  void operator()(const char* name, int& value, Range range, const char*) {
    const auto wanted = number(name, range);
    if (!wanted) return;
    done_ = *wanted == std::floor(*wanted);
    if (done_) value = static_cast<int>(*wanted);
  }
  void operator()(const char* name, std::string& value, Choices allowed, const char*) {
    if (command_.key != name) return;
    for (const char* word : allowed) done_ = done_ || command_.value == word;
    if (done_) value = command_.value;
  }
  void operator()(const char*, std::vector<double>&, Range, const char*) {}
  void operator()(const char* name, bool& value, const char*) {
    if (command_.key != name) return;
    done_ = command_.value == "true" || command_.value == "false";
    if (done_) value = command_.value == "true";
  }
  void operator()(const char*, std::string&, const char*) {}  // a file is read at start only

 private:
  std::optional<double> number(const char* name, Range range) {
    if (command_.key != name) return std::nullopt;
    const auto value = finite_number(command_.value);
    if (!value || *value < range.min || *value > range.max) return std::nullopt;
    done_ = true;
    return value;
  }

  const SetParameter& command_;
  bool done_ = false;
};

}  // namespace

Command parse_command(const std::string& datagram) {
  const auto words = words_of(datagram);
  if (words.size() != 3) return std::monostate{};
  if (words[0] == "set") return parse_set(words[1], words[2]);
  const auto x_m = finite_number(words[1]);
  const auto y_m = finite_number(words[2]);
  if (words[0] != "pos" || !x_m || !y_m) return std::monostate{};
  return MoveTo{*x_m, *y_m};
}

bool set_parameter(radio::ChannelParams& params, const SetParameter& command) {
  Setter setter(command);
  params.visit(setter);
  return setter.done();
}

}  // namespace tocsin::link
