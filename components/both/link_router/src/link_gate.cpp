// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_gate.hpp"

namespace tocsin::router {

std::optional<Waiting> LinkGate::hold(WhilePaused rule, const Waiting& waiting) {
  if (rule == WhilePaused::drop) return waiting;
  const auto [place, is_new] =
      held_.try_emplace({waiting.stream, waiting.sample.origin.source}, waiting);
  if (is_new) return std::nullopt;
  return std::exchange(place->second, waiting);
}

std::vector<Waiting> LinkGate::take_stream(StreamId stream) {
  std::vector<Waiting> taken;
  auto it = held_.lower_bound({stream, 0});
  while (it != held_.end() && it->first.first == stream) {
    taken.push_back(std::move(it->second));
    it = held_.erase(it);
  }
  return taken;
}

LinkGate::Held LinkGate::held(StreamId stream) const {
  Held held;
  for (auto it = held_.lower_bound({stream, 0}); it != held_.end() && it->first.first == stream;
       ++it) {
    ++held.samples;
    held.bytes += it->second.sample.bytes;
  }
  return held;
}

}  // namespace tocsin::router
