// SPDX-License-Identifier: Apache-2.0
#include "backfill/log_history.hpp"

#include <algorithm>
#include <variant>

#include "backfill/backfill_messages.hpp"
#include "backfill/rule_requests.hpp"
#include "foundation/enum_words.hpp"
#include "router_messages.hpp"

namespace tocsin {
namespace {

/// A request stands for so long after it was repeated last: over short outages.
constexpr Duration lease = std::chrono::seconds(30);
constexpr Duration rules_stand_for = std::chrono::hours(24);  ///< after the end of their range

/// A topic in the log has the name that other tools show.
std::string name_in_log(const std::string& topic) { return "/" + topic; }

std::uint64_t at_least_zero(std::int64_t ns) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(ns, 0));
}

}  // namespace

bool LogHistory::logs_any() const {
  const auto any = [](const auto& rules) {
    return std::any_of(rules.begin(), rules.end(),
                       [](const auto& one) { return one.second.logged; });
  };
  return any(parts_.link.rules().all()) || any(parts_.link.rules().patterns());
}

bool LogHistory::logs(const std::string& topic) const {
  const TrafficRule* const rule = parts_.link.rules().find(topic);
  return rule != nullptr && rule->logged;
}

std::set<std::string> LogHistory::topics() const {
  std::set<std::string> topics;
  for (const std::uint64_t key : streams_) topics.insert(parts_.flows.at(key).topic);
  return topics;
}

void LogHistory::add(const LocalFlow& flow) {
  const std::string name = stream_rule(flow.what, {}).name;
  const std::uint64_t key = sample_log::stream_key(name);
  keys_[flow.on_host] = key;
  if (flow.on_link) live_keys_[*flow.on_link] = key;
  streams_.insert(key);
  parts_.flows[key] = flow.what;
  parts_.store.add(logged_stream(name, flow.what));
}

void LogHistory::remove(const LocalFlow& flow) {
  keys_.erase(flow.on_host);
  if (flow.on_link) live_keys_.erase(*flow.on_link);
}

void LogHistory::log(const LocalFlow& flow, const CarriedSample& sample, Instant at) {
  const auto key = keys_.find(flow.on_host);
  if (key == keys_.end()) return;
  const SampleId id{key->second, sample.source, sample.sequence};
  parts_.store.append({id, sample.sent_wall_ns, parts_.link.bytes_of(sample)}, at);
}

std::optional<std::uint64_t> LogHistory::live_key(FlowId on_link) const {
  const auto found = live_keys_.find(on_link);
  return found == live_keys_.end() ? std::nullopt : std::optional(found->second);
}

std::pair<std::vector<LogHistory::SampleId>, std::vector<LogHistory::SampleId>> LogHistory::split(
    const std::vector<SampleId>& ids) const {
  std::pair<std::vector<SampleId>, std::vector<SampleId>> parts;
  for (const SampleId& id : ids) (has(id.stream) ? parts.first : parts.second).push_back(id);
  return parts;
}

void LogHistory::confirm(std::vector<SampleId> ids) {
  requests_.on_delivered(ids);
  parts_.store.confirm(std::move(ids));
}

void LogHistory::request(const router::HistoryRange& range, Time now) {
  if (logs(range.topic)) requests_.on_request(range, now + lease);
}

bool LogHistory::request(const router::RuleRequest& request, Instant at) {
  const Duration until_end(request.range.to_ns - at.wall_ns);
  return requests_.on_request(request, at.now + until_end + rules_stand_for);
}

void LogHistory::resume_requests(Instant at) {
  if (earlier_requests_.empty()) return;
  for (const router::RuleRequest& one : rule_requests_in(std::exchange(earlier_requests_, ""))) {
    const bool is_over = Duration(at.wall_ns - one.range.to_ns) > rules_stand_for;
    if (is_over || !logs(one.range.topic) || !request(one, at)) continue;
    if (one.range.to_ns > at.wall_ns) resumed_.insert(one.rule);
  }
}

