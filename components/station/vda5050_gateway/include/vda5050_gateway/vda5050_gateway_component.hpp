// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "runtime/action_port.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/actions.hpp"
#include "tocsin_idl/topics.hpp"
#include "vda5050_gateway/broker.hpp"
#include "vda5050_gateway/gateway.hpp"
#include "vda5050_gateway/messages.hpp"

namespace tocsin {

/// Speaks VDA 5050 for one vehicle, at the station, with a broker that any fleet manager uses.
class Vda5050GatewayComponent final : public Component {
 public:
  struct Params {
    vda5050::Version version = vda5050::Version::v3_0;
    std::string manufacturer = "tocsin";
    std::string serial_number = "uxv";
    std::string interface_name;
    vda5050::BrokerAddress broker;
    int port = 1883;
    std::string map_file;
    double robot_radius_m = 0.18;
    double start_reach_m = 0.3;
    vda5050::Capabilities capabilities;
    vda5050::Publications::Params publications;
    template <class Visitor>
    void visit(Visitor& v) {
      visit_enum(v, "version", version, Choices{"2.1", "3.0"}, "that the fleet manager speaks");
      v("manufacturer", manufacturer, "level of the topics");
      v("serial_number", serial_number, "level of the topics: the vehicle's name");
      v("interface_name", interface_name, "first level of the topics; empty: vda5050, in 2.1 uagv");
      v("host", broker.host, "of the MQTT broker: name or address");
      v("port", port, {1, 65535}, "of the MQTT broker");
      v("user", broker.user, "name at the broker; empty: none");
      v("password_file", broker.password_file, "its first line is the password; empty: none");
      v("ca_file", broker.ca_file, "PEM, who certifies the broker; empty: no TLS");
      v("certificate_file", broker.certificate_file, "PEM, ours; empty: none");
      v("key_file", broker.key_file, "PEM, its key; empty: none");
      v("map_file", map_file, "map that nodes are checked against; empty: unchecked");
      v("map_id", capabilities.map_id, "name that fleet control has for the map");
      v("robot_radius_m", robot_radius_m, {0.05, 1}, "[m] a node nearer to a wall is refused");
      v("start_reach_m", start_reach_m, {0.05, 5},
        "[m] the vehicle may be from an order's first node, beside its deviation");
      v("speed_mps", capabilities.speed_mps, {0.05, 5},
        "[m/s] top speed; lower limits are refused");
      v("rotation_rad_s", capabilities.rotation_rad_s, {0.1, 10}, "[rad/s] the same of turning");
      v("state_period_s", publications.state_period_s, {1, 30}, "[s] between states at most");
      v("visualization_period_s", publications.visualization_period_s, {0, 60},
        "[s] between visualizations; 0: none");
    }
  };

  /// Throws ConfigError when a name cannot be a level of a topic, or a file cannot be read.
  Vda5050GatewayComponent(Context& context, const Params& params,
                          const vda5050::Connect& connect = &vda5050::connect_mqtt);
  ~Vda5050GatewayComponent() override;
  void tick(Time now) override;

 private:
  using Drive = ActionClient<action::FollowWaypoints>;
  [[nodiscard]] bool connects(Time now);
  void take_inputs();
  void take_reports();
  void take_broker(Time now);
  void take_drive(Time now);
  void obey(const vda5050::Request& request, Time now);
  void drive(const vda5050::Request& request, Time now);
  void set_pose(const geometry::Pose& pose, Time now);
  template <class Topic>
  void send(Output<Topic>& output, typename Topic::Message message);
  template <class Topic>
  void say(Output<Topic>& output, const char* word);
  void publish(Time now);
  void load();
  void save();
  [[nodiscard]] std::int64_t wall_ns(Time now) { return bus().wall_ns(now); }

  Input<topic::Location> location_{*this, WakeMode::time_triggered};
  Input<topic::NavigationStatus> navigation_{*this};
  Input<topic::MissionStatus> mission_{*this};
  Input<topic::LinkStop> link_{*this, WakeMode::time_triggered};
  OptionalInput<topic::MissionPath> way_{*this};
  OptionalInput<topic::BatteryState> battery_{*this};
  OptionalInput<topic::SafetyStatus> safety_{*this};
  OptionalInput<topic::DriverState> driver_{*this};
  OptionalInput<topic::DockingStatus> docking_{*this};
  OptionalInput<topic::TransmissionState> transmission_{*this};
  Output<topic::MissionCommand> mission_command_{*this};
  Output<topic::DockingCommand> docking_command_{*this};
  Output<topic::InitialPose> initial_pose_{*this};
  Drive drive_{*this};

  vda5050::Gateway gateway_;
  vda5050::Publications publications_;
  vda5050::Vehicle vehicle_;
  std::optional<Time> heard_;  // when the router last told of the vehicle
  std::optional<GoalId> goal_;
  const vda5050::BrokerAddress address_;
  const vda5050::Connect connect_;
  std::unique_ptr<vda5050::Broker> broker_;  // from the first tick on
  std::string file_;                         // of the order, for a successor; empty: none is kept
  std::string saved_;
  std::uint64_t connections_ = 0;
  std::string trouble_;
};

}  // namespace tocsin
