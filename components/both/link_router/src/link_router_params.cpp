// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_router_params.hpp"

#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::router {

void check(const LinkRouterParams& params) {
  if (params.hold_backlog_s >= params.bulk_backlog_s) return;
  std::ostringstream text;
  text << "link_router.hold_backlog_s: " << params.hold_backlog_s << " is below bulk_backlog_s ("
       << params.bulk_backlog_s << ")";
  throw ConfigError(text.str());
}

}  // namespace tocsin::router
