// SPDX-License-Identifier: Apache-2.0
#include "live_change.hpp"

#include <algorithm>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "runtime/middleware/qos_change.hpp"

namespace tocsin::qos_tool {

std::string settings_map(const std::vector<std::string>& settings) {
  std::string text;
  for (const std::string& setting : settings) {
    const std::size_t at = setting.find('=');
    if (at == std::string::npos || at == 0) {
      throw ConfigError("'" + setting +
                        "' is not policy=value; what can change: " + joined(changeable_policies()));
    }
    const std::string value = setting.substr(at + 1);
    text += setting.substr(0, at) + ": " + (value == "inf" ? ".inf" : value) + "\n";
  }
  return text;
}

QosProfile announced_profile(const std::vector<End>& ends) {
  QosProfile profile;
  static_cast<QosContract&>(profile) = ends.front().qos;
  return profile;
}

std::vector<std::string> order_of(const std::vector<End>& writers, const std::string& settings) {
  const std::vector<std::string> writers_first{"writers", "readers"};
  if (writers.empty()) return writers_first;
  const double deadline_s = changed(announced_profile(writers), settings).deadline_s;
  const bool is_looser =
      std::any_of(writers.begin(), writers.end(),
                  [deadline_s](const End& writer) { return writer.qos.deadline_s < deadline_s; });
  return is_looser ? std::vector<std::string>{"readers", "writers"} : writers_first;
}

std::vector<Pair> stopped(const std::vector<Pair>& pairs) {
  std::vector<Pair> found;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(found),
               [](const Pair& pair) { return !pair.stopped_by().empty(); });
  return found;
}

}  // namespace tocsin::qos_tool
