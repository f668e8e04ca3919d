// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/gate_component.hpp"

#include <utility>

namespace tocsin {

GateComponent::GateComponent(Context& context, const Params& params, std::string process)
    : Component(context),
      keeper_(seconds(params.silence_limit_s)),
      process_(std::move(process)),
      report_period_(seconds(params.report_period_s)) {}

void GateComponent::tick(Time now) {
  while (const auto state = state_.take()) {
    if (state->role() == context().role) keeper_.on_state(state->active(), now);
  }
  const bool open = keeper_.open(now);
  if (open != std::exchange(open_, open)) bus().set_gate(open);
  if (now >= next_report_) report(now);
  wake_at(std::min(keeper_.deadline(now), next_report_));
}

void GateComponent::report(Time now) {
  next_report_ = next_instant(report_period_, now);
  if (!report_.wanted()) return;
  tocsin_msgs::msg::TrafficReport message;
  message.stamp(wall(now));
  message.role(context().role);
  message.process(process_);
  const std::vector<TopicTraffic> all = bus().link_traffic();
  message.topics().reserve(all.size());
  for (const TopicTraffic& traffic : all) {
    tocsin_msgs::msg::TopicTraffic one;
    one.topic(traffic.topic);
    one.traffic_class(to_string(traffic.traffic_class));
    one.paused(traffic.paused);
    one.written(traffic.written);
    one.sent(traffic.sent);
    one.dropped(traffic.dropped);
    one.held(traffic.held);
    one.sent_bytes(traffic.sent_bytes);
    message.topics().push_back(std::move(one));
  }
  if (message.topics().size() > 1 && report_.write(std::move(message)) == Status::failed) {
    log().warn("the traffic report was refused by the middleware");
  }
}

}  // namespace tocsin
