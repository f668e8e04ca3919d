// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "runtime/component.hpp"

namespace tocsin {

/// The end of a topic of tocsin_idl/topics.hpp under another name on this host, as `uxv3/location`
/// or `/uxv3/location`: for a component that meets topics of several vehicles, whose own routers
/// carry them. `name` must outlive what is made of it.
template <class Topic>
[[nodiscard]] Endpoint named_end(const std::string& name, const Component& owner) {
  TopicInfo info = Topic::info;
  info.name = name.c_str();
  info.scope = Scope::host;
  return {info, &type_info<typename Topic::Message>(), Writers::optional, "", owner.node()};
}

}  // namespace tocsin
