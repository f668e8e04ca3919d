// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "runtime/component.hpp"

namespace tocsin {

/// The end of this topic under another name on this host, as `uxv3/location` or `/uxv3/location`:
/// for a component that meets topics of several vehicles, whose own routers carry them. `name` must
/// outlive what is made of it.
[[nodiscard]] Endpoint named_end(const TopicInfo& topic, const TypeInfo& type,
                                 const std::string& name, const Component& owner);

/// As above, of a topic of tocsin_idl/topics.hpp.
template <class Topic>
[[nodiscard]] Endpoint named_end(const std::string& name, const Component& owner) {
  return named_end(Topic::info, type_info<typename Topic::Message>(), name, owner);
}

}  // namespace tocsin
