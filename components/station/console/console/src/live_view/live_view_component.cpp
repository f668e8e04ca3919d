// SPDX-License-Identifier: Apache-2.0
#include "live_view/live_view_component.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "foundation/error.hpp"
#include "foundation/role.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/host_control.hpp"

namespace tocsin {

LiveViewComponent::LiveViewComponent(Context& context, const Params& params)
    : Component(context),
      limits_(params.limits),
      terminal_(isatty(STDOUT_FILENO) == 1),
      period_(seconds(terminal_ ? params.refresh_s : params.line_period_s)) {
  if (limits_.unknown_after_s < limits_.stale_after_s) {
    throw ConfigError(fmt::format("{}.unknown_after_s: {} is less than stale_after_s, {}",
                                  context.name, limits_.unknown_after_s, limits_.stale_after_s));
  }
  count(topic::List<topic::BatteryState, topic::MemoryUsage, topic::CpuLoad, topic::CpuTemperature,
                    topic::CameraImage, topic::DockingStatus>{});
  for (const PortHealth& input : port_health()) table_.on_reader(input.topic, {});
}

LiveViewComponent::~LiveViewComponent() {
  if (terminal_) std::printf("\n");  // what comes next begins below the page
}

template <class... Topics>
void LiveViewComponent::count(topic::List<Topics...>) {
  (counted_.push_back(
       {Topics::info.name, std::make_unique<InputPort>(
                               *this, Endpoint{Topics::info, &type_info<typename Topics::Message>(),
                                               Writers::optional})}),
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
    const auto& position = message->pose().pose().position();
    view_.location = {{position.x(), position.y()}, now};
  }
  while (const auto message = take(mission_, now)) view_.mission = {*message, now};
  while (const auto message = take(navigation_, now)) view_.navigation = {*message, now};
  while (const auto message = take(quality_, now)) view_.quality = {*message, now};
  while (const auto message = take(safety_, now)) view_.safety = {*message, now};
  take_states(now);
  take_link_states(now);
  take_diagnostics(now);
  for (Counted& one : counted_) {
    while (one.input->take_sample()) table_.on_sample(one.topic, now);
  }
}

void LiveViewComponent::take_states(Time now) {
  while (const auto message = transmission_.take()) {
    const bool from_vehicle = role_of(message->role()) == Role::uxv;
    if (from_vehicle) table_.on_sample(topic::TransmissionState::info.name, now);
    (from_vehicle ? view_.uxv : view_.gcs) =
        Heard<tocsin_msgs::msg::TransmissionState>{*message, now};
  }
  while (const auto message = heartbeat_.take()) {
    if (role_of(message->role()) == Role::uxv) table_.on_sample(topic::Heartbeat::info.name, now);
  }
  while (const auto message = report_.take()) {
    if (role_of(message->role()) != Role::uxv) continue;
    table_.on_sample(topic::TrafficReport::info.name, now);
    table_.on_report(*message, now);
  }
}

void LiveViewComponent::take_link_states(Time now) {
  while (const auto message = site_.take()) view_.other_site = {{message->data()}, now};
  while (const auto message = link_state_.take()) {
    const bool from_vehicle = role_of(message->role()) == Role::uxv;
    if (from_vehicle) table_.on_sample(topic::LinkState::info.name, now);
    (from_vehicle ? view_.uplink : view_.downlink) =
        Heard<tocsin_msgs::msg::LinkState>{*message, now};
  }
}

/// Each container of this host tells the room on the disk of the run folder, which is the same.
void LiveViewComponent::take_diagnostics(Time now) {
  while (const auto message = diagnostics_.take()) {
    for (const auto& status : message->status()) {
      for (const auto& value : status.values()) {
        if (value.key() != "disk_free_mib") continue;
        view_.disk = {{std::strtod(value.value().c_str(), nullptr)}, now};
      }
    }
  }
}

/// Of every topic that is counted, whether its reader has found a writer.
void LiveViewComponent::look_at_readers() {
  std::map<std::string, TopicReader> readers;
  for (const PortHealth& input : port_health()) readers[input.topic] = {};
  for (const EndpointHealth& endpoint : bus().host_control().health()) {
    const auto found = readers.find(endpoint.topic);
    if (endpoint.writer || found == readers.end()) continue;
    TopicReader& reader = found->second;
    reader.writers = reader.writers.value_or(0) + endpoint.matched;
    reader.thins = reader.thins || endpoint.thinned > 0;
  }
  for (const auto& [topic, reader] : readers) table_.on_reader(topic, reader);
}

ViewState LiveViewComponent::state(Time now) {
  look_at_readers();
  view_.traffic = table_.rows(now);
  // It is sent on change only; while its writer tells that it lives, the last one holds.
  const auto told = table_.reported(topic::SafetyStatus::info.name);
  if (view_.safety && told) view_.safety->at = std::max(view_.safety->at, *told);
  return view_;
}

void LiveViewComponent::draw(Time now) {
  next_draw_ = next_instant(period_, now);
  const ViewState shown = state(now);
  if (terminal_) {
    const terminal::Size size = terminal::size_of(STDOUT_FILENO);  // it may have been resized
    std::printf("%s", terminal::frame(page(shown, now, size, limits_), size).c_str());
  } else {
    std::printf("%s\n", summary_line(shown, now, limits_).c_str());
  }
  std::fflush(stdout);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::LiveViewComponent)
