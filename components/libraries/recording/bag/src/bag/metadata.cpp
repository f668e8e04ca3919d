// SPDX-License-Identifier: Apache-2.0
#include "bag/metadata.hpp"

#include <yaml-cpp/yaml.h>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/yaml_sources.hpp"
#include "scalar_at.hpp"

namespace tocsin::bag {
namespace {

constexpr int version = 5;
constexpr const char* root_key = "rosbag2_bagfile_information";

void put_wrapped(YAML::Emitter& out, const char* key, const char* unit, std::int64_t value) {
  out << YAML::Key << key << YAML::Value << YAML::BeginMap << YAML::Key << unit << YAML::Value
      << value << YAML::EndMap;
}

void put_text(YAML::Emitter& out, const char* key, const std::string& text) {
  out << YAML::Key << key << YAML::Value << YAML::DoubleQuoted << text;
}

void put_topic(YAML::Emitter& out, const Metadata::TopicCount& one) {
  out << YAML::BeginMap << YAML::Key << "topic_metadata" << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "name" << YAML::Value << one.topic.name;
  out << YAML::Key << "type" << YAML::Value << one.topic.type;
  out << YAML::Key << "serialization_format" << YAML::Value << one.topic.serialization_format;
  put_text(out, "offered_qos_profiles", to_yaml(one.topic.offered_qos));
  out << YAML::EndMap << YAML::Key << "message_count" << YAML::Value << one.count << YAML::EndMap;
}

void put_file(YAML::Emitter& out, const Metadata::File& file) {
  out << YAML::BeginMap << YAML::Key << "path" << YAML::Value << file.path;
  put_wrapped(out, "starting_time", "nanoseconds_since_epoch", file.start_ns);
  put_wrapped(out, "duration", "nanoseconds", file.duration_ns);
  out << YAML::Key << "message_count" << YAML::Value << file.count << YAML::EndMap;
}

/// A file of the folder itself, by the name that it has there.
std::string checked_file(const YAML::Node& node, const std::string& name) {
  const std::string path = node.IsScalar() ? node.Scalar() : "";
  if (path.empty() || path == "." || path == ".." || path.find('/') != std::string::npos) {
    throw ConfigError(name + ": relative_file_paths: '" + printable(path) +
                      "' is not the name of a file in the bag's folder");
  }
  return path;
}

}  // namespace

std::string to_yaml(const Metadata& metadata) {
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << root_key << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "version" << YAML::Value << version;
  out << YAML::Key << "storage_identifier" << YAML::Value << "mcap";
  put_wrapped(out, "duration", "nanoseconds", metadata.duration_ns);
  put_wrapped(out, "starting_time", "nanoseconds_since_epoch", metadata.start_ns);
  out << YAML::Key << "message_count" << YAML::Value << metadata.count;
  out << YAML::Key << "topics_with_message_count" << YAML::Value << YAML::BeginSeq;
  for (const auto& topic : metadata.topics) put_topic(out, topic);
  out << YAML::EndSeq;
  put_text(out, "compression_format", "");
  put_text(out, "compression_mode", "");
  out << YAML::Key << "relative_file_paths" << YAML::Value << YAML::BeginSeq;
  for (const auto& file : metadata.files) out << file.path;
  out << YAML::EndSeq << YAML::Key << "files" << YAML::Value << YAML::BeginSeq;
  for (const auto& file : metadata.files) put_file(out, file);
  out << YAML::EndSeq << YAML::EndMap << YAML::EndMap;
  return std::string(out.c_str(), out.size()) + "\n";
}

std::vector<std::string> files_in_metadata(const std::string& text, const std::string& name) {
  YamlSources sources;
  const YAML::Node root = sources.parse(text, name);
  const YAML::Node bag = root.IsMap() ? root[root_key] : YAML::Node();
  if (!bag.IsDefined() || !bag.IsMap()) throw ConfigError(name + ": has no map " + root_key);
  const std::string storage = scalar_at(bag, "storage_identifier");
  if (storage != "mcap") {
    throw ConfigError(name + ": storage_identifier: '" + printable(storage) +
                      "' cannot be read, only mcap; ros2 bag convert makes one of the other");
  }
  if (const std::string packed = scalar_at(bag, "compression_mode"); !packed.empty()) {
    throw ConfigError(name + ": compression_mode: '" + printable(packed) +
                      "' cannot be read, only MCAP's own compression; ros2 bag convert unpacks it");
  }
  const YAML::Node paths = bag["relative_file_paths"];
  if (!paths.IsDefined() || !paths.IsSequence()) {
    throw ConfigError(name + ": relative_file_paths: is not a list of files");
  }
  std::vector<std::string> files;
  for (const YAML::Node& path : paths) files.push_back(checked_file(path, name));
  return files;
}

}  // namespace tocsin::bag
