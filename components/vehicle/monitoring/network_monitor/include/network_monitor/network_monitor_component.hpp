// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/devices.hpp"
#include "devices/echo_device.hpp"
#include "foundation/enum_words.hpp"
#include "foundation/traffic_class.hpp"
#include "network_monitor/probe_window.hpp"
#include "network_monitor/reported_loss.hpp"
#include "network_monitor/wireless_trend.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Measures the radio link, and reports it once a second.
class NetworkMonitorComponent final : public Component {
 public:
  struct Params {
    network::LossSource loss_from = network::LossSource::probes;
    std::string target;
    std::vector<std::string> sites;
    std::vector<std::string> site_targets;
    int payload_bytes = 64;
    int dscp = tocsin::dscp(TrafficClass::low);
    std::string interface_name = "wlan0";
    std::string wireless_file = "/proc/net/wireless";
    network::ProbeParams probe;

    template <class Visitor>
    void visit(Visitor& v) {
      visit_enum(v, "loss_from", loss_from, Choices{"probes", "routers"},
                 "whose the PER is: of own echo probes, or of what the routers of both sides send, "
                 "which costs no air; then no probe is sent, and there is no round-trip time");
      v("target", target,
        "IPv4 address to probe; in a bringup file the first peer of its host, unless it is set");
      v("sites", sites, "names of the sites of this host, where there are several; as `target`");
      v("site_targets", site_targets, "IPv4 address to probe while it speaks with each of them");
      v("payload_bytes", payload_bytes, {8, 1400}, "[byte] payload of a probe, as of ping -s");
      v("dscp", dscp, {0, 63},
        "[1] DSCP of probes: class low's, so that the PER is what class low meets");
      v("interface_name", interface_name, "wireless interface to read; empty: the radio is absent");
      v("wireless_file", wireless_file, "second source, in the format of /proc/net/wireless");
      probe.visit(v);
    }
  };

  /// ConfigError when a target is not an IPv4 address or a site has none, EnvironmentError without
  /// ICMP sockets, when it probes.
  NetworkMonitorComponent(Context& context, const Params& params);
  void set_parameters(const Params& params) { window_.set_limits(params.probe); }
  void tick(Time now) override;

 private:
  void begin_probing();
  void tick_probes(Time now);
  void tick_routers(Time now);
  void follow_site();
  void probe(const std::string& target);
  [[nodiscard]] bool has_begun(Time now);
  void send_due(Time now);
  void publish(const network::ProbeSample& sample, Time now);
  [[nodiscard]] network::WirelessReading read_wireless();
  void report_change(const network::WirelessReading& reading);

  Output<topic::NetworkQuality> quality_{*this};
  const Params params_;
  const Devices devices_;
  std::optional<OptionalInput<topic::LinkState>> routers_;  ///< whose word the loss is
  network::ReportedLoss loss_;
  std::optional<Time> next_sample_;                     ///< of what they say
  std::optional<OptionalInput<topic::LinkSite>> site_;  ///< where there are several
  std::string target_;                                  ///< of echo_
  std::unique_ptr<EchoDevice> echo_;
  const Duration probe_period_;
  const std::size_t probe_size_;   ///< [B] with IP header
  std::uint64_t probe_bytes_ = 0;  ///< of those that have left
  std::optional<Time> begin_;      ///< of probing
  network::ProbeWindow window_;
  std::unique_ptr<network::WirelessDevice> wireless_;  ///< null: no interface is configured
  network::WirelessTrend trend_;
  std::string reported_;
  int send_error_ = 0;
};

}  // namespace tocsin
