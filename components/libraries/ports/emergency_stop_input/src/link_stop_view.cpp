// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/link_stop_view.hpp"

#include <utility>

namespace tocsin {

bool LinkStopView::on_message(Values values, Time now) {
  const bool is_released = received_ && values.releases > values_.releases;
  values_ = std::move(values);
  last_ = now;
  received_ = true;
  return is_released;
}

void LinkStopView::restore(const Memory& memory, Time now) {
  if (memory.stands) {
    values_.stands = true;
    values_.stopped_by = {kept_name};
  }
  if (memory.expects) last_ = now;
}

bool LinkStopView::stands(Time now) const { return values_.stands || is_silent(now); }

std::vector<std::string> LinkStopView::stopped_by(Time now) const {
  std::vector<std::string> names;
  if (values_.stands) {
    names = values_.stopped_by;
    if (names.empty()) names.emplace_back("link");
  }
  if (is_silent(now)) names.emplace_back(silent_name);
  return names;
}

Time LinkStopView::deadline(Time now) const {
  return last_ && !is_silent(now) ? *last_ + silent_after : never;
}

}  // namespace tocsin
