// SPDX-License-Identifier: Apache-2.0
// What a LinkRouterComponent tells its host.
#include <utility>

#include "backfill_link.hpp"
#include "link_router/link_router_component.hpp"
#include "router_messages.hpp"

namespace tocsin {

void LinkRouterComponent::tell_budgets(Time now) {
  next_budget_ = next_instant(seconds(params_.budget_period_s), now);
  tocsin_msgs::msg::LinkBudget message;
  message.stamp(wall(now));
  message.role(to_string(context().role));
  for (const router::StreamBudget& budget : sender_.budgets(now)) {
    tocsin_msgs::msg::StreamBudget stream;
    stream.topic(by_link_.at(budget.stream)->topic);
    stream.bytes_per_s(static_cast<float>(budget.bytes_per_s));
    stream.scale(static_cast<float>(budget.scale));
    stream.hold(budget.hold);
    message.streams().push_back(std::move(stream));
  }
  if (message.streams().empty()) return;
  if (budget_.write(std::move(message)) == Status::failed) log().warn("a budget was not told");
}

void LinkRouterComponent::report(Time now) {
  next_report_ = next_instant(seconds(params_.report_period_s), now);
  tocsin_msgs::msg::LinkState message = to_message(sender_.state(now), link_->packets());
  message.stamp(wall(now));
  message.role(to_string(context().role));
  backfills_->report(message);
  if (link_state_.write(std::move(message)) == Status::failed) {
    log().warn("the state of the link was not told");
  }
  report_traffic(now);
}

void LinkRouterComponent::report_traffic(Time now) {
  tocsin_msgs::msg::TrafficReport message;
  message.stamp(wall(now));
  message.role(to_string(context().role));
  message.process(name());
  for (const auto& entry : outgoing_) {
    const Outgoing& flow = entry.second;
    tocsin_msgs::msg::TopicTraffic one;
    one.topic(flow.topic);
    one.traffic_class(to_string(flow.rule.traffic_class));
    one.paused(!open_ && flow.rule.while_paused != router::WhilePaused::send);
    const router::StreamCounts counts = sender_.stream_counts(flow.on_link);
    one.written(counts.offered);
    one.sent(counts.sent);
    one.dropped(counts.dropped);
    one.held(counts.paused);
    one.sent_bytes(flow.sent_bytes);
    message.topics().push_back(std::move(one));
  }
  if (traffic_.write(std::move(message)) == Status::failed) {
    log().warn("the traffic report was refused by the middleware");
  }
}

}  // namespace tocsin
