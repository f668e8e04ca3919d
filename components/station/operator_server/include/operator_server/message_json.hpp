// SPDX-License-Identifier: Apache-2.0
// Messages of any known type as JSON: what a page can write without a library for CDR. Pure.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "idl_support/type_info.hpp"

namespace tocsin::foxglove {

/// A message, or why there is none: one line.
struct MadeMessage {
  std::shared_ptr<void> message;  ///< null: there is none
  std::string fault = {};
};

/// The message of a JSON object; what it leaves out has its default. A key that no field has, a
/// value of another type or beyond its field's range is a fault that names it.
[[nodiscard]] MadeMessage message_from_json(const TypeInfo& type, std::string_view text);
/// The message of CDR bytes with their encapsulation header.
[[nodiscard]] MadeMessage message_from_cdr(const TypeInfo& type, std::string_view bytes);
/// By its `encoding`, cdr or json.
[[nodiscard]] MadeMessage message_from(const TypeInfo& type, const std::string& encoding,
                                       std::string_view payload);

/// NaN and infinities are null, bytes a list of numbers.
[[nodiscard]] nlohmann::json json_of(const TypeInfo& type, const void* message);

}  // namespace tocsin::foxglove
