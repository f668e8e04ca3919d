// SPDX-License-Identifier: Apache-2.0
#include "report_link.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "foundation/printable.hpp"
#include "router_messages.hpp"
#include "runtime/middleware/ros_stamp.hpp"

namespace tocsin {
namespace {

constexpr Duration report_period = std::chrono::seconds(1);
/// Of adaptive streams: a camera follows within two pictures.
constexpr Duration budget_period = std::chrono::milliseconds(200);

}  // namespace

ReportLink::ReportLink(Component& owner, ReportOutputs& outputs, const LinkParts& parts,
                       const Services& services, const SiteLink& sites)
    : owner_(owner), outputs_(outputs), parts_(parts), services_(services), sites_(sites) {}

void ReportLink::finish(Instant at) {
  if (at.now >= next_budget_) report_budgets(at);
  const bool is_due = at.now >= next_report_;
  const std::string site = sites_.to_tell(at.now);
  if (is_due || site != told_site_) report_site(site);
  if (!is_due) return;
  next_report_ = owner_.next_instant(report_period, at.now);
  if (sites_.is_left()) return;
  report_link(at);
  report_traffic(at);
}

template <class Message>
Message ReportLink::message(Instant at) const {
  Message message;
  message.stamp(ros_stamp(at.wall_ns));
  message.role(to_string(sites_.role()));
  return message;
}

template <class Topic>
void ReportLink::write(Output<Topic>& output, typename Topic::Message message) {
  if (output.write(std::move(message)) != Status::failed) return;
  parts_.log.warn("{} was not written", Topic::info.name);
}

void ReportLink::report_budgets(Instant at) {
  next_budget_ = owner_.next_instant(budget_period, at.now);
  auto report = message<topic::LinkBudget::Message>(at);
  for (const router::StreamBudget& budget : parts_.sender.budgets(at.now)) {
    const auto flow = std::find_if(parts_.local.begin(), parts_.local.end(), [&](const auto& one) {
      return one.second.on_link == budget.stream;
    });
    tocsin_msgs::msg::StreamBudget stream;
    stream.topic(flow->second.what.topic);
    stream.bytes_per_s(static_cast<float>(budget.bytes_per_s));
    stream.scale(static_cast<float>(budget.scale));
    stream.hold(budget.hold);
    report.streams().push_back(std::move(stream));
  }
  if (!report.streams().empty()) write(outputs_.budget, std::move(report));
}

void ReportLink::report_link(Instant at) {
  auto report = to_message(parts_.sender.state(at.now), parts_.link.packets());
  report.stamp(ros_stamp(at.wall_ns));
  report.role(to_string(sites_.role()));
  for (const auto& service : services_) service->add_to(report, at.now);
  write(outputs_.link_state, std::move(report));
}

void ReportLink::report_site(const std::string& site) {
  told_site_ = site;
  if (site.empty()) return;
  topic::LinkSite::Message message;
  message.data(printable(site));
  write(outputs_.site, std::move(message));
}

void ReportLink::report_traffic(Instant at) {
  auto report = message<topic::TrafficReport::Message>(at);
  report.process(owner_.name());
  const bool paused = parts_.sender.is_paused();
  for (const auto& entry : parts_.local) {
    const LocalFlow& flow = entry.second;
    if (!flow.on_link) continue;
    const router::StreamCounts counts = parts_.sender.stream_counts(*flow.on_link);
    if (flow.rule.on_demand && counts.offered == 0) continue;  // nobody has read it
    tocsin_msgs::msg::TopicTraffic one;
    one.topic(flow.what.topic);
    one.traffic_class(to_string(flow.rule.traffic_class));
    one.paused(paused && flow.rule.while_paused != router::WhilePaused::send);
    one.written(counts.offered);
    one.sent(counts.sent);
    one.dropped(counts.dropped);
    one.held(counts.paused);
    const SentBytes sent = parts_.streams.sent_bytes(*flow.on_link);
    one.sent_bytes(sent.bytes);
    one.plain_bytes(sent.plain);
    report.topics().push_back(std::move(one));
  }
  write(outputs_.traffic, std::move(report));
}

}  // namespace tocsin
