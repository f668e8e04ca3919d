// SPDX-License-Identifier: Apache-2.0
#include "container/health_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "foundation/free_space.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "runtime/host_control.hpp"
#include "watch/resident_memory.hpp"

namespace tocsin {
namespace {

using namespace diagnostic_msgs::msg::DiagnosticStatus_Constants;

/// Keeps the gravest finding as the message.
class Finding {
 public:
  Finding(const std::string& name, const std::string& fine) {
    status_.name(name);
    status_.level(OK);
    status_.message(fine);
  }
  void grade(std::uint8_t level, const std::string& message) {
    if (level <= status_.level()) return;
    status_.level(level);
    status_.message(message);
  }
  template <class Value>
  void value(const std::string& key, const Value& value) {
    diagnostic_msgs::msg::KeyValue pair;
    pair.key(key);
    pair.value(fmt::format("{}", value));
    status_.values().push_back(std::move(pair));
  }
  [[nodiscard]] const Diagnostic& status() const { return status_; }

 private:
  Diagnostic status_;
};

std::string seconds_text(Duration d) { return fmt::format("{:.6f}", to_seconds(d)); }

/// Samples that `port` dropped since `before`.
std::uint64_t drops_since(const PortHealth& port, const std::vector<PortHealth>& before) {
  for (const PortHealth& one : before) {
    if (one.topic == port.topic) return port.dropped - std::min(one.dropped, port.dropped);
  }
  return port.dropped;
}

void judge_ticks(const InstanceHealth& instance, const HealthLimits& limits, Finding& finding) {
  const TickFigures& ticks = instance.now.ticks;
  const Duration running =
      ticks.running_since ? instance.now.at - *ticks.running_since : Duration::zero();
  const double longest_s = to_seconds(std::max(running, ticks.longest));
  if (to_seconds(running) > limits.blocked_tick_s) {
    finding.grade(ERROR,
                  fmt::format("blocks: a tick has been running for {:.1f} s", to_seconds(running)));
  }
  if (longest_s > limits.slow_tick_s) {
    finding.grade(WARN, fmt::format("slow: a tick took {:.3f} s", longest_s));
  }
  const std::uint64_t overruns = instance.now.overruns - instance.before.overruns;
  const std::uint64_t count = ticks.ticks - instance.before.ticks.ticks;
  if (static_cast<double>(overruns) >
      limits.overrun_share * static_cast<double>(count + overruns)) {
    finding.grade(WARN, fmt::format("late: {} periods skipped", overruns));
  }
}

void add_ticks(const InstanceHealth& instance, Finding& finding) {
  const TickFigures& ticks = instance.now.ticks;
  const TickFigures& before = instance.before.ticks;
  const std::uint64_t count = ticks.ticks - before.ticks;
  const double window_s = to_seconds(instance.now.at - instance.before.at);
  const double rate = window_s > 0 ? static_cast<double>(count) / window_s : 0.0;
  finding.value("rate_hz", fmt::format("{:.2f}", rate));
  finding.value("ticks", ticks.ticks);
  finding.value("overruns", instance.now.overruns);
  const auto divisor = static_cast<Duration::rep>(std::max<std::uint64_t>(count, 1));
  finding.value("tick_mean_s", seconds_text((ticks.total - before.total) / divisor));
  finding.value("tick_p99_s", seconds_text(ticks.quantile(0.99, before)));
  finding.value("tick_max_s", seconds_text(ticks.longest));
}

void add_ports(const InstanceHealth& instance, Finding& finding) {
  for (const PortHealth& port : instance.now.ports) {
    const std::uint64_t dropped = drops_since(port, instance.before.ports);
    if (dropped > 0) {
      finding.grade(WARN, fmt::format("flooded: {} samples of {} dropped", dropped, port.topic));
    }
    finding.value(port.topic + ".received", port.received);
    finding.value(port.topic + ".dropped", port.dropped);
    finding.value(port.topic + ".depth", port.depth);
    finding.value(port.topic + ".age_s",
                  port.last == Time{}
                      ? "never"
                      : fmt::format("{:.3f}", to_seconds(instance.now.at - port.last)));
  }
}

void judge_disk(const ProcessFigures& process, const HealthLimits& limits, Finding& finding) {
  const double room = static_cast<double>(*process.free_bytes) / mib;
  const std::string disk = "disk of " + printable(process.run_dir, 100);
  if (*process.free_bytes < full_below_bytes) {
    finding.grade(ERROR, disk + " is full: recordings and logs are lost");
  }
  if (room < limits.disk_low_mib) {
    finding.grade(WARN, fmt::format("{} has {:.0f} MiB left", disk, room));
  }
  finding.value("disk_free_mib", fmt::format("{:.1f}", room));
}

}  // namespace

Diagnostic diagnose(const std::string& container, const InstanceHealth& instance,
                    const HealthLimits& limits) {
  Finding finding(container + "/" + instance.name, instance.state);
  if (instance.state == "error") finding.grade(ERROR, "threw: " + instance.error);
  if (!instance.twin.empty()) {
    finding.grade(ERROR, "two nodes of one name: also in container " + instance.twin);
  }
  finding.value("state", instance.state);
  if (instance.state == "active") judge_ticks(instance, limits, finding);
  add_ticks(instance, finding);
  add_ports(instance, finding);
  return finding.status();
}

Diagnostic diagnose(const std::string& container, const ProcessFigures& process,
                    const HealthLimits& limits) {
  const double resident = static_cast<double>(process.bytes) / mib;
  const double growth = resident - static_cast<double>(process.first_bytes) / mib;
  Finding finding(container, "running");
  if (process.finding) finding.grade(ERROR, *process.finding);
  if (process.free_bytes) judge_disk(process, limits, finding);
  if (resident > limits.resident_mib) {
    finding.grade(
        WARN, fmt::format("{:.0f} MiB resident, more than {:.0f}", resident, limits.resident_mib));
  }
  if (growth > limits.growth_mib) {
    finding.grade(WARN, fmt::format("leaks: resident memory grew by {:.0f} MiB", growth));
  }
  finding.value("resident_mib", fmt::format("{:.1f}", resident));
  finding.value("growth_mib", fmt::format("{:.1f}", growth));
  return finding.status();
}

namespace {

using rtps_filter::DropAccount;
using rtps_filter::DropReason;

/// "gap_range 12, fragment 3": reasons with their counts.
std::string reasons_text(const DropAccount::ByReason& counts) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    parts.push_back(fmt::format("{} {}", to_text(static_cast<DropReason>(i)), counts[i]));
  }
  return joined(parts, ", ");
}

}  // namespace

