// SPDX-License-Identifier: Apache-2.0
#include "idl_support/type_definition.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

namespace tocsin {
namespace {

struct Definitions {
  std::mutex mutex;
  std::map<std::string, TypeDefinition> by_name;
};

/// A function-local object: it exists whichever library registers first.
Definitions& definitions() {
  static Definitions instance;
  return instance;
}

/// `geometry_msgs/Twist` of `geometry_msgs::msg::dds_::Twist_`.
std::string short_name(const std::string& wire) {
  const std::string package = wire.substr(0, wire.find("::"));
  const std::size_t last = wire.rfind("::");
  const std::string type = last == std::string::npos ? wire : wire.substr(last + 2);
  return package + "/" + type.substr(0, type.size() - 1);
}

}  // namespace

void register_definition(TypeDefinition definition) {
  const std::lock_guard<std::mutex> lock(definitions().mutex);
  std::string name = definition.name;
  definitions().by_name.emplace(std::move(name), std::move(definition));
}

std::optional<std::string> ros2msg_definition(const std::string& name) {
  const std::lock_guard<std::mutex> lock(definitions().mutex);
  const auto& known = definitions().by_name;
  std::vector<std::string> names{name};
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = known.find(names[i]);
    if (found == known.end()) return std::nullopt;
    if (i > 0) text += std::string(80, '=') + "\nMSG: " + short_name(names[i]) + "\n";
    text += found->second.text;
    for (const std::string& part : found->second.parts) {
      if (std::find(names.begin(), names.end(), part) == names.end()) names.push_back(part);
    }
  }
  return text;
}

}  // namespace tocsin
