// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "foundation/yaml_sources.hpp"

namespace tocsin {

/// Closed interval that a number must lie in. Infinity means unbounded on that side.
struct Range {
  double min;
  double max;
};

/// The words that a text parameter may be.
using Choices = std::initializer_list<const char*>;

/// Fills a parameter struct from YAML. Keys that are absent keep their defaults.
///
/// A parameter struct names each field once, in `visit`:
///
///     struct Params {
///       double lost_after_s = 1.0;
///       template <class Visitor>
///       void visit(Visitor& v) {
///         v("lost_after_s", lost_after_s, {0.05, 60}, "[s] longer silence is lost");
///       }
///     };
class ParameterLoader {
 public:
  /// `owner` is the name before the dot in error texts, `sources` tell the place they point to.
  /// A null or absent node means "all defaults". Throws ConfigError if `node` is not a map.
  ParameterLoader(const YAML::Node& node, std::string owner, YamlSources sources);
  ~ParameterLoader();
  ParameterLoader(const ParameterLoader&) = delete;
  ParameterLoader& operator=(const ParameterLoader&) = delete;

  /// Each throws ConfigError when the value has the wrong type or is not allowed (NaN never is).
  void operator()(const char* name, double& value, Range range, const char* text);
  void operator()(const char* name, int& value, Range range, const char* text);
  void operator()(const char* name, bool& value, const char* text);
  void operator()(const char* name, std::string& value, const char* text);
  void operator()(const char* name, std::string& value, Choices allowed, const char* text);
  void operator()(const char* name, std::vector<double>& value, Range range, const char* text);
  void operator()(const char* name, std::vector<std::string>& value, const char* text);

  /// Throws ConfigError when the YAML map has a key that no call has named.
  void reject_unknown_keys() const;

 private:
  struct State;
  [[noreturn]] void fail(const char* name, const std::string& what) const;
  std::unique_ptr<State> state_;
};

/// Prints each parameter as a commented YAML line: name, default, unit, range, text.
class ParameterPrinter {
 public:
  void operator()(const char* name, const double& value, Range range, const char* text);
  void operator()(const char* name, const int& value, Range range, const char* text);
  void operator()(const char* name, const bool& value, const char* text);
  void operator()(const char* name, const std::string& value, const char* text);
  void operator()(const char* name, const std::string& value, Choices allowed, const char* text);
  void operator()(const char* name, const std::vector<double>& value, Range range,
                  const char* text);
  void operator()(const char* name, const std::vector<std::string>& value, const char* text);

  /// The next one can be changed while the component runs.
  void mark_live() { next_is_live_ = true; }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void line(const char* name, const std::string& value, const std::string& allowed,
            const char* text);
  std::string text_;
  bool next_is_live_ = false;
};

template <class Visitor, class = void>
struct KnowsLive : std::false_type {};
template <class Visitor>
struct KnowsLive<Visitor, std::void_t<decltype(std::declval<Visitor&>().mark_live())>>
    : std::true_type {};

/// Says in `visit` that a parameter may be changed while the component runs:
///
///     live(v)("lost_after_s", lost_after_s, {0.05, 60}, "[s] longer silence is lost");
template <class Visitor>
Visitor& live(Visitor& visitor) {
  if constexpr (KnowsLive<Visitor>::value) visitor.mark_live();
  return visitor;
}

/// A parameter struct loaded from a YAML map; every wrong, unknown or out-of-range key throws
/// ConfigError, for example `link_monitor.lost_after_s: -1 is outside [0.05, 60] (a.yaml:3)`.
template <class Params>
[[nodiscard]] Params load_parameters(const YAML::Node& node, const std::string& owner,
                                     const YamlSources& sources) {
  Params params;
  ParameterLoader loader(node, owner, sources);
  params.visit(loader);
  loader.reject_unknown_keys();
  return params;
}

/// The defaults of a parameter struct as commented YAML, for `tocsin param dump` and READMEs.
template <class Params>
[[nodiscard]] std::string default_yaml() {
  Params params;
  ParameterPrinter printer;
  params.visit(printer);
  return printer.text();
}

/// `text`, an error about parameters that `load_parameters` took: behind it the place of the one
/// that it names or whose value it begins with, so that an error which only the component could
/// find points to its line, too. Unchanged when that is none of them.
[[nodiscard]] std::string with_place(const std::string& text, const YAML::Node& node,
                                     const YamlSources& sources);

}  // namespace tocsin
