// SPDX-License-Identifier: Apache-2.0
#include "save.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/role.hpp"
#include "map_ports/map_input.hpp"
#include "navigation/map_writer.hpp"

namespace tocsin::map_tool {
namespace {

constexpr auto look_period = std::chrono::milliseconds(20);

class MapListener final : public Component {
 public:
  using Component::Component;
  void tick(Time) override { (void)map_.take(); }
  [[nodiscard]] std::optional<navigation::OccupancyMap> map() const { return map_.map(); }

 private:
  MapInput map_{*this};
};

navigation::OccupancyMap map_of(const SaveOptions& options) {
  const auto bus = open_host_bus(options.host, "tocsin_map");
  Context context(*bus, "tocsin_map", Role::uxv);
  MapListener listener(context);
  const Time give_up_at = bus->now() + seconds(options.wait_s);
  while (bus->now() < give_up_at) {
    std::this_thread::sleep_for(look_period);
    listener.tick(bus->now());
    if (auto map = listener.map()) return *std::move(map);
  }
  throw EnvironmentError(fmt::format(
      "no map came within {:g} s on topic map of this host: a mapper or a map_server publishes it",
      options.wait_s));
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

}  // namespace

std::string save(const SaveOptions& options) {
  for (const char* ending : {".yaml", ".pgm"}) {
    if (options.overwrite || !exists(options.name + ending)) continue;
    throw ConfigError(printable(options.name) + ending +
                      ": is there already; --overwrite replaces it");
  }
  const navigation::OccupancyMap map = map_of(options);
  navigation::write_map(map, options.name);
  const navigation::Grid& grid = map.grid();
  return fmt::format("saved {0}.yaml and {0}.pgm: {1} x {2} cells of {3:g} m\n",
                     printable(options.name), grid.width, grid.height,
                     static_cast<float>(grid.resolution_m));
}

void go_on(const ContinueOptions& options) {
  const std::string name = std::filesystem::absolute(options.name).string();
  const std::string session = name + ".session";
  if (!exists(session)) {
    throw ConfigError(printable(session) + ": is not there; a mapper saves it beside NAME.yaml");
  }
  std::vector<std::string> words{"tocsin",
                                 "launch",
                                 "mapping.yaml",
                                 "--set",
                                 "mapper.map_name=" + name,
                                 "--set",
                                 "mapper.session_file=" + session};
  if (options.by_hand) words.insert(words.end(), {"--set", "explorer.autostart=false"});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execvp("tocsin", arguments.data());
  throw EnvironmentError("tocsin: cannot be started: " +
                         std::error_code(errno, std::generic_category()).message());
}

}  // namespace tocsin::map_tool