void LogHistory::follow(Instant at) {
  take_answers();
  resume_requests(at);
  std::vector<SampleId> unwanted = requests_.expire(at.now);
  for (const SampleId& id : unwanted) parts_.sender.withdraw(id);
  parts_.store.forget(std::move(unwanted));
  for (const router::HistoryRange& range : requests_.take_searches(at.wall_ns)) {
    parts_.store.find(range.id, {name_in_log(range.topic), at_least_zero(range.from_ns),
                                 at_least_zero(range.to_ns)});
  }
  if (!knows_requests_) return;
  if (const auto requests = requests_.take_rule_requests()) {
    parts_.store.keep_requests(to_text(*requests));
  }
}

/// What was appended or saved needs no answer: what is refused is a problem.
void LogHistory::take_answers() {
  while (auto answer = parts_.store.take()) {
    if (auto* const opened = std::get_if<store_answer::Opened>(&*answer)) {
      on_opened(*opened);
    } else if (auto* const read = std::get_if<store_answer::Read>(&*answer)) {
      on_read(*read);
    } else if (auto* const retired = std::get_if<store_answer::Retired>(&*answer)) {
      on_retired(*retired);
    } else if (auto* const found = std::get_if<store_answer::Found>(&*answer)) {
      requests_.on_found(found->search, found->finding.ids, found->finding.next_ns);
      for (const SampleId& id : found->finding.ids) parts_.sender.request(id);
    } else if (auto* const contents = std::get_if<store_answer::Contents>(&*answer)) {
      contents_ = std::move(contents->spans);
    } else if (auto* const problem = std::get_if<store_answer::Problem>(&*answer)) {
      parts_.log.error("{}", problem->text);
    }
  }
}

void LogHistory::on_opened(store_answer::Opened& opened) {
  knows_requests_ = true;
  earlier_requests_ = std::move(opened.requests);
  for (const sample_log::LoggedStream& stream : opened.streams) {
    const Flow flow = flow_of(stream);
    if (!logs(flow.topic)) continue;  // an earlier instance did
    const std::uint64_t key = sample_log::stream_key(stream.name);
    streams_.insert(key);
    parts_.flows.try_emplace(key, flow);
  }
}

void LogHistory::on_read(store_answer::Read& read) {
  std::set<SampleId> gone(read.asked.begin(), read.asked.end());
  for (const sample_log::LogEntry& entry : read.read) gone.erase(entry.id);
  parts_.sender.on_read(read.asked, std::move(read.read));
  requests_.on_gone({gone.begin(), gone.end()});
}

void LogHistory::on_retired(const store_answer::Retired& retired) {
  std::vector<SampleId> gone;
  for (const SampleId& id : retired.ids) {
    if (parts_.sender.on_retired(id)) gone.push_back(id);
  }
  requests_.on_gone(gone);
}

void LogHistory::add_to(tocsin_msgs::msg::LinkState& message) const {
  for (const sample_log::LoggedSpan& span : contents_) {
    if (!logs(span.topic.substr(1))) continue;  // what arrives is kept for this host alone
    tocsin_msgs::msg::LoggedTopic topic;
    topic.topic(span.topic.substr(1));
    topic.samples(span.samples);
    topic.first_ns(static_cast<std::int64_t>(span.first_ns));
    topic.last_ns(static_cast<std::int64_t>(span.last_ns));
    message.logged().push_back(std::move(topic));
  }
  for (const router::HistoryProgress& progress : requests_.progress()) {
    tocsin_msgs::msg::LogFetch fetch;
    fetch.id(progress.id);
    fetch.topic(progress.topic);
    fetch.state(word_of(progress.state));
    fetch.found(progress.found);
    fetch.delivered(progress.delivered);
    fetch.gone(progress.gone);
    message.fetches().push_back(std::move(fetch));
  }
}

}  // namespace tocsin
