// SPDX-License-Identifier: Apache-2.0
#include "topic_session.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "command_line/stop_signal.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "graph_text.hpp"
#include "idl_support/type_registry.hpp"
#include "runtime/middleware/idl_libraries.hpp"

namespace tocsin::topic_tool {
namespace {

constexpr Duration look = std::chrono::milliseconds(50);

}  // namespace

void SessionOptions::declare_session(CLI::App& verb) {
  host.declare(verb);
  verb.add_option("--spin-time", spin_s, "[s] waited for what does not appear [2]")
      ->check(CLI::Range(0.1, 600.0));
}

void declare_timeout(CLI::App& verb, double& timeout_s) {
  verb.add_option("--timeout", timeout_s, "[s] for who is to answer, and for the answer [5]")
      ->check(CLI::Range(0.1, 600.0));
}

TopicSession::TopicSession(const SessionOptions& options)
    : spin_s_(options.spin_s),
      graph_(make_host_graph(host_bus_options(options.host, "tocsin_topic"))) {
  catch_stop_signals();
}

std::vector<GraphEnd> TopicSession::ends() const {
  return settled_ends(*graph_, seconds(spin_s_), is_stopped);
}

RawTopic TopicSession::find(const std::string& ros_topic) const {
  for (Duration waited{0}; waited < seconds(spin_s_) && !is_stopped(); waited += look) {
    if (!types_of(graph_->ends(), ros_topic).empty()) return readable(ends(), ros_topic);
    std::this_thread::sleep_for(look);
  }
  return readable(graph_->ends(), ros_topic);
}

const TypeInfo& known_type(std::string_view on_wire) {
  load_idl_libraries();
  const std::string name(on_wire);
  const TypeInfo* const type = find_type(name);
  if (type != nullptr) return *type;
  throw ConfigError("the message type '" + ros_type(name) +
                    "' is not known here: no installed package has its IDL; source the setup.bash "
                    "of the workspace that has it");
}

SampleQueue::SampleQueue(HostGraph& graph, const RawTopic& topic)
    : reading_(graph.read(topic, [this](RawSample&& sample) {
        {
          const std::lock_guard<std::mutex> lock(mutex_);
          if (samples_.size() == room) {
            samples_.pop_front();
            ++dropped_;
          }
          samples_.push_back(std::move(sample));
        }
        came_.notify_one();
      })) {}

std::optional<RawSample> SampleQueue::take(Duration patience) {
  std::unique_lock<std::mutex> lock(mutex_);
  // Looks up now and then, as a signal wakes nobody.
  for (Duration waited{0}; waited < patience && !is_stopped(); waited += look) {
    const Duration most = std::min(look, patience - waited);
    if (!came_.wait_for(lock, most, [this] { return !samples_.empty(); })) continue;
    RawSample sample = std::move(samples_.front());
    samples_.pop_front();
    return sample;
  }
  return std::nullopt;
}

std::size_t SampleQueue::dropped() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return dropped_;
}

}  // namespace tocsin::topic_tool
