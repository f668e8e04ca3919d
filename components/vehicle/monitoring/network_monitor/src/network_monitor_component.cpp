// SPDX-License-Identifier: Apache-2.0
#include "network_monitor/network_monitor_component.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

using Message = topic::NetworkQuality::Message;

/// Headers of an echo request (RFC 791, RFC 792).
constexpr std::size_t ip_and_icmp_bytes = 20 + 8;

/// NaN is how the message says "not told".
float or_nan(const std::optional<double>& value) {
  return value ? static_cast<float>(*value) : std::numeric_limits<float>::quiet_NaN();
}

void put_probes(const network::ProbeSample& sample, Message& message) {
  message.per_percent(static_cast<float>(sample.per_percent));
  message.probes_sent(static_cast<std::uint32_t>(sample.sent));
  message.probes_received(static_cast<std::uint32_t>(sample.received));
  const auto rtt = [&sample](double network::RttSummary::*field) {
    return or_nan(sample.rtt ? std::optional((*sample.rtt).*field) : std::nullopt);
  };
  message.rtt_min_ms(rtt(&network::RttSummary::min_ms));
  message.rtt_mean_ms(rtt(&network::RttSummary::mean_ms));
  message.rtt_max_ms(rtt(&network::RttSummary::max_ms));
}

void put_wireless(const network::WirelessReading& reading, const network::WirelessRates& rates,
                  Message& message) {
  message.signal_dbm(or_nan(reading.signal_dbm));
  message.noise_dbm(or_nan(reading.noise_dbm));
  message.quality_percent(or_nan(reading.quality));
  if (reading.quality) {
    message.quality_percent(
        static_cast<float>(100.0 * *reading.quality / network::link_quality_max));
  }
  message.retry_percent(or_nan(rates.retry_percent));
  message.busy_percent(or_nan(rates.busy_percent));
  message.wireless_source(network::name(reading.source));
}

void check_sites(const NetworkMonitorComponent::Params& params) {
  if (params.sites.size() == params.site_targets.size()) return;
  throw ConfigError("site_targets: " + std::to_string(params.site_targets.size()) +
                    " addresses for " + std::to_string(params.sites.size()) +
                    " sites; each of `sites` has one");
}

/// Of the first path, where there are two. Without anybody who acknowledges all is lost.
double loss_in(const topic::LinkState::Message& state) {
  if (state.live_peers() == 0) return 1;
  if (state.paths().empty()) return static_cast<double>(state.loss());
  const auto& first = state.paths().front();
  return first.silent() ? 1 : static_cast<double>(first.loss());
}

std::unique_ptr<network::WirelessDevice> open_wireless(
    const Devices& devices, const NetworkMonitorComponent::Params& params) {
  if (params.interface_name.empty()) return nullptr;
  return devices.open<network::WirelessDevice>({params.interface_name, params.wireless_file});
}

}  // namespace

NetworkMonitorComponent::NetworkMonitorComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      devices_(context.devices()),
      probe_period_(seconds(params.probe.period_s)),
      probe_size_(ip_and_icmp_bytes + static_cast<std::size_t>(params.payload_bytes)),
      window_(params.probe),
      wireless_(open_wireless(context.devices(), params)) {
  check_sites(params);
  if (params.loss_from == network::LossSource::probes) {
    begin_probing();
  } else {
    routers_.emplace(*this);
  }
}

void NetworkMonitorComponent::begin_probing() {
  if (params_.sites.size() > 1) site_.emplace(*this);
  for (const std::string& one : params_.site_targets) probe(one);  // one that is none throws now
  probe(params_.target);
}

/// Opens the target first: one that is no address changes nothing.
void NetworkMonitorComponent::probe(const std::string& target) {
  const EchoTarget to{target, static_cast<std::size_t>(params_.payload_bytes),
                      static_cast<std::uint8_t>(params_.dscp)};
  auto echo = devices_.open<EchoDevice>(to, when_readable());
  if (echo_) forget(echo_->descriptor());
  echo_ = std::move(echo);
  wake_on(echo_->descriptor());
  target_ = target;
}

/// What was sent to one site says nothing of the way to another.
void NetworkMonitorComponent::follow_site() {
  std::string site;
  while (const auto message = site_->take()) site = message->data();
  const auto found = std::find(params_.sites.begin(), params_.sites.end(), site);
  if (found == params_.sites.end()) return;
  const std::string& target =
      params_.site_targets[static_cast<std::size_t>(std::distance(params_.sites.begin(), found))];
  if (target == target_) return;
  probe(target);
  window_.forget();
  log().info("probes go to {}, {}", site, target);
}

void NetworkMonitorComponent::tick(Time now) { routers_ ? tick_routers(now) : tick_probes(now); }

void NetworkMonitorComponent::tick_routers(Time now) {
  using Side = network::ReportedLoss::Side;
  while (const auto state = routers_->take()) {
    const bool is_own = role_of(state->role()) == context().role;
    loss_.on_report(is_own ? Side::own : Side::other, loss_in(*state), now);
  }
  if (!next_sample_ || now >= *next_sample_) {
    if (const auto per = loss_.per_percent(now)) publish({*per, 0, 0, std::nullopt}, now);
    next_sample_ = next_instant(seconds(params_.probe.sample_period_s), now);
  }
  wake_at(*next_sample_);
}

void NetworkMonitorComponent::tick_probes(Time now) {
  if (site_) follow_site();
  if (!has_begun(now)) return wake_at(*begin_);
  while (const auto reply = echo_->receive()) {
    (void)window_.on_reply(reply->sequence, reply->received_at);
  }
  send_due(now);
  if (const auto sample = window_.take_sample(now)) publish(*sample, now);
  wake_at(window_.next_deadline());
}

/// Probes go at instants of this component's own.
bool NetworkMonitorComponent::has_begun(Time now) {
  if (!begin_) begin_ = next_instant(probe_period_, now);
  return now >= *begin_;
}

void NetworkMonitorComponent::send_due(Time now) {
  const auto sequence = window_.take_due(now);
  if (!sequence) return;
  const SendResult result = echo_->send(*sequence);
  if (result.error == 0) {
    window_.on_sent(*sequence, result.at);
    probe_bytes_ += probe_size_;
  } else {
    window_.on_send_error(*sequence);
  }
  if (result.error == send_error_) return;
  send_error_ = result.error;
  if (send_error_ == 0) {
    log().info("probes leave again");
  } else {
    log().warn("probes do not leave: {}", std::strerror(send_error_));
  }
}

void NetworkMonitorComponent::publish(const network::ProbeSample& sample, Time now) {
  const network::WirelessReading reading = read_wireless();
  report_change(reading);
  Message message;
  message.stamp(wall(now));
  put_probes(sample, message);
  put_wireless(reading, trend_.update(reading), message);
  message.interface_name(params_.interface_name);
  message.probe_bytes(probe_bytes_);
  if (quality_.write(std::move(message)) == Status::failed) log().warn("a sample was not sent");
}

network::WirelessReading NetworkMonitorComponent::read_wireless() {
  return wireless_ ? wireless_->read() : network::absent("no interface is configured");
}

void NetworkMonitorComponent::report_change(const network::WirelessReading& reading) {
  std::string text = std::string(network::name(reading.source)) +
                     (reading.note.empty() ? "" : ": " + reading.note);
  if (text == reported_) return;
  log().info("wireless readings of {}: {}", params_.interface_name, text);
  reported_ = std::move(text);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::NetworkMonitorComponent)
