// SPDX-License-Identifier: Apache-2.0
#include "idl_support/ros_description.hpp"

#include <map>
#include <mutex>

namespace tocsin {
namespace {

struct Descriptions {
  std::mutex mutex;
  std::map<std::string, RosDescription> by_name;
  std::map<std::string, std::string> names;  ///< by hash
};

/// A function-local object: it exists whichever library registers first.
Descriptions& descriptions() {
  static Descriptions instance;
  return instance;
}

using Parts = std::map<std::string, RosDescription>;

void add_parts(const RosDescription& whole, const Parts& known, Parts& parts) {
  for (std::size_t i = 0; i < whole.size; ++i) {
    const auto part = known.find(whole.fields[i].nested_type_name);
    if (part != known.end() && parts.insert(*part).second) add_parts(part->second, known, parts);
  }
}

}  // namespace

void register_ros_description(const RosDescription& description) {
  const std::lock_guard<std::mutex> lock(descriptions().mutex);
  descriptions().by_name.emplace(description.name, description);
  descriptions().names.emplace(description.hash, description.name);
}

std::vector<RosDescription> describe_ros_hash(const std::string& hash) {
  const std::lock_guard<std::mutex> lock(descriptions().mutex);
  const Parts& known = descriptions().by_name;
  const auto name = descriptions().names.find(hash);
  if (name == descriptions().names.end()) return {};
  const RosDescription& whole = known.at(name->second);
  Parts parts;
  add_parts(whole, known, parts);
  std::vector<RosDescription> all{whole};
  for (const auto& part : parts) all.push_back(part.second);
  return all;
}

}  // namespace tocsin
