// SPDX-License-Identifier: Apache-2.0
#include "map_ports/link_risk_input.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include "geometry/pose_message.hpp"

namespace tocsin {
namespace {

/// Whether its cells are a grid with at least one cell, whose rows are not turned.
bool is_grid(const topic::LinkRisk::Message& message) {
  constexpr std::uint32_t most_cells = 4'000'000;
  const auto& info = message.info();
  const geometry::Pose origin = geometry::pose_in(info.origin());
  const auto cells = std::uint64_t{info.width()} * info.height();
  return cells > 0 && cells <= most_cells && cells == message.data().size() &&
         info.resolution() > 0.001F && info.resolution() < 1000 && std::abs(origin.x_m) < 1e6 &&
         std::abs(origin.y_m) < 1e6 && std::abs(origin.heading_rad) <= 1e-3;
}

}  // namespace

LinkRiskInput::LinkRiskInput(Component& owner)
    : risk_(owner, WakeMode::time_triggered), log_(owner.name(), owner.node()) {}

std::optional<navigation::LinkRisk> LinkRiskInput::take() {
  auto message = risk_.take_latest();
  if (!message) return std::nullopt;
  const auto& info = message->info();
  if (!is_grid(*message)) {
    log_.warn("link_risk is ignored: {} cells of {} m, {} x {}", message->data().size(),
              info.resolution(), info.width(), info.height());
    return std::nullopt;
  }
  const navigation::Grid grid{static_cast<int>(info.width()), static_cast<int>(info.height()),
                              info.resolution(), position(geometry::pose_in(info.origin()))};
  return navigation::LinkRisk(grid, message->data());
}

}  // namespace tocsin
