// SPDX-License-Identifier: Apache-2.0
// Messages of any known type as YAML, as `ros2 topic echo` prints them, and back.
#pragma once

#include <memory>
#include <string>

#include "idl_support/type_info.hpp"

namespace tocsin::topic_tool {

struct EchoOptions {
  std::string field;          ///< only this one, with dots: `pose.position`; empty: the whole
  std::size_t longest = 128;  ///< texts and lists are cut here; 0: never
  bool no_lists = false;      ///< --no-arr: `<sequence type: 1000 elements>` in their place
  bool no_texts = false;      ///< --no-str
};

/// Throws ConfigError when the type has no such field.
[[nodiscard]] std::string to_yaml(const TypeInfo& type, const void* message,
                                  const EchoOptions& options);

/// The message that a text such as `{linear: {x: 0.2}}` means; what it leaves out has its default.
/// Throws ConfigError that names the field, the value and what is allowed.
[[nodiscard]] std::shared_ptr<void> from_yaml(const TypeInfo& type, const std::string& text);

}  // namespace tocsin::topic_tool
