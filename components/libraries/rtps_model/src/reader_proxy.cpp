// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/reader_proxy.hpp"

#include <algorithm>

namespace tocsin::rtps {

std::deque<ReaderProxy::Change>::iterator ReaderProxy::find(Sequence sequence) {
  const auto found = std::lower_bound(
      changes_.begin(), changes_.end(), sequence,
      [](const Change& one, Sequence wanted) { return one.sample->sequence < wanted; });
  return found != changes_.end() && found->sample->sequence == sequence ? found : changes_.end();
}

std::deque<ReaderProxy::Change>::const_iterator ReaderProxy::find(Sequence sequence) const {
  return const_cast<ReaderProxy*>(this)->find(sequence);
}

bool ReaderProxy::needs_heartbeat(Sequence first) const {
  return first > low_mark_ || std::any_of(changes_.begin(), changes_.end(), [](const Change& one) {
           return one.status == Status::unacknowledged;
         });
}

void ReaderProxy::add(const SamplePtr& sample, Status status) {
  changes_.push_back({sample, status, {}, false});
  changes_.back().mark_all_unsent();
}

void ReaderProxy::remove(Sequence sequence) {
  const auto found = find(sequence);
  if (found == changes_.end()) return;
  changes_.erase(found);
  if (sequence == low_mark_ + 1) acknowledge_before(sequence + 1);
}

void ReaderProxy::acknowledge_before(Sequence base) {
  if (base <= low_mark_ + 1) return;
  while (!changes_.empty() && changes_.front().sample->sequence < base) changes_.pop_front();
  low_mark_ = base - 1;
}

void ReaderProxy::start_over(const std::deque<SamplePtr>& history) {
  if (history.empty()) return;
  std::deque<Change> all;
  for (const SamplePtr& sample : history) {
    const auto known = find(sample->sequence);
    if (known != changes_.end()) {
      all.push_back(std::move(*known));
    } else {
      all.push_back({sample, Status::unacknowledged, {}, false});
    }
  }
  changes_ = std::move(all);
  low_mark_ = history.front()->sequence - 1;
}

bool ReaderProxy::request(const std::vector<Sequence>& wanted, Sequence first_in_history,
                          std::vector<Sequence>& absent) {
  bool any = false;
  for (const Sequence sequence : wanted) {
    const auto change = find(sequence);
    if (change == changes_.end()) {
      if (sequence >= first_in_history && sequence > low_mark_) absent.push_back(sequence);
    } else if (change->status == Status::unacknowledged) {
      change->status = Status::requested;
      change->mark_all_unsent();
      any = true;
    }
  }
  return any;
}

bool ReaderProxy::request(Sequence sequence, const std::vector<Fragment>& wanted) {
  const auto change = find(sequence);
  if (change == changes_.end()) return false;
  if (change->delivered) {
    for (const Fragment fragment : wanted) {
      if (fragment >= 1 && fragment <= change->unsent.size()) change->unsent[fragment - 1] = true;
    }
  }
  if (change->status != Status::unsent) change->status = Status::requested;
  return true;
}

void ReaderProxy::answer(std::vector<Sequence>& to_send) {
  for (Change& change : changes_) {
    if (change.status != Status::requested) continue;
    change.status = Status::unsent;
    to_send.push_back(change.sample->sequence);
  }
}

void ReaderProxy::end_suppression() {
  for (Change& change : changes_) {
    if (change.status == Status::underway) change.status = Status::unacknowledged;
  }
}

std::optional<Fragment> ReaderProxy::next_unsent(Sequence sequence) const {
  const auto change = find(sequence);
  if (change == changes_.end() || change->status != Status::unsent) return std::nullopt;
  if (change->unsent.empty()) return 0;
  const auto next = std::find(change->unsent.begin(), change->unsent.end(), true);
  if (next == change->unsent.end()) return std::nullopt;
  return static_cast<Fragment>(next - change->unsent.begin()) + 1;
}

bool ReaderProxy::is_new(Sequence sequence) const {
  const auto change = find(sequence);
  return change != changes_.end() && !change->delivered;
}

std::optional<Sequence> ReaderProxy::hole_before(Sequence sequence,
                                                 Sequence first_in_history) const {
  const auto change = find(sequence);
  const Sequence before =
      change == changes_.begin() ? low_mark_ : std::prev(change)->sample->sequence;
  const Sequence hole = std::max(before + 1, first_in_history);
  return hole < sequence ? std::optional<Sequence>(hole) : std::nullopt;
}

bool ReaderProxy::on_sent(Sequence sequence, Fragment fragment) {
  const auto change = find(sequence);
  if (fragment > 0) {
    change->unsent[fragment - 1] = false;
    if (std::find(change->unsent.begin(), change->unsent.end(), true) != change->unsent.end()) {
      return false;
    }
  }
  change->status = Status::underway;
  change->delivered = true;
  return true;
}

}  // namespace tocsin::rtps
