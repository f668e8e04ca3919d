// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/channel_files.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "foundation/csv_table.hpp"
#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_extends.hpp"
#include "foundation/yaml_file.hpp"
#include "radio_channel/outages.hpp"

namespace tocsin::radio {
namespace {

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
  if (!std::ifstream(path)) {
    throw ConfigError("radio_channel.trace_file: '" + path + "' cannot be read");
  }
  const CsvTable table = CsvTable::read(path);
  for (const char* column : {"time_s", "rssi_dbm", "ping_delay_ms"}) {
    if (table.has(column)) continue;
    throw ConfigError(std::string("radio_channel.trace_file: has no column ") + column + " (" +
                      path + ":1)");
  }
  std::vector<TracePoint> points;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    points.push_back({table.number(row, "time_s"), table.number(row, "rssi_dbm"),
                      table.number(row, "ping_delay_ms") / 1000});
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
