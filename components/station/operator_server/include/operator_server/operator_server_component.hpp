// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "operator_server/host_picture.hpp"
#include "operator_server/hub.hpp"
#include "operator_server/mission_guard.hpp"
#include "operator_server/parameter_calls.hpp"
#include "operator_server/service_calls.hpp"
#include "operator_server/topic_ports.hpp"
#include "ros_idl/rcl_interfaces.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

namespace foxglove {
class WebServer;
struct WebPeer;
struct WebSettings;
}  // namespace foxglove

/// Serves the operator's page, and the topics, services and parameters of its host to any client of
/// the Foxglove WebSocket protocol. What it reads are the host's own copies: clients cost the radio
/// nothing.
class OperatorServerComponent final : public Component {
 public:
  struct Params {
    std::string address = "127.0.0.1";
    int port = 8765;
    std::string page;
    std::string token_file;
    foxglove::UserRole role = foxglove::UserRole::driver;
    std::string certificate;
    std::string key;
    std::vector<std::string> origins;
    std::vector<std::string> writable{
        "/goal",           "/emergency_stop/request", "/teleop/cmd_vel",
        "/teleop/request", "/mission/command",        "/docking/command",
        "/initialpose"};
    int backlog = 16;
    int most_connections = 64;
    double frame_mib = 1;
    double ping_s = 5;
    double time_s = 0.1;
    double service_timeout_s = 5;
    std::string vehicle;
    std::vector<std::string> fleet;
    std::string bags;
    std::vector<double> access_point;
    template <class Visitor>
    void visit(Visitor& v) {
      v("address", address, "IP address to listen at; beyond loopback a token and TLS are needed");
      v("port", port, {0, 65535}, "TCP port; 0: a free one");
      v("page", page, "folder of the page's files; empty: the installed package operator_page");
      v("token_file", token_file,
        "file with a line ROLE TOKEN, or TOKEN, for those who know the token; empty: none");
      visit_enum(v, "role", role, Choices{"observer", "operator", "supervisor"},
                 "of a token without a role, and of all clients when there is no token_file");
      v("certificate", certificate, "PEM file of TLS; empty: no TLS");
      v("key", key, "PEM file with the certificate's private key");
      v("origins", origins, "of other pages that may connect: https://app.foxglove.dev; *: any");
      v("writable", writable, "topics of its namespace, or patterns, on which clients may publish");
      v("backlog", backlog, {1, 1000}, "[1] messages of a topic that wait for a slow client");
      v("most_connections", most_connections, {1, 10000}, "[1] at the same time");
      v("frame_mib", frame_mib, {0.001, 64}, "[MiB] longest message of a client");
      v("ping_s", ping_s, {0.1, 600}, "[s] a silent client is asked; twice that: closed");
      v("time_s", time_s, {0.02, 60}, "[s] between the times that clients are told");
      v("service_timeout_s", service_timeout_s, {0.1, 600}, "[s] for services and parameters");
      v("vehicle", vehicle, "name of the vehicle, for the page; empty: none");
      v("fleet", fleet, "pages of all vehicles, for one page of all: uxv1=http://127.0.0.1:8761/");
      v("bags", bags, "folder whose bags the page can open; empty: that of the run");
      v("access_point", access_point, {-1e5, 1e5},
        "[m] x and y on the map, for the page; empty: that of the run's emulated radio");
    }
  };

  OperatorServerComponent(Context& context, const Params& params);
  /// With another way to look at the host; for tests.
  OperatorServerComponent(Context& context, const Params& params, foxglove::LookAtHost look);
  ~OperatorServerComponent() override;
  void tick(Time now) override;
  /// The port that it listens at; 0: it does not.
  [[nodiscard]] int port() const { return port_; }
  [[nodiscard]] std::size_t clients() const { return hub_.clients(); }
  /// Messages that slow clients missed, since the start.
  [[nodiscard]] std::uint64_t drops() const { return hub_.drops(); }

 private:
  void serve(Time now);
  void look(Time now);
  void take_states(Time now);
  void take_parameter_events();
  void do_periodic(Time now);
  void follow_clients();
  void send_waiting();
  void obey(const std::vector<foxglove::Order>& orders, Time now);
  struct Obey;

  void on_opened(foxglove::ClientId client, const foxglove::WebPeer& peer);
  void on_received(foxglove::ClientId client, foxglove::Frame::Kind kind, const std::string& bytes);
  void on_closed(foxglove::ClientId client, const std::string& why);

  const Params params_;
  foxglove::LookAtHost look_;
  foxglove::Hub hub_;
  foxglove::TopicPorts topics_{*this};
  foxglove::ServiceCalls services_;
  foxglove::ParameterCalls parameters_;
  OptionalInput<topic::ContainerState> containers_{*this};
  foxglove::MissionGuard guard_;
  std::optional<OptionalInput<topic::DriverState>> driver_;  ///< while there are clients
  std::unique_ptr<InputPort> parameter_events_;              ///< while a client hears parameters
  std::map<std::string, std::set<std::string>> nodes_;       ///< by container
  std::set<foxglove::ClientId> busy_;                        ///< with what was sent before
  std::set<foxglove::ClientId> open_;
  int port_ = 0;
  bool said_fault_ = false;
  Time next_try_{};
  Time next_look_{};
  Time next_time_{};
  Time next_report_{};
  std::unique_ptr<foxglove::WebServer> web_;  // last: its thread ends before the rest
};

}  // namespace tocsin
