// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "emergency_stop_input/vehicle_stop_view.hpp"
#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "operator_console/dock_order.hpp"
#include "operator_console/emergency_stop_order.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// What a person orders.
enum class ConsoleOrder {
  estop_on,
  estop_off,
  estop_status,
  dock_start,
  dock_cancel,
  dock_status,
};
constexpr std::array<const char*, 6> words_of(ConsoleOrder) {
  return {"estop_on", "estop_off", "estop_status", "dock_start", "dock_cancel", "dock_status"};
}

/// Gives one order, prints what comes of it and ends its process. For tocsin estop and tocsin dock.
class OperatorConsoleComponent final : public Component {
 public:
  struct Params {
    ConsoleOrder order = ConsoleOrder::estop_status;
    double wait_s = 5;
    bool direct = false;
    template <class Visitor>
    void visit(Visitor& v) {
      visit_enum(v, "order", order,
                 Choices{"estop_on", "estop_off", "estop_status", "dock_start", "dock_cancel",
                         "dock_status"},
                 "what to do");
      v("wait_s", wait_s, {0.5, 600}, "[s] for an answer");
      v("direct", direct, "the vehicle itself is told to stop when nobody at the station takes it");
    }
  };
  using Printer = std::function<void(const std::string& line)>;

  OperatorConsoleComponent(Context& context, const Params& params);
  OperatorConsoleComponent(Context& context, const Params& params, Printer print);
  void tick(Time now) override;

 private:
  void begin(Time now);
  void give(EmergencyStopOrder& order, Time now);
  void hear(EmergencyStopOrder& order, Time now);
  [[nodiscard]] bool is_at_vehicle() const { return context().role == Role::uxv; }
  template <class Topic>
  void say(Output<Topic>& output, bool pressed);
  void give(DockOrder& order, Time now);
  [[nodiscard]] bool due(Time now);
  void end(const OrderResult& result);

  Input<topic::EmergencyStopState> station_{*this};
  Input<topic::SafetyStatus> safety_{*this};
  OptionalInput<topic::LinkStop> link_{*this};
  Input<topic::DockingStatus> docking_{*this};
  Output<topic::EmergencyStopRequest> request_{*this};
  std::optional<Output<topic::EmergencyStop>> direct_;
  Output<topic::DockingCommand> command_{*this};

  Params params_;
  VehicleStopView vehicle_;
  Printer print_;
  std::variant<std::monostate, EmergencyStopOrder, DockOrder> order_;
  Time next_send_ = Time::min();
  bool ended_ = false;
};

}  // namespace tocsin
