// SPDX-License-Identifier: Apache-2.0
#include "idl_support/type_registry.hpp"

#include <map>
#include <mutex>

namespace tocsin {
namespace {

struct Registry {
  std::mutex mutex;
  std::map<std::string, const TypeInfo*> types;
};

/// A function-local object: it exists whichever library registers first.
Registry& registry() {
  static Registry instance;
  return instance;
}

}  // namespace

void register_type(const TypeInfo& info) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  registry().types.emplace(info.name, &info);
}

const TypeInfo* find_type(const std::string& name) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  const auto found = registry().types.find(name);
  return found == registry().types.end() ? nullptr : found->second;
}

}  // namespace tocsin
