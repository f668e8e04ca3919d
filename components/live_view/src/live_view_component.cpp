// SPDX-License-Identifier: Apache-2.0
#include "live_view/live_view_component.hpp"

#include <unistd.h>

#include <cstdio>

#include "runtime/component_entry.hpp"

namespace tocsin {

LiveViewComponent::LiveViewComponent(Context& context, const Params& params)
    : Component(context),
      terminal_(isatty(STDOUT_FILENO) == 1),
      period_(seconds(terminal_ ? params.refresh_s : params.line_period_s)) {
  count(topic::List<topic::BatteryState, topic::MemoryUsage, topic::CpuLoad, topic::CpuTemperature,
                    topic::CameraImage, topic::SafetyStatus, topic::DockingStatus>{});
}

template <class... Topics>
void LiveViewComponent::count(topic::List<Topics...>) {
  (counted_.push_back({Topics::info.name,
                       std::make_unique<InputPort>(
                           *this, Endpoint{Topics::info, &type_info<typename Topics::Message>()})}),
   ...);
}

template <class Topic>
std::shared_ptr<const typename Topic::Message> LiveViewComponent::take(Input<Topic>& input,
                                                                       Time now) {
  auto message = input.take();
  if (message) table_.on_sample(Topic::info.name, now);
  return message;
}

void LiveViewComponent::tick(Time now) {
  take_inputs(now);
  if (now >= next_draw_) draw(now);
  wake_at(next_draw_);
}

void LiveViewComponent::take_inputs(Time now) {
  while (const auto message = take(location_, now)) {
    view_.located = true;
    view_.x_m = message->pose().pose().position().x();
    view_.y_m = message->pose().pose().position().y();
    located_at_ = now;
  }
  while (const auto message = mission_.take()) view_.mission = *message;
  while (const auto message = take(navigation_, now)) view_.navigation = *message;
  while (const auto message = take(quality_, now)) view_.quality = *message;
  take_states(now);
  for (Counted& one : counted_) {
    while (one.input->take_sample()) table_.on_sample(one.topic, now);
  }
}

void LiveViewComponent::take_states(Time now) {
  while (const auto message = transmission_.take()) {
    const bool from_vehicle = message->role() == "uxv";
    if (from_vehicle) table_.on_sample(topic::TransmissionState::info.name, now);
    (from_vehicle ? view_.uxv : view_.gcs) = *message;
  }
  while (const auto message = heartbeat_.take()) {
    if (message->role() == "uxv") table_.on_sample(topic::Heartbeat::info.name, now);
  }
  while (const auto message = report_.take()) {
    if (message->role() != "uxv") continue;
    table_.on_sample(topic::TrafficReport::info.name, now);
    table_.on_report(*message);
  }
}

ViewState LiveViewComponent::state(Time now) {
  view_.location_age_s = view_.located ? to_seconds(now - located_at_) : 0;
  view_.traffic = table_.rows(now);
  return view_;
}

void LiveViewComponent::draw(Time now) {
  next_draw_ = now + period_;
  const ViewState shown = state(now);
  if (terminal_) {
    std::printf("\x1b[H\x1b[J%s", page(shown, true).c_str());
  } else {
    std::printf("%s\n", summary_line(shown).c_str());
  }
  std::fflush(stdout);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::LiveViewComponent)
