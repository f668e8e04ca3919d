// SPDX-License-Identifier: Apache-2.0
#include "container/rosout.hpp"

#include <chrono>
#include <utility>

#include "runtime/host_control.hpp"
#include "runtime/middleware/ros_stamp.hpp"

namespace tocsin {
namespace {

/// The path says where the stack was built, which nobody asks for.
std::string file_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

std::string logger_name(const std::string& ros_namespace, const std::string& node) {
  return ros_namespace.empty() ? node : ros_namespace + "." + node;
}

std::string node_of_logger(const std::string& ros_namespace, const std::string& logger) {
  if (logger == ros_namespace) return "";
  const std::string home = ros_namespace + ".";
  const bool at_home = !ros_namespace.empty() && logger.compare(0, home.size(), home) == 0;
  return at_home ? logger.substr(home.size()) : logger;
}

Rosout::Rosout(Component& owner)
    : owner_(owner), lines_([this] { owner_.schedule().input_arrived(); }) {
  serve({});
}

std::unique_ptr<Publication> Rosout::advertise(const std::string& node) {
  return owner_.bus().advertise(
      {RosoutTopic::info, &type_info<RosoutTopic::Message>(), Writers::needed, "", node});
}

void Rosout::serve(const std::set<std::string>& nodes) {
  for (auto it = ends_.begin(); it != ends_.end();) {
    const bool stays = it->first == owner_.node() || nodes.count(it->first) != 0;
    it = stays ? std::next(it) : ends_.erase(it);
  }
  for (const std::string& node : nodes) {
    if (ends_.count(node) == 0) ends_[node] = advertise(node);
  }
  if (ends_.count(owner_.node()) == 0) ends_[owner_.node()] = advertise(owner_.node());
}

Publication& Rosout::end_of(const std::string& node) {
  const auto found = ends_.find(node);
  return found != ends_.end() ? *found->second : *ends_.at(owner_.node());
}

void Rosout::write(const LogLine& line) {
  auto message = std::make_shared<RosoutTopic::Message>();
  message->stamp(ros_stamp(std::chrono::nanoseconds(line.time.time_since_epoch()).count()));
  message->level(static_cast<std::uint8_t>(line.level));
  message->name(logger_name(owner_.bus().host_control().ros_namespace(), line.node));
  message->msg(line.text);
  message->file(file_name(line.place.file));
  message->function(line.place.function);
  message->line(line.place.line);
  (void)end_of(line.node).write(message);  // to log that this has failed would only add to it
}

void Rosout::tell() {
  if (const auto dropped = lines_.take_dropped(); dropped != 0) {
    write({LogLevel::warn,
           owner_.node(),
           std::to_string(dropped) + " lines were not told here",
           std::chrono::system_clock::now(),
           {__FILE__, __func__, __LINE__}});
  }
  while (const auto line = lines_.take()) write(*line);
}

}  // namespace tocsin
