// SPDX-License-Identifier: Apache-2.0
#include "link/peer_instances.hpp"

#include <algorithm>
#include <utility>

namespace tocsin {
namespace {

constexpr int usual_gaps = 4;
constexpr int gap_share = 8;  ///< weight of a new gap is one of so many

}  // namespace

PeerInstances::Change PeerInstances::on_announced(Id id, const std::string& name, Time) {
  const bool is_new = instances_.try_emplace(id, Instance{name, ++announced_}).second;
  if (!is_new || current_.count(name) != 0 || absent_.count(name) != 0) return {};
  current_[name] = id;
  return {id, {}};
}

PeerInstances::Change PeerInstances::on_departed(Id id, Time now) {
  const auto found = instances_.find(id);
  if (found == instances_.end()) return {};
  const std::string name = found->second.name;
  instances_.erase(found);
  const auto current = current_.find(name);
  if (current == current_.end() || current->second != id) return {};
  current_.erase(current);
  Change change{{}, id};
  Time latest = now - silence_for_the_refuted;
  for (auto& [other, instance] : instances_) {
    if (instance.name != name || !instance.heard || *instance.heard < latest) continue;
    latest = *instance.heard;
    change.joined = other;
  }
  if (change.joined) current_[name] = *change.joined;
  return change;
}

PeerInstances::Change PeerInstances::on_received(Id id, Time now) {
  const auto found = instances_.find(id);
  if (found == instances_.end()) return {};
  Instance& instance = found->second;
  hear(instance, now);
  if (absent_.count(instance.name) != 0) return {};
  const auto current = current_.find(instance.name);
  if (current == current_.end()) {
    current_[instance.name] = id;
    return {id, {}};
  }
  if (current->second == id) return {};
  if (!may_take_over(instance, instances_.at(current->second), now)) return {};
  return replace(current->second, id, now);
}

void PeerInstances::hear(Instance& instance, Time now) {
  if (instance.heard) instance.gap += (now - *instance.heard - instance.gap) / gap_share;
  instance.heard = now;
  if (instance.displaced && !instance.returned) instance.returned = now;
}

bool PeerInstances::may_take_over(Instance& candidate, const Instance& current, Time now) {
  if (!current.heard) return true;
  if (candidate.returned && now - *candidate.returned >= returned_for) return true;
  const Duration silence = candidate.refuted
                               ? silence_for_the_refuted
                               : std::clamp(usual_gaps * current.gap, least_silence, most_silence);
  return now - *current.heard >= silence;
}

PeerInstances::Change PeerInstances::replace(Id current, Id by, Time now) {
  Instance& former = instances_.at(current);
  Instance& next = instances_.at(by);
  former.refuted = next.displaced.has_value();
  former.displaced = former.refuted ? std::nullopt : std::optional(now);
  former.returned.reset();
  next.displaced.reset();
  next.returned.reset();
  current_[next.name] = by;
  return {by, current};
}

std::optional<PeerInstances::Id> PeerInstances::last_of(const std::string& name) const {
  std::optional<Id> last;
  for (const auto& [id, instance] : instances_) {
    if (instance.name != name) continue;
    if (!last || instances_.at(*last).order < instance.order) last = id;
  }
  return last;
}

std::vector<PeerInstances::Change> PeerInstances::set_absent(const std::set<std::string>& names) {
  std::vector<Change> changes;
  for (const std::string& name : names) {
    const auto current = current_.find(name);
    if (current == current_.end()) continue;
    instances_.at(current->second).heard.reset();
    changes.push_back({{}, current->second});
    current_.erase(current);
  }
  for (const std::string& name : std::exchange(absent_, names)) {
    if (names.count(name) != 0) continue;
    const auto last = last_of(name);
    if (!last) continue;
    current_[name] = *last;
    changes.push_back({last, {}});
  }
  return changes;
}

bool PeerInstances::counts(Id id) const {
  const auto found = instances_.find(id);
  if (found == instances_.end()) return false;
  const auto current = current_.find(found->second.name);
  return current != current_.end() && current->second == id;
}

std::string PeerInstances::name_of(Id id) const {
  const auto found = instances_.find(id);
  return found == instances_.end() ? "" : found->second.name;
}

}  // namespace tocsin
