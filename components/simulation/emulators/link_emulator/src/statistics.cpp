// SPDX-License-Identifier: Apache-2.0
#include "statistics.hpp"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "foundation/error.hpp"

namespace tocsin::link {
namespace {

using Json = nlohmann::ordered_json;

/// Two decimals; null for NaN.
Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * 100) / 100;
}

Json categories(const radio::DirectionReport& report) {
  Json all;
  for (const radio::AccessCategory one : radio::access_categories) {
    const radio::PacketCounts& counts = report.categories[static_cast<std::size_t>(one)];
    all[radio::to_string(one)] = {{"pushed", counts.pushed},
                                  {"delivered", counts.delivered},
                                  {"queue_drops", counts.queue_drops},
                                  {"losses", counts.losses}};
  }
  return all;
}

Json direction(const radio::DirectionReport& report) {
  return {{"pushed", report.pushed},
          {"delivered", report.delivered},
          {"queue_drops", report.queue_drops},
          {"losses", report.losses},
          {"categories", categories(report)},
          {"bytes_pushed", report.bytes_pushed},
          {"bytes_delivered", report.bytes_delivered},
          {"queued", report.queued},
          {"attempts", report.air.attempts},
          {"retries", report.air.retries},
          {"failed", report.air.failed},
          {"airtime_s", std::round(to_seconds(report.air.airtime) * 1e6) / 1e6}};
}

}  // namespace

std::string stats_line(double elapsed_s, const radio::LinkReport& report,
                       const EmulatorCounters& counters) {
  const Json line{{"elapsed_s", std::round(elapsed_s * 1000) / 1000},
                  {"x_m", number(report.x_m)},
                  {"y_m", number(report.y_m)},
                  {"associated", report.associated},
                  {"rssi_dbm", number(report.rssi_dbm)},
                  {"rssi_mean_dbm", number(report.rssi_mean_dbm)},
                  {"noise_dbm", number(report.noise_dbm)},
                  {"quality", report.quality},
                  {"mean_snr_db", number(report.mean_snr_db)},
                  {"busy_share", std::round(report.busy_share * 1000) / 1000},
                  {"uplink", direction(report.uplink)},
                  {"downlink", direction(report.downlink)},
                  {"commands", counters.commands},
                  {"bad_commands", counters.bad_commands},
                  {"write_errors", counters.write_errors},
                  {"late_ms", number(1000 * to_seconds(counters.late))}};
  return line.dump();
}

std::string wireless_head() {
  return "Inter-| sta-|   Quality        |   Discarded packets               | Missed | WE\n"
         " face | tus | link level noise |  nwid  crypt   frag  retry   misc | beacon | 22\n";
}

std::string wireless_text(const std::string& interface, const radio::LinkReport& report) {
  char line[160];
  const char* format =
      report.associated
          ? "%6s: 0000  %3d.  %3ld.  %3d        0      0      0 %6llu      0        0\n"
          : "%6s: 0000  %3d   %3ld   %3d        0      0      0 %6llu      0        0\n";
  std::snprintf(line, sizeof line, format, interface.c_str(), report.quality,
                report.associated ? std::lround(report.rssi_dbm) : 0L, report.associated ? -256 : 0,
                static_cast<unsigned long long>(report.associated ? report.uplink.air.failed : 0));
  return wireless_head() + line;
}

StatsFile::StatsFile(const std::string& path) : file_(path, std::ios::app) {
  if (!file_) throw ConfigError("--stats " + path + ": " + std::strerror(errno));
}

void StatsFile::append(const std::string& line) {
  file_.clear();  // a disk that was full may have room again
  file_ << line << '\n' << std::flush;
}

}  // namespace tocsin::link
