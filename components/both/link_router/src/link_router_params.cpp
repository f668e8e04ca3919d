// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_router_params.hpp"

#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::router {
namespace {

struct Named {
  const char* name;
  double value;
};

void check_order(const Named& upper, const Named& lower) {
  if (upper.value >= lower.value) return;
  std::ostringstream text;
  text << "link_router." << upper.name << ": " << upper.value << " is below " << lower.name << " ("
       << lower.value << ")";
  throw ConfigError(text.str());
}

}  // namespace

void check(const LinkRouterParams& params) {
  check_order({"repair_max_s", params.repair_max_s}, {"repair_first_s", params.repair_first_s});
  check_order({"acknowledgement_idle_s", params.acknowledgement_idle_s},
              {"acknowledgement_period_s", params.acknowledgement_period_s});
  check_order({"hold_backlog_s", params.hold_backlog_s}, {"bulk_backlog_s", params.bulk_backlog_s});
}

}  // namespace tocsin::router
