// SPDX-License-Identifier: Apache-2.0
#include "server_settings.hpp"

#include <unistd.h>

#include <filesystem>

#include "access_point.hpp"
#include "command_line/programs.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/read_file.hpp"
#include "operator_server/fleet_pages.hpp"
#include "operator_server/host_picture.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/component_library.hpp"

namespace tocsin::foxglove {
namespace {

/// `1.8 1` for the page; empty: it is not known.
std::string access_point_text(const Context& context,
                              const OperatorServerComponent::Params& params) {
  const std::vector<double>& given = params.access_point;
  if (!given.empty() && given.size() != 2) {
    throw ConfigError(context.name + ".access_point: " + std::to_string(given.size()) +
                      " numbers are no place; x and y, or none");
  }
  if (!given.empty()) return shortest_text(given[0]) + " " + shortest_text(given[1]);
  if (!context.computer.get().has_spectators) return {};
  const auto point = access_point_of(context.run_dir);
  return point ? shortest_text(point->x_m) + " " + shortest_text(point->y_m) : std::string();
}

/// A file of another package, if that is installed; empty: it is not.
std::filesystem::path installed(const std::string& package, const std::string& file) {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  for (const auto& prefix : package_prefixes(prefix_paths(), program)) {
    for (const auto& path : {prefix / file, prefix.parent_path() / package / file}) {
      if (std::filesystem::exists(path, ignored)) return path;
    }
  }
  return {};
}

std::vector<AccessToken> tokens_in(const std::string& owner, const std::string& file,
                                   UserRole usual) {
  if (file.empty()) return {};
  constexpr std::size_t longest = 4096;
  return parse_tokens(owner + ".token_file: " + file, read_file(file, longest), usual);
}

}  // namespace

HubSettings hub_settings(const Context& context, const OperatorServerComponent::Params& params) {
  HubSettings settings;
  settings.server.name = "Tocsin";
  settings.server.session =
      std::to_string(context.bus.wall_ns(context.bus.now())) + "-" + std::to_string(::getpid());
  settings.server.metadata = {{"tocsin", TOCSIN_VERSION}, {"host", to_string(context.role)}};
  if (!params.vehicle.empty()) settings.server.metadata["vehicle"] = params.vehicle;
  const std::string fleet = fleet_text(fleet_pages(context.name, params.fleet));
  if (!fleet.empty()) settings.server.metadata["fleet"] = fleet;
  const std::string access_point = access_point_text(context, params);
  if (!access_point.empty()) settings.server.metadata["access_point"] = access_point;
  settings.backlog = static_cast<std::size_t>(params.backlog);
  const std::string& ros_namespace = context.bus.host_control().ros_namespace();
  if (!ros_namespace.empty()) settings.server.metadata["namespace"] = ros_namespace;
  for (const std::string& topic : params.writable) {
    settings.writable.push_back(writable_in(ros_namespace, topic));
  }
  return settings;
}

WebSettings web_settings(const Context& context, const OperatorServerComponent::Params& params) {
  const std::string& owner = context.name;
  if (params.certificate.empty() != params.key.empty()) {
    throw ConfigError(owner + ": certificate and key belong together; only one of them is given");
  }
  WebSettings settings;
  settings.access = {params.address, tokens_in(owner, params.token_file, params.role),
                     !params.certificate.empty(), params.origins, params.role};
  for (const FleetPage& page : fleet_pages(owner, params.fleet)) {
    settings.access.origins.push_back(page.origin);
  }
  check_access(owner, settings.access);
  settings.page =
      params.page.empty()
          ? installed("operator_page", "share/operator_page/index.html").parent_path().string()
          : params.page;
  settings.bags = params.bags.empty() ? context.run_dir : params.bags;
  if (!context.run_dir.empty()) {
    settings.recorded = context.run_dir + "/" + to_string(context.role);
    settings.decide = find_program("tocsin-decide", program_folders()).value_or("").string();
  }
  settings.certificate = params.certificate;
  settings.key = params.key;
  settings.most_connections = static_cast<std::size_t>(params.most_connections);
  settings.most_frame_bytes = static_cast<std::size_t>(params.frame_mib * 1024 * 1024);
  settings.ping_s = params.ping_s;
  return settings;
}

}  // namespace tocsin::foxglove
