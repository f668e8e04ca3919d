// SPDX-License-Identifier: Apache-2.0
#include "devices/wireless.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace tocsin::network {
namespace {

/// One number of the line. A dot says that the driver has renewed it since the last look.
struct Field {
  double value = 0;
  bool dotted = false;
};

/// The columns after the name: status (hexadecimal), link, level, noise, five discard counters,
/// missed beacons.
struct Line {
  Field link, level, noise;
  double discarded_retry = 0;
  double missed_beacons = 0;
};

std::optional<Field> parse_field(const std::string& word) {
  char* end = nullptr;
  Field field;
  field.value = std::strtod(word.c_str(), &end);
  // "22." is 22 with the mark; strtod swallows the dot.
  field.dotted = !word.empty() && word.back() == '.';
  const bool whole = end == word.c_str() + word.size() && !word.empty();
  if (!whole || !std::isfinite(field.value)) return std::nullopt;
  return field;
}

std::optional<Line> parse_line(const std::string& columns) {
  std::istringstream in(columns);
  std::string status;
  if (!(in >> status)) return std::nullopt;
  std::vector<Field> fields;
  for (std::string word; in >> word;) {
    const auto field = parse_field(word);
    if (!field) return std::nullopt;
    fields.push_back(*field);
  }
  if (fields.size() < 9) return std::nullopt;
  return Line{fields[0], fields[1], fields[2], fields[6].value, fields[8].value};
}

/// The text after "name:" of the interface's line.
std::optional<std::string> columns_of(const std::string& text, const std::string& interface) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const auto first = line.find_first_not_of(' ');
    if (first == std::string::npos || line.compare(first, interface.size(), interface) != 0)
      continue;
    const auto colon = first + interface.size();
    if (colon < line.size() && line[colon] == ':') return line.substr(colon + 1);
  }
  return std::nullopt;
}

std::optional<double> dbm(const Field& field) {
  constexpr double invalid = -256;  // "no value" less 0x100, as wext-proc.c prints it
  if (field.value >= 0 || field.value <= invalid) return std::nullopt;
  return field.value;
}

std::optional<std::uint64_t> counter(double value) {
  if (value < 0) return std::nullopt;
  return static_cast<std::uint64_t>(std::min(value, 1e18));
}

bool is_silent(const Line& line) {
  const auto empty = [](const Field& f) { return f.value == 0 && !f.dotted; };
  return empty(line.link) && empty(line.level) && empty(line.noise);
}

WirelessReading to_reading(const Line& line) {
  WirelessReading reading;
  reading.source = WirelessSource::proc;
  reading.associated = !is_silent(line);
  if (!reading.associated) {
    reading.note = "not associated";
    return reading;
  }
  reading.signal_dbm = dbm(line.level);
  reading.noise_dbm = dbm(line.noise);
  if (reading.signal_dbm) {
    reading.quality = std::clamp(line.link.value, 0.0, link_quality_max);
  } else {
    reading.note = "the driver gives no signal in dBm";
  }
  reading.tx_failed = counter(line.discarded_retry);
  reading.beacon_loss = counter(line.missed_beacons);
  return reading;
}

}  // namespace

const char* name(WirelessSource source) {
  switch (source) {
    case WirelessSource::proc:
      return "proc";
    case WirelessSource::nl80211:
      return "nl80211";
    case WirelessSource::absent:
      break;
  }
  return "absent";
}

double link_quality(double signal_dbm) {
  if (std::isnan(signal_dbm)) return 0;
  return std::clamp(signal_dbm, -110.0, -40.0) + 110.0;
}

WirelessReading absent(std::string note) {
  WirelessReading reading;
  reading.note = std::move(note);
  return reading;
}

WirelessReading WirelessDevice::read() { return absent("nothing is known of it"); }

WirelessReading parse_proc_wireless(const std::string& text, const std::string& interface) {
  const auto columns = columns_of(text, interface);
  if (!columns) return absent(interface + " is not a wireless interface");
  const auto line = parse_line(*columns);
  if (!line) return absent("the line of " + interface + " cannot be read");
  return to_reading(*line);
}

}  // namespace tocsin::network
