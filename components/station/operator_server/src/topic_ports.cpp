// SPDX-License-Identifier: Apache-2.0
#include "operator_server/topic_ports.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "idl_support/encode.hpp"
#include "idl_support/topic_registry.hpp"
#include "idl_support/type_registry.hpp"
#include "operator_server/message_json.hpp"
#include "runtime/host_control.hpp"
#include "tocsin_idl/control_verb.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::foxglove {
namespace {

/// Of a topic that no library states: heard by readers of any kind, and nothing old is sent.
constexpr const char* client_qos = "event";

/// Null: it is not the name of a type, or of none that is known.
const TypeInfo* type_named(const std::string& ros_name) {
  try {
    return find_type(wire_type(ros_name));
  } catch (const ConfigError&) {
    return nullptr;
  }
}

bool is_topic_name(const std::string& name) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '/'; };
  return name.size() > 1 && name.size() < 256 && name.front() == '/' && name.back() != '/' &&
         name.find("//") == std::string::npos && std::all_of(name.begin(), name.end(), allowed);
}

/// Under whose name a person drives, or asks to.
std::optional<std::string> operator_of(const TypeInfo& type, const void* message) {
  if (&type == &type_info<topic::TeleopCmdVel::Message>()) {
    return static_cast<const topic::TeleopCmdVel::Message*>(message)->header().frame_id();
  }
  if (&type == &type_info<topic::DriverRequest::Message>()) {
    return static_cast<const topic::DriverRequest::Message*>(message)->name();
  }
  return std::nullopt;
}

/// Why a client of this role may not say this; empty: it may.
std::string refusal_of(UserRole role, const TypeInfo& type, const void* message) {
  if (role == UserRole::observer && &type == &type_info<topic::EmergencyStopRequest::Message>()) {
    const bool presses = static_cast<const topic::EmergencyStopRequest::Message*>(message)->data();
    return presses ? "" : "an observer may press the emergency stop, and not release it";
  }
  if (role != UserRole::supervisor && &type == &type_info<topic::DriverRequest::Message>()) {
    const auto& verb = static_cast<const topic::DriverRequest::Message*>(message)->verb();
    return verb == word_of(ControlVerb::take) ? "only a supervisor takes control; ask for it" : "";
  }
  return {};
}

}  // namespace

void TopicPorts::set_topics(const std::vector<SeenTopic>& topics) {
  topics_.clear();
  for (const SeenTopic& topic : topics) topics_.emplace(topic.name, topic);
  for (auto one = readings_.begin(); one != readings_.end();) {
    const auto topic = topics_.find(one->first);
    const bool stays = topic != topics_.end() && topic->second.type == one->second.type;
    one = stays ? std::next(one) : readings_.erase(one);
  }
}

void TopicPorts::read(const std::set<std::string>& wanted, std::vector<std::string>& faults) {
  for (auto one = readings_.begin(); one != readings_.end();) {
    one = wanted.count(one->first) != 0 ? std::next(one) : readings_.erase(one);
  }
  for (const std::string& name : wanted) {
    const auto topic = topics_.find(name);
    if (topic == topics_.end() || readings_.count(name) != 0) continue;
    const SeenTopic& seen = topic->second;
    std::unique_ptr<InputPort> input;
    try {
      input =
          std::make_unique<InputPort>(owner_, Endpoint{seen.info, seen.type, Writers::optional});
    } catch (const ConfigError& error) {
      faults.emplace_back(error.what());
    }
    readings_[name] = {seen.type, std::move(input)};
  }
}

void TopicPorts::take(Hub& hub) {
  for (const auto& [name, reading] : readings_) {
    if (!reading.input) continue;
    while (const auto sample = reading.input->take_sample()) {
      if (sample->message == nullptr) continue;
      hub.on_message(name, static_cast<std::uint64_t>(sample->received_wall_ns),
                     std::make_shared<const std::vector<std::uint8_t>>(
                         encode(*reading.type, sample->message.get())),
                     sample->source);
    }
  }
}

std::string TopicPorts::open(const ClientChannel& channel) {
  const std::string topic = printable(channel.topic);
  if (!is_topic_name(channel.topic)) return topic + ": is not a name of a topic";
  const TypeInfo* const type = type_named(channel.schema_name);
  if (type == nullptr) {
    return topic + ": no installed IDL library has the type '" + printable(channel.schema_name) +
           "'";
  }
  const auto open = writings_.find(channel.topic);
  if (open == writings_.end()) return open_new(channel, *type);
  if (open->second.type == type) return {};
  return topic + ": has the type " + ros_type(open->second.type->name) + ", not " +
         printable(channel.schema_name);
}

std::string TopicPorts::open_new(const ClientChannel& channel, const TypeInfo& type) {
  const std::string& ros_namespace = owner_.bus().host_control().ros_namespace();
  const std::string name = bus_name(channel.topic, ros_namespace);
  for (const KnownTopic& known : known_topics()) {
    if (known.info.name == name && known.type != &type) {
      return channel.topic + ": has the type " + ros_type(known.type->name) + ", not " +
             channel.schema_name;
    }
  }
  const TopicInfo info = bus_topic(channel.topic, type, client_qos, ros_namespace);
  try {
    auto publication = owner_.bus().advertise({info, &type, Writers::needed, "", owner_.node()});
    writings_[channel.topic] = {&type, std::move(publication)};
  } catch (const ConfigError& error) {
    return channel.topic + ": " + error.what();
  }
  return {};
}

TopicPorts::Written TopicPorts::write(const WriteMessage& message) {
  const auto writing = writings_.find(message.topic);
  if (writing == writings_.end()) return {message.topic + ": is not open for writing", {}};
  const TypeInfo& type = *writing->second.type;
  const MadeMessage made = message_from(type, message.encoding, message.payload);
  if (made.message == nullptr) return {message.topic + ": " + made.fault, {}};
  const std::string refusal = refusal_of(message.role, type, made.message.get());
  if (!refusal.empty()) return {message.topic + ": " + refusal, {}};
  if (writing->second.publication->write(made.message) != Status::ok) {
    return {message.topic + ": the middleware refused the message", {}};
  }
  return {"", operator_of(type, made.message.get())};
}

void TopicPorts::keep(const std::set<std::string>& written) {
  for (auto one = writings_.begin(); one != writings_.end();) {
    one = written.count(one->first) != 0 ? std::next(one) : writings_.erase(one);
  }
}

}  // namespace tocsin::foxglove
