// SPDX-License-Identifier: Apache-2.0
// What this host logs, and what of it somebody wants.
#include <algorithm>
#include <utility>

#include "backfill_link.hpp"
#include "backfill_messages.hpp"
#include "foundation/enum_words.hpp"
#include "router_messages.hpp"
#include "rule_requests.hpp"

namespace tocsin {
namespace {

/// What somebody wants stands for so long after it was said last: over short outages.
constexpr Duration lease = std::chrono::seconds(30);
constexpr Duration rules_stand_for = std::chrono::hours(24);  ///< after the end of what they want

/// A topic in the log has the name that other tools show.
std::string name_in_log(const std::string& topic) { return "/" + topic; }

std::uint64_t at_least_zero(std::int64_t ns) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(ns, 0));
}

}  // namespace

bool BackfillLink::logs() const {
  const auto any = [](const auto& rules) {
    return std::any_of(rules.begin(), rules.end(),
                       [](const auto& one) { return one.second.logged; });
  };
  return any(parts_.link.rules().all()) || any(parts_.link.rules().patterns());
}

bool BackfillLink::logs(const std::string& topic) const {
  const TrafficRule* const rule = parts_.link.rules().find(topic);
  return rule != nullptr && rule->logged;
}

std::set<std::string> BackfillLink::logged_topics() const {
  std::set<std::string> topics;
  for (const std::uint64_t key : logged_streams_) topics.insert(sent_.at(key).what.topic);
  return topics;
}

void BackfillLink::add_logged(FlowId on_host, std::optional<FlowId> on_link, const Flow& flow) {
  const std::string name = stream_rule(flow, {}).name;
  const std::uint64_t key = sample_log::stream_key(name);
  logged_[on_host] = key;
  if (on_link) logged_live_[*on_link] = key;
  logged_streams_.insert(key);
  sent_[key].what = flow;
  parts_.history.add(logged_stream(name, flow));
}

void BackfillLink::log(FlowId on_host, const CarriedSample& sample, Time now,
                       std::int64_t wall_ns) {
  const auto key = logged_.find(on_host);
  if (key == logged_.end()) return;
  const sample_log::SampleId id{key->second, sample.source, sample.sequence};
  parts_.history.append({id, sample.sent_wall_ns, parts_.link.bytes_of(sample)}, now, wall_ns);
}

void BackfillLink::request(const router::HistoryRange& range, Time now) {
  if (logs(range.topic)) requests_.on_request(range, now + lease);
}

bool BackfillLink::request(const router::RuleRequest& request, Time now, std::int64_t wall_ns) {
  return requests_.on_request(request,
                              now + Duration(request.range.to_ns - wall_ns) + rules_stand_for);
}

void BackfillLink::resume_requests(Time now, std::int64_t wall_ns) {
  if (earlier_requests_.empty()) return;
  for (const router::RuleRequest& one : rule_requests_in(std::exchange(earlier_requests_, ""))) {
    const bool is_over = Duration(wall_ns - one.range.to_ns) > rules_stand_for;
    if (is_over || !logs(one.range.topic)) continue;
    (void)request(one, now, wall_ns);
    if (one.range.to_ns > wall_ns) resumed_.insert(one.rule);
  }
}

void BackfillLink::follow_history(Time now, std::int64_t wall_ns) {
  while (auto answer = parts_.history.take()) {
    std::visit([this](auto& what) { on_history(what); }, *answer);
  }
  resume_requests(now, wall_ns);
  std::vector<sample_log::SampleId> unwanted = requests_.expire(now);
  for (const sample_log::SampleId& id : unwanted) sender_.withdraw(id);
  parts_.history.forget(std::move(unwanted));
  for (const router::HistoryRange& range : requests_.take_searches(wall_ns)) {
    parts_.history.find(range.id, {name_in_log(range.topic), at_least_zero(range.from_ns),
                                   at_least_zero(range.to_ns)});
  }
  if (!knows_requests_) return;
  if (const auto requests = requests_.take_rule_requests()) {
    parts_.history.keep_requests(to_text(*requests));
  }
}

void BackfillLink::on_history(store_answer::Opened& answer) {
  knows_requests_ = true;
  earlier_requests_ = std::move(answer.requests);
  for (const sample_log::LoggedStream& stream : answer.streams) {
    if (!logs(flow_of(stream).topic)) continue;  // it was, in an earlier life
    const std::uint64_t key = sample_log::stream_key(stream.name);
    logged_streams_.insert(key);
    Described& described = sent_[key];
    if (described.what.topic.empty()) described.what = flow_of(stream);
  }
}

void BackfillLink::on_history(store_answer::Found& answer) {
  requests_.on_found(answer.search, answer.finding.ids, answer.finding.next_ns);
  for (const sample_log::SampleId& id : answer.finding.ids) sender_.request(id);
}

void BackfillLink::on_history(store_answer::Read& answer) {
  std::set<sample_log::SampleId> gone(answer.asked.begin(), answer.asked.end());
  for (const sample_log::LogEntry& entry : answer.read) gone.erase(entry.id);
  sender_.on_read(answer.asked, std::move(answer.read));
  requests_.on_gone({gone.begin(), gone.end()});
}

void BackfillLink::on_history(store_answer::Retired& answer) {
  std::vector<sample_log::SampleId> gone;
  for (const sample_log::SampleId& id : answer.ids) {
    if (sender_.on_retired(id)) gone.push_back(id);
  }
  requests_.on_gone(gone);
}

void BackfillLink::add_fetches(tocsin_msgs::msg::LinkState& message) const {
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
    fetch.given(progress.given);
    fetch.gone(progress.gone);
    message.fetches().push_back(std::move(fetch));
  }
}

}  // namespace tocsin
