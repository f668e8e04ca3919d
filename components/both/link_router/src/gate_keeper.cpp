// SPDX-License-Identifier: Apache-2.0
#include "link_router/gate_keeper.hpp"

namespace tocsin::router {

void GateKeeper::on_state(bool active, Time now) {
  active_ = active;
  received_ = now;
}

bool GateKeeper::open(Time now) const { return active_ || now - received_ > silence_limit; }

Time GateKeeper::deadline(Time now) const {
  return open(now) ? never : received_ + silence_limit + Duration{1};
}

}  // namespace tocsin::router
