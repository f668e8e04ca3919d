// SPDX-License-Identifier: Apache-2.0
#include "graph_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "graph_names.hpp"
#include "running_names.hpp"

namespace tocsin::topic_tool {
namespace {

struct Topic {
  std::set<std::string> types;
  std::vector<const GraphEnd*> writers;
  std::vector<const GraphEnd*> readers;
};
using Topics = std::map<std::string, Topic>;

Topics topics_in(const std::vector<GraphEnd>& ends) {
  Topics topics;
  for (const GraphEnd& end : ends) {
    const auto name = ros_topic(end.topic);
    if (!name) continue;
    Topic& topic = topics[*name];
    topic.types.insert(ros_type(end.type));
    (end.writer ? topic.writers : topic.readers).push_back(&end);
  }
  return topics;
}

/// One side of the verbose list.
std::string counted(const Topics& topics, const char* title, const char* word,
                    std::vector<const GraphEnd*> Topic::*ends) {
  std::string text = title;
  for (const auto& [name, topic] : topics) {
    const std::size_t count = (topic.*ends).size();
    if (count == 0) continue;
    text += fmt::format(" * {} [{}] {} {}{}\n", printable(name), types_text(topic.types), count,
                        word, count == 1 ? "" : "s");
  }
  return text;
}

std::string seconds_text(double s) {
  return std::isinf(s) ? "Infinite" : fmt::format("{} nanoseconds", std::llround(s * 1e9));
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Components of a process that use one topic share its end.
std::vector<GraphNode> owners_of(const GraphEnd& end, const std::vector<GraphNode>& nodes) {
  std::vector<GraphNode> owners;
  for (const GraphNode& node : nodes) {
    if (has_end(node, end)) owners.push_back(node);
  }
  if (owners.empty()) owners.push_back({"_NODE_NAMESPACE_UNKNOWN_", "_NODE_NAME_UNKNOWN_"});
  return owners;
}

std::string owners_text(const GraphEnd& end, const std::vector<GraphNode>& nodes) {
  std::vector<std::string> names;
  std::set<std::string> namespaces;
  for (const GraphNode& node : owners_of(end, nodes)) {
    names.push_back(node.name);
    namespaces.insert(node.ros_namespace);
  }
  return fmt::format("Node name: {}\nNode namespace: {}\n", printable(joined(names, ", ")),
                     printable(fmt::to_string(fmt::join(namespaces, ", "))));
}

/// What the end announces as its type's hash.
std::string type_hash_of(const GraphEnd& end) {
  const std::string key = "typehash=";
  const std::size_t at = end.user_data.find(key);
  if (at == std::string::npos) return "INVALID";
  const std::size_t from = at + key.size();
  return printable(end.user_data.substr(from, end.user_data.find(';', from) - from));
}

std::string end_text(const GraphEnd& end, const std::vector<GraphNode>& nodes) {
  return owners_text(end, nodes) +
         fmt::format(
             "Topic type: {}\nTopic type hash: {}\nEndpoint type: {}\nGID: {}\nQoS profile:\n"
             "  Reliability: {}\n  History (Depth): UNKNOWN\n  Durability: {}\n  Lifespan: {}\n"
             "  Deadline: {}\n  Liveliness: {}\n  Liveliness lease duration: {}\n"
             "Participant name: {}\nUser data: {}\n",
             printable(ros_type(end.type)), type_hash_of(end),
             end.writer ? "PUBLISHER" : "SUBSCRIPTION", text_of(end.gid),
             upper(word_of(end.qos.reliability)), upper(word_of(end.qos.durability)),
             seconds_text(end.writer ? end.lifespan_s : HUGE_VAL), seconds_text(end.qos.deadline_s),
             upper(word_of(end.qos.liveliness)), seconds_text(end.qos.liveliness_lease_s),
             printable(end.participant), printable(end.user_data));
}

std::string ends_text(const std::vector<const GraphEnd*>& ends, const std::vector<GraphNode>& nodes,
                      bool verbose) {
  std::string text;
  for (const GraphEnd* end : ends) {
    if (verbose) text += "\n" + end_text(*end, nodes);
  }
  return text;
}

}  // namespace

std::string list_text(const std::vector<GraphEnd>& ends, const ListOptions& options) {
  Topics topics = topics_in(ends);
  for (auto it = topics.begin(); it != topics.end();) {
    it = !options.hidden && is_hidden(it->first) ? topics.erase(it) : std::next(it);
  }
  if (options.count) return fmt::format("{}\n", topics.size());
  if (options.verbose) {
    return counted(topics, "Published topics:\n", "publisher", &Topic::writers) +
           counted(topics, "\nSubscribed topics:\n", "subscriber", &Topic::readers);
  }
  std::string text;
  for (const auto& [name, topic] : topics) {
    text += printable(name) + (options.types ? " [" + types_text(topic.types) + "]" : "") + "\n";
  }
  return text;
}

std::string info_text(const std::vector<GraphEnd>& ends, const std::vector<GraphNode>& nodes,
                      const std::string& ros_topic, bool verbose) {
  const Topics topics = topics_in(ends);
  const auto found = topics.find(ros_topic);
  if (found == topics.end()) return "";
  const Topic& topic = found->second;
  const char* const gap = verbose ? "\n" : "";
  return fmt::format("Type: {}\n{}Publisher count: {}\n{}{}Subscription count: {}\n{}",
                     types_text(topic.types), gap, topic.writers.size(),
                     ends_text(topic.writers, nodes, verbose), gap, topic.readers.size(),
                     ends_text(topic.readers, nodes, verbose));
}

std::vector<std::string> types_of(const std::vector<GraphEnd>& ends, const std::string& ros_topic) {
  const Topics topics = topics_in(ends);
  const auto found = topics.find(ros_topic);
  if (found == topics.end()) return {};
  return {found->second.types.begin(), found->second.types.end()};
}

std::vector<std::string> topics_of_type(const std::vector<GraphEnd>& ends,
                                        const std::string& ros_type) {
  std::vector<std::string> names;
  for (const auto& [name, topic] : topics_in(ends)) {
    if (topic.types.count(ros_type) != 0) names.push_back(name);
  }
  return names;
}

RawTopic readable(const std::vector<GraphEnd>& ends, const std::string& ros_topic) {
  const Topics topics = topics_in(ends);
  const auto found = topics.find(ros_topic);
  if (found == topics.end()) {
    throw EnvironmentError("topic " + ros_topic + " does not appear to be published yet" +
                           suggested_names(keys_of(topics), ros_topic));
  }
  const Topic& topic = found->second;
  if (!topic.writers.empty()) return tocsin::readable(topic.writers);
  return {wire_topic(ros_topic), topic.readers.front()->type, false, false};
}

}  // namespace tocsin::topic_tool
