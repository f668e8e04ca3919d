// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/remote_ends.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graph/type_hash.hpp"
#include "runtime/middleware/qos_matching.hpp"

namespace tocsin {
namespace {

const std::string layout_key = "tocsinlayout=";
const std::string type_hash_key = "typehash=";
const std::string vehicle_key = "tocsinvehicle=";

bool layouts_differ(const AnnouncedEnd& one, const AnnouncedEnd& other) {
  return !one.layout.empty() && !other.layout.empty() && one.layout != other.layout;
}

/// Durations as they come back from the wire, where they are binary fractions of a second.
QosContract rounded(QosContract qos) {
  for (double* s : {&qos.deadline_s, &qos.liveliness_lease_s}) *s = std::round(*s * 1e6) / 1e6;
  return qos;
}

/// The policies by which the two will not match; none when their partitions keep them apart.
std::vector<std::string> policies_between(const AnnouncedEnd& own, const AnnouncedEnd& other) {
  const AnnouncedEnd& writer = own.writer ? own : other;
  const AnnouncedEnd& reader = own.writer ? other : own;
  auto found = incompatibilities_for_fast_dds(rounded(writer.qos), rounded(reader.qos));
  const bool apart = std::find(found.begin(), found.end(), "partition") != found.end();
  return apart ? std::vector<std::string>() : found;
}

/// What stands behind `key`, up to the next semicolon.
std::string value_in(const std::string& user_data, const std::string& key) {
  const std::size_t at = user_data.find(key);
  if (at == std::string::npos) return "";
  const std::size_t from = at + key.size();
  return user_data.substr(from, user_data.find(';', from) - from);
}

/// Of one topic.
bool clash(const AnnouncedEnd& own, const AnnouncedEnd& other) {
  return own.writer != other.writer && (own.type != other.type || layouts_differ(own, other));
}

}  // namespace

std::string joined(const std::string& user_data, const std::string& more) {
  const bool open_end = !user_data.empty() && !more.empty() && user_data.back() != ';';
  return user_data + (open_end ? ";" : "") + more;
}

std::string participant_data_for(const std::string& vehicle) {
  return participant_user_data + (vehicle.empty() ? "" : vehicle_key + vehicle + ";");
}

bool find_each_other(const std::string& one, const std::string& other) {
  const std::string vehicle = value_in(one, vehicle_key);
  const std::string others = value_in(other, vehicle_key);
  return vehicle.empty() || others.empty() || vehicle == others;
}

std::string with_layout(const std::string& user_data, const std::string& layout) {
  return layout.empty() ? user_data : joined(user_data, layout_key + layout + ";");
}

std::string with_type_hash(const std::string& user_data, const std::string& hash) {
  return hash.empty() ? user_data : joined(user_data, type_hash_key + hash + ";");
}

std::string layout_in(const std::string& user_data) { return value_in(user_data, layout_key); }

std::string type_hash_in(const std::string& user_data) {
  const std::string hash = value_in(user_data, type_hash_key);
  return is_type_hash(hash) ? hash : "";
}

void RemoteEnds::add(const Participant& participant, const std::string& name,
                     const std::string& user_data) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    names_[participant] = name;
    participants_data_[participant] = user_data;
  }
  if (on_participant_) on_participant_(participant, name, true);
}

void RemoteEnds::add(const Guid& guid, const AnnouncedEnd& end) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    forget(guid);
    ends_[end.topic][guid] = end;
    topics_[guid] = end.topic;
  }
  if (on_end_) on_end_(guid, end, true);
}

void RemoteEnds::remove(const Participant& participant) {
  std::vector<Guid> left;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& entry : topics_) {
      if (entry.first.guidPrefix == participant) left.push_back(entry.first);
    }
  }
  for (const Guid& guid : left) remove(guid);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    names_.erase(participant);
    participants_data_.erase(participant);
  }
  if (on_participant_) on_participant_(participant, "", false);
}

void RemoteEnds::remove(const Guid& guid) {
  std::optional<AnnouncedEnd> end;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    end = forget(guid);
  }
  if (end && on_end_) on_end_(guid, *end, false);
}

