// SPDX-License-Identifier: Apache-2.0
#include "named_end/named_end.hpp"

namespace tocsin {

Endpoint named_end(const TopicInfo& topic, const TypeInfo& type, const std::string& name,
                   const Component& owner) {
  TopicInfo named = topic;
  named.name = name.c_str();
  named.scope = Scope::host;
  return {named, &type, Writers::optional, "", owner.node()};
}

}  // namespace tocsin
