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

}  // namespace

std::string short_type_name(const std::string& wire_name) {
  const std::string package = wire_name.substr(0, wire_name.find("::"));
  const std::size_t last = wire_name.rfind("::");
  const std::string type = last == std::string::npos ? wire_name : wire_name.substr(last + 2);
  return package + "/" + type.substr(0, type.size() - 1);
}

std::vector<std::string> known_definitions() {
  const std::lock_guard<std::mutex> lock(definitions().mutex);
  std::vector<std::string> names;
  for (const auto& one : definitions().by_name) names.push_back(one.first);
  return names;
}

std::optional<TypeDefinition> find_definition(const std::string& name) {
  const std::lock_guard<std::mutex> lock(definitions().mutex);
  const auto found = definitions().by_name.find(name);
  if (found == definitions().by_name.end()) return std::nullopt;
  return found->second;
}

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
    if (i > 0) text += std::string(80, '=') + "\nMSG: " + short_type_name(names[i]) + "\n";
    text += found->second.text;
    for (const std::string& part : found->second.parts) {
      if (std::find(names.begin(), names.end(), part) == names.end()) names.push_back(part);
    }
  }
  return text;
}

}  // namespace tocsin
