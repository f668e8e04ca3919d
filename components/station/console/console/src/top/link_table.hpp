// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "terminal/line.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin::top {

/// The last that the routers of the link told, by the role of their host. Pure.
class LinkTable {
 public:
  /// What another router told is forgotten when it is ten minutes old.
  void add(const tocsin_msgs::msg::LinkState& state, Time now);
  /// A line for each way, by name; grey with its age when it is not fresh (FreshnessLimits), and
  /// only the age when it is unknown.
  [[nodiscard]] std::vector<terminal::Line> lines(Time now) const;
  /// What each class of the ways that are fresh has carried: a table, at most `width` columns wide;
  /// empty when none is.
  [[nodiscard]] std::vector<terminal::Line> classes(Time now, std::size_t width) const;

 private:
  struct Entry {
    tocsin_msgs::msg::LinkState state;
    Time at;
  };
  std::map<std::string, Entry> entries_;
};

}  // namespace tocsin::top
