// SPDX-License-Identifier: Apache-2.0
#include "simulation/sim_world.hpp"

#include <utility>

#include "world.hpp"

namespace tocsin::simulation {

SimWorld::SimWorld(deployment::Deployment deployment, const WorldOptions& options)
    : world_(std::make_unique<World>(std::move(deployment), options)) {}

SimWorld::~SimWorld() = default;

Outcome SimWorld::run(Duration limit) {
  World& all = *world_;
  const LogClock::Use use(all.log_clock);
  const Time begin = all.core.now;
  const Time end = limit > never - begin ? never : begin + limit;
  all.step(begin);
  for (Time next = all.next(); next <= end && !all.over(); next = all.next()) all.step(next);
  if (!all.over()) all.core.now = end;
  return all.outcome(begin);
}

}  // namespace tocsin::simulation
