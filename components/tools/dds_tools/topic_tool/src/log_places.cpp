// SPDX-License-Identifier: Apache-2.0
#include "log_places.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "command_line/stop_signal.hpp"
#include "deployment/running_host.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"

namespace tocsin::topic_tool {
namespace {

constexpr Duration retry_period = std::chrono::milliseconds(50);
constexpr double ns_per_s = 1e9;

Time steady_now() { return std::chrono::steady_clock::now(); }

}  // namespace

sample_log::LogStart LogWish::start(std::int64_t wall_ns) const {
  using From = sample_log::LogStart::From;
  if (last) return {From::last, *last};
  if (from_start) return {From::beginning};
  if (!since_s) return {From::end};
  const auto ago_ns = static_cast<std::int64_t>(*since_s * ns_per_s);
  return {From::time, static_cast<std::uint64_t>(std::max<std::int64_t>(wall_ns - ago_ns, 0))};
}

std::string store_folder(const deployment::RunningHost& host, const std::string& vehicle) {
  for (const auto& container : host.itself().containers) {
    for (const auto& component : container.components) {
      if (component.component != "link_router") continue;
      const YAML::Node folder = (*component.parameters)["store_directory"];
      if (folder.IsDefined() && !folder.Scalar().empty()) return folder.Scalar();
    }
  }
  const auto part = part_of(host.deployment, vehicle.empty() ? host.host : vehicle);
  return folder_of(part, host.itself()) + "/" + to_string(host.itself().role) + "/store";
}

std::vector<std::string> folders_in(const std::string& store) {
  return {store, store + "/history"};
}

std::string folder_with(const std::vector<std::string>& folders, const std::string& topic,
                        Duration patience) {
  const Time end = steady_now() + patience;
  std::set<std::string> others;
  do {
    for (const std::string& folder : folders) {
      const auto topics = sample_log::topics_in(sample_log::FolderSource(folder));
      if (topics.count(topic) != 0) return folder;
      others.insert(topics.begin(), topics.end());
    }
    sleep_until_stopped(steady_now() + retry_period);
  } while (steady_now() < end && !is_stopped());
  throw ConfigError("the log in " + printable(folders.front()) + " has nothing of " +
                    printable(topic) +
                    (others.empty() ? "" : "; it has " + joined({others.begin(), others.end()})) +
                    " (lists store, log and keep of the traffic file)");
}

}  // namespace tocsin::topic_tool