Diagnostic diagnose(const std::string& container, const DropAccount& dropped,
                    const DropAccount& before) {
  constexpr std::size_t named = 3;  // sources in the message; the values have all
  Finding finding(container + "/packets dropped", "past events");
  const DropAccount grown = dropped.since(before);
  std::vector<std::string> sources;
  for (const auto& [address, counts] : grown.by_source()) {
    if (sources.size() == named) break;
    sources.push_back(rtps_filter::to_text(address) + ": " + reasons_text(counts));
  }
  if (grown.total() > 0) {
    finding.grade(WARN,
                  fmt::format("{} packets dropped, from {}", grown.total(), joined(sources, "; ")));
  }
  finding.value("dropped", dropped.total());
  for (std::size_t i = 0; i < rtps_filter::drop_reasons; ++i) {
    const auto reason = static_cast<DropReason>(i);
    if (dropped.count(reason) > 0) {
      finding.value(std::string(to_text(reason)), dropped.count(reason));
    }
  }
  for (const auto& [address, counts] : dropped.by_source()) {
    finding.value("from " + rtps_filter::to_text(address), reasons_text(counts));
  }
  return finding.status();
}

Diagnostic diagnose(const std::string& container, const RefusedNames& refused,
                    const RefusedNames& before) {
  constexpr std::size_t named = 3;  // in the message; the values have all
  Finding finding(container + "/link refused", "past events");
  std::vector<std::string> grown;
  for (const auto& [line, count] : refused.lines()) {
    const auto then = before.lines().find(line);
    const bool grew = then == before.lines().end() || then->second < count;
    if (grew && grown.size() < named) grown.push_back(line);
    finding.value(line, count);
  }
  if (!grown.empty()) {
    finding.grade(WARN, fmt::format("{} refused on the link: {}", refused.total() - before.total(),
                                    joined(grown, ", ")));
  }
  return finding.status();
}

bool is_eventful(const EndpointHealth& endpoint) {
  // A misfit or another type is a state, the counts are a history.
  return endpoint.lost + endpoint.rejected + endpoint.incompatible_qos + endpoint.deadlines_missed +
                 endpoint.liveliness_lost >
             0 ||
         !endpoint.other_type.empty() || !endpoint.misfit.empty();
}

Diagnostic diagnose(const std::string& container, const EndpointHealth& endpoint,
                    const EndpointHealth& before) {
  Finding finding(container + "/" + endpoint.topic + (endpoint.writer ? " writer" : " reader"),
                  endpoint.matched > 0 ? "matched, with past events" : "past events");
  if (!endpoint.other_type.empty()) {
    finding.grade(ERROR, "another end has the type " + endpoint.other_type);
  }
  if (!endpoint.misfit.empty()) finding.grade(ERROR, "incompatible QoS: " + endpoint.misfit);
  const auto grew = [&](std::uint64_t now, std::uint64_t then, const char* what) {
    if (now > then) finding.grade(WARN, fmt::format("{} {}", now - then, what));
  };
  grew(endpoint.rejected, before.rejected, "samples were not of the topic's type");
  grew(endpoint.lost, before.lost, "samples lost");
  grew(endpoint.deadlines_missed, before.deadlines_missed, "deadlines missed");
  grew(endpoint.liveliness_lost, before.liveliness_lost, "times a writer fell silent");
  finding.value("samples", endpoint.samples);
  finding.value("matched", endpoint.matched);
  finding.value("lost", endpoint.lost);
  finding.value("rejected", endpoint.rejected);
  finding.value("incompatible_qos", endpoint.incompatible_qos);
  finding.value("deadlines_missed", endpoint.deadlines_missed);
  finding.value("liveliness_lost", endpoint.liveliness_lost);
  return finding.status();
}

}  // namespace tocsin
