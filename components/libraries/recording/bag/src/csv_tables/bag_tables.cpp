// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/bag_tables.hpp"

#include <filesystem>

#include "bag/metadata.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "idl_support/type_registry.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

constexpr const char* mcap_extension = ".mcap";

/// A program that uses this is linked with the library that registers the stack's types.
[[maybe_unused]] const TypeInfo& of_the_stack = type_info<tocsin_msgs::msg::NetworkQuality>();

std::string without_slash(const std::string& topic) {
  return topic.empty() || topic.front() != '/' ? topic : topic.substr(1);
}

const TypeInfo* type_named(const std::string& ros_name) {
  try {
    return find_type(wire_type(ros_name));
  } catch (const ConfigError&) {
    return nullptr;  // of another system
  }
}

BagMessage read(const bag::Topic& topic, const TypeInfo* type, const bag::Message& message) {
  BagMessage read{{without_slash(topic.name), message.log_time_ns, message.publish_time_ns,
                   message.writer, message.sequence, message.size},
                  nullptr,
                  nullptr};
  if (type == nullptr) return read;
  auto content = type->create();
  if (!type->deserialize(message.data, message.size, content.get())) return read;
  read.type = type;
  read.content = std::move(content);
  return read;
}

void append(std::string& table, const NamedRow& row) {
  if (table.empty()) table = csv_line(row.columns);
  table += csv_line(row.cells);
}

}  // namespace

void read_messages(bag::BagReader& bag, const bag::Selection& selection,
                   const std::function<void(const BagMessage&)>& receive) {
  std::vector<const TypeInfo*> types;
  for (const auto& [topic, count] : bag.topics()) types.push_back(type_named(topic.type));
  const auto messages = bag.messages(selection);
  while (const auto one = messages->next()) {
    receive(read(bag.topics()[one->topic].topic, types[one->topic], one->message));
  }
}

bool is_bag(const std::string& path) {
  std::error_code none;
  if (!fs::is_directory(path, none)) {
    return fs::path(path).extension() == mcap_extension && fs::exists(path, none);
  }
  if (fs::exists(fs::path(path) / bag::metadata_file, none)) return true;
  for (const auto& entry : fs::directory_iterator(path, none)) {
    if (entry.path().extension() == mcap_extension) return true;
  }
  return false;
}

std::vector<std::string> recorded_bags(const std::string& folder) {
  std::vector<std::string> bags;
  std::string next = folder + "/bag";
  for (int number = 2; is_bag(next); ++number) {
    bags.push_back(next);
    next = folder + "/bag_" + std::to_string(number);
  }
  return bags;
}

BagTables::BagTables(const std::vector<std::string>& bags,
                     const std::function<bool(const std::string& topic)>& wanted) {
  bag::Selection selection;
  if (wanted) {
    selection.wanted = [&wanted](const bag::Topic& topic) {
      return wanted(without_slash(topic.name));
    };
  }
  for (const std::string& path : bags) {
    bag::BagReader reader(path);
    read_messages(reader, selection, [this](const BagMessage& one) {
      append(messages_, message_row(one.about));
      if (one.type == nullptr) return;
      append(topics_[one.about.topic], field_row(one.about, *one.type, one.content.get()));
    });
  }
}

const std::string& BagTables::of(const std::string& topic) const {
  static const std::string none;
  const auto found = topics_.find(topic);
  return found == topics_.end() ? none : found->second;
}

}  // namespace tocsin
