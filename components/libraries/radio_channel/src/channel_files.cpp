// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/channel_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_extends.hpp"
#include "foundation/yaml_file.hpp"
#include "radio_channel/outages.hpp"

namespace tocsin::radio {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line.substr(0, line.find('\r')));
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

/// The number of a cell; NaN when it is empty, missing or no number.
double cell_number(const std::vector<std::string>& cells, std::size_t column) {
  if (column >= cells.size() || cells[column].empty()) return std::nan("");
  char* end = nullptr;
  const double value = std::strtod(cells[column].c_str(), &end);
  return *end == '\0' ? value : std::nan("");
}

std::size_t column_of(const std::vector<std::string>& head, const char* name,
                      const std::string& path) {
  const auto found = std::find(head.begin(), head.end(), name);
  if (found == head.end()) {
    throw ConfigError(std::string("radio_channel.trace_file: has no column ") + name + " (" + path +
                      ":1)");
  }
  return static_cast<std::size_t>(found - head.begin());
}

YAML::Node read_with_bases(const std::string& path, YamlSources& sources) {
  return read_extended(path, {std::filesystem::absolute(path).parent_path()}, sources);
}

ChannelParams read_channel(const std::string& path) {
  YamlSources sources;
  const YAML::Node file = read_with_bases(path, sources);
  if (!file.IsMap() || !file["radio_channel"] || file.size() != 1) {
    throw ConfigError("radio_channel: must be the one key of the file" + yaml_place(sources, file));
  }
  const YAML::Node node = file["radio_channel"];
  auto params = load_parameters<ChannelParams>(node, "radio_channel", sources);
  if (!params.trace_file.empty()) {
    params.trace_file = sources.path(node["trace_file"], params.trace_file);
  }
  (void)Outages(params.outages_s, Time{});  // throws on a bad script
  return params;
}

}  // namespace

Trace load_trace(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw ConfigError("radio_channel.trace_file: '" + path + "' cannot be read");
  std::string line;
  std::getline(file, line);
  const auto head = cells_of(line);
  const std::size_t time = column_of(head, "time_s", path);
  const std::size_t signal = column_of(head, "rssi_dbm", path);
  const std::size_t delay = column_of(head, "ping_delay_ms", path);
  std::vector<TracePoint> points;
  while (std::getline(file, line)) {
    const auto cells = cells_of(line);
    points.push_back(
        {cell_number(cells, time), cell_number(cells, signal), cell_number(cells, delay) / 1000});
  }
  try {
    return Trace(std::move(points));
  } catch (const ConfigError& error) {
    throw ConfigError(std::string(error.what()) + " (" + path + ")");
  }
}

std::vector<std::string> channel_sources(const std::string& path) {
  YamlSources sources;
  (void)read_with_bases(path, sources);
  return sources.files();
}

ChannelParams load_channel(const std::string& path) {
  static FileCache<ChannelParams> known;
  static FileCache<std::shared_ptr<const Trace>> known_traces;
  ChannelParams params = known.get(path, [&] { return read_channel(path); });
  if (!params.trace_file.empty()) {
    const std::string& trace = params.trace_file;
    params.trace =
        known_traces.get(trace, [&] { return std::make_shared<const Trace>(load_trace(trace)); });
  }
  return params;
}

}  // namespace tocsin::radio
