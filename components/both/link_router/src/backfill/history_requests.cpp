// SPDX-License-Identifier: Apache-2.0
#include "link_router/history_requests.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tocsin::router {
namespace {

constexpr std::size_t most_standing = 16;
constexpr std::size_t most_requests = 64;
/// Of who repeats it once a second.
constexpr Duration patience = std::chrono::seconds(5);
constexpr Duration repeat_period = std::chrono::seconds(1);
/// What was written at the end of a range may still be on its way into the log, or over the link.
constexpr std::int64_t settled_ns = 1'000'000'000;

}  // namespace

void StandingRequests::on_request(const HistoryRange& range, Time now) {
  if (standing_.count(range.id) == 0 && standing_.size() >= most_standing) return;
  standing_[range.id] = {range, now};
}

std::vector<HistoryRange> StandingRequests::take_for(const std::string& peer, Time now) {
  std::vector<HistoryRange> ranges;
  const auto last = sent_.find(peer);
  if (last != sent_.end() && now - last->second < repeat_period) return ranges;
  for (auto it = standing_.begin(); it != standing_.end();) {
    if (now - it->second.said > patience) {
      it = standing_.erase(it);
      continue;
    }
    ranges.push_back(it->second.range);
    ++it;
  }
  if (!ranges.empty()) sent_[peer] = now;
  return ranges;
}

bool HistoryRequests::on_request(const HistoryRange& range, Time until) {
  return on_request(RuleRequest{range, ""}, until);
}

bool HistoryRequests::on_request(const RuleRequest& wanted, Time until) {
  const HistoryRange& range = wanted.range;
  if (requests_.count(range.id) == 0 && requests_.size() >= most_requests) {
    const auto done = std::find_if(requests_.begin(), requests_.end(), [](const auto& entry) {
      return entry.second.progress.state == HistoryState::done;
    });
    if (done == requests_.end()) return false;
    requests_.erase(done);
  }
  const auto [found, is_new] = requests_.try_emplace(range.id);
  Request& request = found->second;
  request.until = std::max(request.until, until);
  if (!is_new) return true;
  request.range = range;
  request.rule = wanted.rule;
  rules_changed_ = rules_changed_ || !request.rule.empty();
  request.next_ns = range.from_ns;
  request.progress.id = range.id;
  request.progress.topic = range.topic;
  return true;
}

std::vector<HistoryRange> HistoryRequests::take_searches(std::int64_t wall_ns) {
  std::vector<HistoryRange> searches;
  for (auto& [id, request] : requests_) {
    const bool is_past = request.range.to_ns <= wall_ns - settled_ns;
    if (!is_past || request.is_asked || !request.has_more || !request.missing.empty()) continue;
    request.is_asked = true;
    searches.push_back({id, request.range.topic, request.next_ns, request.range.to_ns});
  }
  return searches;
}

void HistoryRequests::on_found(std::uint64_t id, const std::vector<SampleId>& ids,
                               std::optional<std::uint64_t> next_ns) {
  const auto found = requests_.find(id);
  if (found == requests_.end()) return;
  Request& request = found->second;
  request.is_asked = false;
  request.has_more = next_ns.has_value();
  request.next_ns = static_cast<std::int64_t>(next_ns.value_or(0));
  request.missing.insert(ids.begin(), ids.end());
  request.progress.found += ids.size();
  update(request);
}

void HistoryRequests::update(Request& request) {
  if (!request.missing.empty()) {
    request.progress.state = HistoryState::sending;
  } else {
    request.progress.state = request.has_more ? HistoryState::searching : HistoryState::done;
  }
  const bool is_done = request.progress.state == HistoryState::done;
  rules_changed_ = rules_changed_ || (is_done && !request.rule.empty());
}

std::optional<std::vector<RuleRequest>> HistoryRequests::take_rule_requests() {
  if (!std::exchange(rules_changed_, false)) return std::nullopt;
  std::vector<RuleRequest> all;
  for (const auto& [id, request] : requests_) {
    const bool is_done = request.progress.state == HistoryState::done;
    if (!request.rule.empty() && !is_done) all.push_back({request.range, request.rule});
  }
  return all;
}

void HistoryRequests::settle(const std::vector<SampleId>& ids,
                             std::uint64_t HistoryProgress::*count) {
  for (auto& entry : requests_) {
    Request& request = entry.second;
    std::uint64_t settled = 0;
    for (const SampleId& id : ids) settled += request.missing.erase(id);
    if (settled == 0) continue;
    request.progress.*count += settled;
    update(request);
  }
}

void HistoryRequests::on_delivered(const std::vector<SampleId>& ids) {
  if (!ids.empty()) settle(ids, &HistoryProgress::delivered);
}

void HistoryRequests::on_gone(const std::vector<SampleId>& ids) {
  if (!ids.empty()) settle(ids, &HistoryProgress::gone);
}

bool HistoryRequests::is_wanted(const SampleId& id) const {
  return std::any_of(requests_.begin(), requests_.end(),
                     [&id](const auto& entry) { return entry.second.missing.count(id) != 0; });
}

std::vector<HistoryRequests::SampleId> HistoryRequests::expire(Time now) {
  std::set<SampleId> left;
  for (auto it = requests_.begin(); it != requests_.end();) {
    if (it->second.until >= now) {
      ++it;
      continue;
    }
    left.insert(it->second.missing.begin(), it->second.missing.end());
    rules_changed_ = rules_changed_ || !it->second.rule.empty();
    it = requests_.erase(it);
  }
  std::vector<SampleId> unwanted;
  std::copy_if(left.begin(), left.end(), std::back_inserter(unwanted),
               [this](const SampleId& id) { return !is_wanted(id); });
  return unwanted;
}

std::vector<HistoryProgress> HistoryRequests::progress() const {
  std::vector<HistoryProgress> all;
  for (const auto& entry : requests_) all.push_back(entry.second.progress);
  return all;
}

}  // namespace tocsin::router
