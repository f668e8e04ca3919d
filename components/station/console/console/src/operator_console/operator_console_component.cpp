// SPDX-License-Identifier: Apache-2.0
#include "operator_console/operator_console_component.hpp"

#include <cstdio>
#include <utility>

#include "foundation/error.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr Duration send_again = std::chrono::milliseconds(500);
constexpr Duration look_again = std::chrono::milliseconds(100);

void print_line(const std::string& line) {
  std::printf("%s\n", error_line(line).c_str());
  std::fflush(stdout);
}

}  // namespace

OperatorConsoleComponent::OperatorConsoleComponent(Context& context, const Params& params)
    : OperatorConsoleComponent(context, params, print_line) {}

OperatorConsoleComponent::OperatorConsoleComponent(Context& context, const Params& params,
                                                   Printer print)
    : Component(context), params_(params), print_(std::move(print)) {
  // Made at the start, so that the vehicle's readers are found before it is needed.
  // On a vehicle's host it presses for itself: the station would take up a stop of its name.
  if (params.direct) direct_.emplace(*this, is_at_vehicle() ? "" : topic::EmergencyStop::station);
}

void OperatorConsoleComponent::tick(Time now) {
  if (ended_) return;
  if (std::holds_alternative<std::monostate>(order_)) begin(now);
  if (auto* stop = std::get_if<EmergencyStopOrder>(&order_)) give(*stop, now);
  if (auto* dock = std::get_if<DockOrder>(&order_)) give(*dock, now);
  wake_at(now + look_again);
}

void OperatorConsoleComponent::begin(Time now) {
  using Place = EmergencyStopOrder::Place;
  using Stop = EmergencyStopOrder::Wish;
  using Dock = DockOrder::Wish;
  const Duration wait = seconds(params_.wait_s);
  const auto stop = [&](Stop wish) {
    order_.emplace<EmergencyStopOrder>(wish, now, wait,
                                       is_at_vehicle() ? Place::vehicle : Place::station);
  };
  const auto dock = [&](Dock wish) { order_.emplace<DockOrder>(wish, now, wait); };
  switch (params_.order) {
    case ConsoleOrder::estop_on:
      return stop(Stop::on);
    case ConsoleOrder::estop_off:
      return stop(Stop::off);
    case ConsoleOrder::estop_status:
      return stop(Stop::status);
    case ConsoleOrder::dock_start:
      return dock(Dock::start);
    case ConsoleOrder::dock_cancel:
      return dock(Dock::cancel);
    case ConsoleOrder::dock_status:
      return dock(Dock::status);
  }
}

void OperatorConsoleComponent::hear(EmergencyStopOrder& order, Time now) {
  while (const auto state = station_.take()) {
    order.on_station(value_of<StopAsked>(state->asked()).value_or(StopAsked::never));
    const auto vehicle = value_of<VehicleStop>(state->vehicle());
    if (vehicle && vehicle != VehicleStop::unheard) {
      order.on_vehicle(vehicle == VehicleStop::stands, state->stopped_by());
    }
  }
  bool any = false;
  while (const auto status = safety_.take()) {
    vehicle_.on_safety_status({status->emergency_stop(), status->stopped_by()}, now);
    any = true;
  }
  while (const auto link = link_.take()) {
    if (is_at_vehicle()) continue;  // there it reports the station, not the vehicle
    vehicle_.on_link({link->stands(), link->stopped_by()}, link->silence_s(), now);
    any = true;
  }
  const auto report = any ? vehicle_.report() : std::nullopt;
  if (report) order.on_vehicle(report->stands, report->stopped_by);
}

template <class Topic>
void OperatorConsoleComponent::say(Output<Topic>& output, bool pressed) {
  typename Topic::Message message;
  message.data(pressed);
  if (output.write(std::move(message)) == Status::failed) log().warn("the order was not sent");
}

void OperatorConsoleComponent::give(EmergencyStopOrder& order, Time now) {
  hear(order, now);
  if (const auto result = order.result(now)) return end(*result);
  if (const auto word = direct_ ? order.direct(now) : std::nullopt) say(*direct_, *word);
  const auto request = order.request();
  if (request && due(now)) say(request_, *request);
}

void OperatorConsoleComponent::give(DockOrder& order, Time now) {
  while (const auto status = docking_.take()) {
    const auto line = order.on_status(
        {status->run(), status->state(), status->result(), status->elapsed_s()}, now);
    if (line) print_(*line);
  }
  if (const auto result = order.result(now)) return end(*result);
  const char* command = order.command();
  if (command == nullptr || !due(now)) return;
  topic::DockingCommand::Message message;
  message.data(command);
  if (command_.write(std::move(message)) == Status::failed) log().warn("the order was not sent");
}

bool OperatorConsoleComponent::due(Time now) {
  if (now < next_send_) return false;
  next_send_ = now + send_again;
  return true;
}

void OperatorConsoleComponent::end(const OrderResult& result) {
  ended_ = true;
  print_(result.text);
  context().request_exit(result.code);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::OperatorConsoleComponent)