std::optional<AnnouncedEnd> RemoteEnds::forget(const Guid& guid) {
  const auto topic = topics_.find(guid);
  if (topic == topics_.end()) return std::nullopt;
  const auto of_topic = ends_.find(topic->second);
  std::optional<AnnouncedEnd> end = std::move(of_topic->second.at(guid));
  of_topic->second.erase(guid);
  if (of_topic->second.empty()) ends_.erase(of_topic);
  topics_.erase(topic);
  return end;
}

const RemoteEnds::Ends& RemoteEnds::ends_of(const std::string& topic) const {
  static const Ends none;
  const auto found = ends_.find(topic);
  return found != ends_.end() ? found->second : none;
}

const AnnouncedEnd* RemoteEnds::find(const Guid& guid) const {
  const auto topic = topics_.find(guid);
  return topic != topics_.end() ? &ends_.at(topic->second).at(guid) : nullptr;
}

std::string RemoteEnds::other_type(const AnnouncedEnd& own) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [guid, end] : ends_of(own.topic)) {
    if (!clash(own, end)) continue;
    return end.type + (end.type == own.type ? " with another layout" : "") + owner_of(guid);
  }
  return "";
}

WriterInfo RemoteEnds::writer(const Guid& guid) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const AnnouncedEnd* const end = find(guid);
  WriterInfo info;
  info.name = name_of(guid);
  if (end == nullptr) return info;
  info.user_data = end->user_data;
  info.lifespan_s = end->lifespan_s;
  return info;
}

std::vector<RemoteEnds::Known> RemoteEnds::all() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Known> all;
  all.reserve(topics_.size());
  for (const auto& [guid, topic] : topics_) {
    all.push_back({guid, ends_.at(topic).at(guid), name_of(guid)});
  }
  return all;
}

std::vector<std::string> RemoteEnds::written_topics(const std::string& prefix) const {
  std::vector<std::string> topics;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto topic = ends_.lower_bound(prefix); topic != ends_.end(); ++topic) {
    if (topic->first.compare(0, prefix.size(), prefix) != 0) break;
    for (const auto& entry : topic->second) {
      if (entry.second.writer) topics.push_back(topic->first);
    }
  }
  return topics;
}

bool RemoteEnds::has_ros2() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(participants_data_.begin(), participants_data_.end(), [](const auto& one) {
    const std::string& data = one.second;
    return data.find("enclave=") != std::string::npos && data.find("tocsin=") == std::string::npos;
  });
}

std::vector<std::string> RemoteEnds::user_data_of(const std::string& topic) const {
  std::vector<std::string> all;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& entry : ends_of(topic)) all.push_back(entry.second.user_data);
  return all;
}

std::string RemoteEnds::type_hash(const std::string& topic, const std::string& type) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& entry : ends_of(topic)) {
    const AnnouncedEnd& end = entry.second;
    if (end.type != type) continue;
    if (auto hash = type_hash_in(end.user_data); !hash.empty()) return hash;
  }
  return "";
}

std::string RemoteEnds::misfit(const AnnouncedEnd& own) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [guid, end] : ends_of(own.topic)) {
    if (own.writer == end.writer || own.type != end.type) continue;
    const std::vector<std::string> policies = policies_between(own, end);
    if (policies.empty()) continue;
    std::string text;
    for (const std::string& policy : policies) text += (text.empty() ? "" : ", ") + policy;
    return text + owner_of(guid);
  }
  return "";
}

/// Empty: it has told none.
std::string RemoteEnds::name_of(const Guid& guid) const {
  const auto name = names_.find(guid.guidPrefix);
  return name != names_.end() ? name->second : "";
}

std::string RemoteEnds::owner_of(const Guid& guid) const {
  const std::string name = name_of(guid);
  return " (" + (name.empty() ? "unnamed participant" : name) + ")";
}

bool RemoteEnds::has_other_layout(const Guid& guid, const AnnouncedEnd& own) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const AnnouncedEnd* const end = find(guid);
  return end != nullptr && layouts_differ(own, *end);
}

}  // namespace tocsin
