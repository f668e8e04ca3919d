// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/outages.hpp"

#include <algorithm>
#include <string>

#include "foundation/error.hpp"

namespace tocsin::radio {

Outages::Outages(const std::vector<double>& script_s, Time start) {
  const std::string name = "radio_channel.outages_s: ";
  if (script_s.size() % 2 != 0) {
    throw ConfigError(name + std::to_string(script_s.size()) +
                      " numbers are not pairs of begin and length");
  }
  double free_from_s = 0;
  for (std::size_t i = 0; i < script_s.size(); i += 2) {
    if (script_s[i] < free_from_s) {
      throw ConfigError(name + "begin " + std::to_string(script_s[i]) +
                        " must not be before the end of the interval before it, " +
                        std::to_string(free_from_s));
    }
    free_from_s = script_s[i] + script_s[i + 1];
    script_.push_back({start + seconds(script_s[i]), start + seconds(free_from_s)});
  }
}

void Outages::begin(Time now, Duration length) {
  if (now >= manual_.until) manual_ = {now, now + length};
  manual_.until = std::max(manual_.until, now + length);
}

}  // namespace tocsin::radio
