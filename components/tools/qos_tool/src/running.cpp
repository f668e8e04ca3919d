// SPDX-License-Identifier: Apache-2.0
#include "running.hpp"

#include <charconv>
#include <memory>

#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "runtime/middleware/container_client.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "runtime/middleware/qos_change.hpp"

namespace tocsin::qos_tool {
namespace {

constexpr Duration answer_patience = std::chrono::seconds(5);
/// Every container tells its state once a second.
constexpr Duration heard_by = std::chrono::milliseconds(1500);

std::string bare(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic.substr(1) : topic;
}

/// The containers of a host, and what they are told.
class Containers {
 public:
  explicit Containers(Bus& bus) : client_(bus) {
    for (const auto& one : client_.wait(heard_by, [](const auto&) { return false; })) {
      names_.push_back(one.first.first);
    }
  }
  /// The number of ends that each has changed. Throws ConfigError when one refuses.
  std::vector<int> tell(const std::string& topic, const std::string& ends,
                        const std::string& settings) {
    std::vector<int> changed;
    for (const std::string& name : names_) {
      ContainerClient::Command command;
      command.container(name);
      command.verb("set_qos");
      command.library(ends);
      command.name(topic);
      command.parameters(settings);
      const auto answer = client_.ask(command, answer_patience);
      if (!answer.done()) throw ConfigError(name + ": " + answer.text());
      int count = 0;
      const std::string& text = answer.text();
      (void)std::from_chars(text.data(), text.data() + text.size(), count);
      changed.push_back(count);
    }
    return changed;
  }

 private:
  ContainerClient client_;
  std::vector<std::string> names_;
};

void add(Changed& done, std::vector<int>& sums, const std::vector<int>& more) {
  sums.resize(more.size());
  for (std::size_t i = 0; i < more.size(); ++i) {
    sums[i] += more[i];
    done.ends += more[i];
  }
}

}  // namespace

std::string wire_name(const HostChoice& host, const std::string& topic) {
  return wire_topic((host.ros_namespace.empty() ? "" : host.ros_namespace + "/") + bare(topic));
}

std::vector<GraphEnd> ends_of_host(const Options& options) {
  const auto graph = make_host_graph(host_bus_options(options.host, "tocsin_qos"));
  return settled_ends(*graph, seconds(options.spin_s));
}

Changed change_running(const Options& options) {
  const std::string settings = settings_map(options.settings);
  const std::string on_wire = wire_name(options.host, options.one);
  BusOptions joined = host_bus_options(options.host, "tocsin_qos");
  const auto graph = make_host_graph(joined);
  auto all = settled_ends(*graph, seconds(options.spin_s));
  const auto writers = ends_of(all, on_wire, true);
  const auto readers = ends_of(all, on_wire, false);
  if (writers.empty() && readers.empty()) {
    throw EnvironmentError("nobody writes or reads " + options.one + " here");
  }
  (void)changed(announced_profile(writers.empty() ? readers : writers), settings);
  const auto bus = make_fast_dds_bus(joined);
  Containers containers(*bus);
  const std::string topic = bare(options.one);
  (void)containers.tell(topic, "none", settings);
  Changed done;
  std::vector<int> sums;
  for (const std::string& ends : order_of(writers, settings)) {
    add(done, sums, containers.tell(topic, ends, settings));
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
