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

template <class Order>
std::optional<typename Order::Wish> wish_of(const std::string& order) {
  using Wish = typename Order::Wish;
  if constexpr (std::is_same_v<Order, DockOrder>) {
    if (order == "dock_start") return Wish::start;
    if (order == "dock_cancel") return Wish::cancel;
    if (order == "dock_status") return Wish::status;
  } else {
    if (order == "estop_on") return Wish::on;
    if (order == "estop_off") return Wish::off;
    if (order == "estop_status") return Wish::status;
  }
  return std::nullopt;
}

EmergencyStopOrder::Asked asked_of(const std::string& word) {
  if (word == "on") return EmergencyStopOrder::Asked::on;
  return word == "off" ? EmergencyStopOrder::Asked::off : EmergencyStopOrder::Asked::nothing;
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
  if (std::holds_alternative<std::monostate>(order_)) {
    const Duration wait = seconds(params_.wait_s);
    if (const auto stop = wish_of<EmergencyStopOrder>(params_.order)) {
      using Place = EmergencyStopOrder::Place;
      order_.emplace<EmergencyStopOrder>(*stop, now, wait,
                                         is_at_vehicle() ? Place::vehicle : Place::station);
    } else if (const auto dock = wish_of<DockOrder>(params_.order)) {
      order_.emplace<DockOrder>(*dock, now, wait);
    }
  }
  if (auto* stop = std::get_if<EmergencyStopOrder>(&order_)) give(*stop, now);
  if (auto* dock = std::get_if<DockOrder>(&order_)) give(*dock, now);
  wake_at(now + look_again);
}

void OperatorConsoleComponent::hear(EmergencyStopOrder& order, Time now) {
  while (const auto state = station_.take()) {
    order.on_station(asked_of(state->asked()));
    if (state->vehicle() != "unheard") {
      order.on_vehicle(state->vehicle() == "stands", state->stopped_by());
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
