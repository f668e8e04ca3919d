// SPDX-License-Identifier: Apache-2.0
#include "parameters.hpp"

namespace tocsin::rtps_filter {
namespace {

constexpr std::size_t locator_bytes = 24;
constexpr std::size_t duration_bytes = 8;
constexpr std::size_t builtin_endpoints_bytes = 4;
constexpr std::size_t string_bytes_at_least = 4;

/// A CDR string: its length, the closing zero included, then its characters.
bool is_string(Cursor& at) {
  at.align();
  const std::size_t length = at.u32();
  const Cursor text = at.part(length);
  if (!at.ok()) return false;
  return length == 0 || text.here()[length - 1] == 0;
}

bool is_octets(Cursor& at) {
  at.align();
  at.skip(at.u32());
  return at.ok();
}

/// A sequence whose elements have at least `smallest` bytes each.
template <class IsElement>
bool is_sequence(Cursor& at, std::size_t smallest, IsElement is_element) {
  at.align();
  const std::uint32_t count = at.u32();
  if (!at.ok() || count > at.left() / smallest) return false;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!is_element(at)) return false;
  }
  return true;
}

bool is_strings(Cursor& at) { return is_sequence(at, string_bytes_at_least, is_string); }

bool is_properties(Cursor& at) {
  return is_sequence(at, 2 * string_bytes_at_least,
                     [](Cursor& pair) { return is_string(pair) && is_string(pair); });
}

bool is_binary_properties(Cursor& at) {
  return is_sequence(at, 2 * string_bytes_at_least,
                     [](Cursor& pair) { return is_string(pair) && is_octets(pair); });
}

/// Numbers of `bytes` each.
bool is_numbers(Cursor& at, std::size_t bytes) {
  const std::uint32_t count = at.u32();
  return at.ok() && count <= at.left() / bytes;
}

/// Names of the filtered and the related topic, class of the filter, expression, its parameters.
bool is_content_filter(Cursor& at) {
  return is_string(at) && is_string(at) && is_string(at) && is_string(at) && is_strings(at);
}

bool is_of_variable_size(std::uint16_t id, Cursor& at) {
  switch (id) {
    case pid::topic_name:
    case pid::type_name:
    case pid::entity_name:
    case pid::domain_tag:
      return is_string(at);
    case pid::user_data:
    case pid::group_data:
    case pid::topic_data:
      return is_octets(at);
    case pid::partition:
      return is_strings(at);
    case pid::property_list:
      return is_properties(at);
    case pid::data_representation:
      return is_numbers(at, 2);
    case pid::data_sharing:
      return is_numbers(at, 8);
    case pid::content_filter:
      return is_content_filter(at);
    default:
      return true;
  }
}

/// Zero for a parameter of another form.
std::size_t fixed_bytes_of(std::uint16_t id) {
  switch (id) {
    case pid::unicast_locator:
    case pid::multicast_locator:
    case pid::default_unicast_locator:
    case pid::default_multicast_locator:
    case pid::metatraffic_unicast_locator:
    case pid::metatraffic_multicast_locator:
      return locator_bytes;
    case pid::participant_guid:
    case pid::endpoint_guid:
    case pid::key_hash:
      return guid_bytes;
    case pid::lease:
      return duration_bytes;
    case pid::builtin_endpoints:
      return builtin_endpoints_bytes;
    default:
      return 0;
  }
}

}  // namespace

bool is_data_holder(Cursor& at) {
  return is_string(at) && is_properties(at) && is_binary_properties(at);
}

bool is_message_data(Cursor& at) {
  return is_string(at) && is_sequence(at, 3 * string_bytes_at_least, is_data_holder);
}

std::optional<Parameter> Parameters::next() {
  Parameter parameter;
  parameter.place = at_.here();
  parameter.id = at_.u16();
  const std::size_t length = at_.u16();
  if (!at_.ok() || parameter.id == pid::sentinel) return std::nullopt;
  parameter.value = at_.part(length);
  at_.align();
  if (!at_.ok()) return std::nullopt;
  return parameter;
}

std::optional<std::size_t> bytes_of_list(const Cursor& list) {
  Cursor at(list.here(), list.left(), list.little());
  const std::size_t all = at.left();
  while (at.ok()) {
    const std::uint16_t id = at.u16();
    const std::size_t length = at.u16();
    if (at.ok() && id == pid::sentinel) return all - at.left();  // its length means nothing
    at.skip(length);
    at.align();
  }
  return std::nullopt;
}

Wrong check_inline_qos(const Cursor& list) {
  Parameters parameters(list);
  while (const auto parameter = parameters.next()) {
    const std::size_t bytes = parameter->value.left();
    if ((parameter->id == pid::key_hash && bytes != guid_bytes) ||
        (parameter->id == pid::status_info && bytes != 4)) {
      return DropReason::parameter_content;
    }
  }
  return std::nullopt;
}

Wrong check_parameter(const Parameter& parameter) {
  Cursor at = parameter.value;
  switch (parameter.id) {
    case pid::identity_token:
    case pid::permissions_token:
    case pid::identity_status_token:
      if (!is_data_holder(at)) return DropReason::security_content;
      return std::nullopt;
    default:
      if (at.left() < fixed_bytes_of(parameter.id) || !is_of_variable_size(parameter.id, at)) {
        return DropReason::parameter_content;
      }
      return std::nullopt;
  }
}

}  // namespace tocsin::rtps_filter
