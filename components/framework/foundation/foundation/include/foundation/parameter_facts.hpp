// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "foundation/parameters.hpp"

namespace tocsin {

using ParameterValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>,
                                    std::vector<std::string>>;

/// What is known of one parameter.
struct ParameterFacts {
  std::string name;
  ParameterValue value;
  std::string text;
  std::optional<Range> range = std::nullopt;
  std::vector<std::string> choices = {};
  /// Whether it can be changed while the component runs.
  bool live = false;
};

/// Collects the facts of a parameter struct by its `visit`.
class ParameterLister {
 public:
  void operator()(const char* name, const double& value, Range range, const char* text) {
    add({name, value, text, range});
  }
  void operator()(const char* name, const int& value, Range range, const char* text) {
    add({name, std::int64_t{value}, text, range});
  }
  void operator()(const char* name, const bool& value, const char* text) {
    add({name, value, text});
  }
  void operator()(const char* name, const std::string& value, const char* text) {
    add({name, value, text});
  }
  void operator()(const char* name, const std::string& value, Choices allowed, const char* text) {
    add({name, value, text, std::nullopt, {allowed.begin(), allowed.end()}});
  }
  void operator()(const char* name, const std::vector<double>& value, Range range,
                  const char* text) {
    add({name, value, text, range});
  }
  void operator()(const char* name, const std::vector<std::string>& value, const char* text) {
    add({name, value, text});
  }
  void mark_live() { next_is_live_ = true; }

  [[nodiscard]] const std::vector<ParameterFacts>& facts() const { return facts_; }

 private:
  void add(ParameterFacts facts) {
    facts.live = next_is_live_;
    next_is_live_ = false;
    facts_.push_back(std::move(facts));
  }
  std::vector<ParameterFacts> facts_;
  bool next_is_live_ = false;
};

template <class Params>
[[nodiscard]] std::vector<ParameterFacts> parameter_facts(Params params) {
  ParameterLister lister;
  params.visit(lister);
  return lister.facts();
}

}  // namespace tocsin
