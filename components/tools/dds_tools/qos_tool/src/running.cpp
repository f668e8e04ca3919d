// SPDX-License-Identifier: Apache-2.0
#include "running.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <set>

#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "foundation/spelling.hpp"
#include "runtime/middleware/container_states.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "runtime/middleware/qos_change.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/middleware/service_caller.hpp"

namespace tocsin::qos_tool {
namespace {

using composition_service::SetQos;

constexpr Duration answer_patience = std::chrono::seconds(5);
/// Every container tells its state once a second.
constexpr Duration heard_by = std::chrono::milliseconds(1500);

std::string bare(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic.substr(1) : topic;
}

/// The containers of a host, and what they are asked.
class Containers {
 public:
  explicit Containers(Bus& bus) {
    ContainerStates states(bus);
    for (const auto& one : states.wait(heard_by, [](const auto&) { return false; })) {
      const std::string& name = one.first.first;
      services_[name] = std::make_unique<ServiceCaller>(
          bus, ServiceEndpoint{SetQos::name, &type_info<SetQos::Request>(),
                               &type_info<SetQos::Response>(), container_node(name)});
    }
  }
  /// The number of ends that each has changed. Throws ConfigError when one refuses.
  std::vector<std::uint32_t> tell(const SetQos::Request& request) {
    std::vector<std::uint32_t> changed;
    const auto message = std::make_shared<const SetQos::Request>(request);
    for (const auto& [name, service] : services_) {
      const auto response =
          std::static_pointer_cast<const SetQos::Response>(service->call(message, answer_patience));
      if (!response->success()) throw ConfigError(name + ": " + response->message());
      changed.push_back(response->ends());
    }
    return changed;
  }

 private:
  std::map<std::string, std::unique_ptr<ServiceCaller>> services_;  ///< by container
};

void add(Changed& done, std::vector<int>& sums, const std::vector<std::uint32_t>& more) {
  sums.resize(more.size());
  for (std::size_t i = 0; i < more.size(); ++i) {
    sums[i] += static_cast<int>(more[i]);
    done.ends += static_cast<int>(more[i]);
  }
}

}  // namespace

std::string wire_name(const HostChoice& host, const std::string& topic) {
  return wire_topic((host.ros_namespace.empty() ? "" : host.ros_namespace + "/") + bare(topic));
}

std::string like_running(const std::vector<GraphEnd>& ends, const std::string& topic) {
  std::set<std::string> names;
  for (const GraphEnd& end : ends) {
    if (const auto name = ros_topic(end.topic)) names.insert(*name);
  }
  return suggestion({names.begin(), names.end()}, topic);
}

std::vector<GraphEnd> ends_of_host(const Options& options) {
  const auto graph = make_host_graph(host_bus_options(options.host, "tocsin_qos"));
  return settled_ends(*graph, seconds(options.spin_s));
}

Changed change_running(const Options& options) {
  const std::string settings = settings_map(options.settings);
  check_change(settings);
  const std::string on_wire = wire_name(options.host, options.one);
  BusOptions joined = host_bus_options(options.host, "tocsin_qos");
  const auto graph = make_host_graph(joined);
  auto all = settled_ends(*graph, seconds(options.spin_s));
  const auto writers = ends_of(all, on_wire, true);
  const auto readers = ends_of(all, on_wire, false);
  if (writers.empty() && readers.empty()) {
    throw EnvironmentError("nobody writes or reads " + options.one + " here" +
                           like_running(all, "/" + bare(options.one)));
  }
  (void)changed(announced_profile(writers.empty() ? readers : writers), settings);
  const auto bus = make_fast_dds_bus(joined);
  Containers containers(*bus);
  SetQos::Request request;
  request.topic(bare(options.one));
  request.settings(settings);
  (void)containers.tell(request);  // whether all could
  Changed done;
  std::vector<int> sums;
  for (const std::string& ends : order_of(writers, settings)) {
    request.writers(ends == "writers");
    request.readers(ends == "readers");
    add(done, sums, containers.tell(request));
  }
  for (const int one : sums) done.containers += one > 0 ? 1 : 0;
  if (done.ends == 0) {
    throw EnvironmentError(options.one +
                           ": its ends belong to programs that are no containers of ours");
  }
  all = settled_ends(*graph, seconds(options.spin_s));
  done.stopped = stopped(pairs_of(ends_of(all, on_wire, true), ends_of(all, on_wire, false)));
  return done;
}

}  // namespace tocsin::qos_tool
