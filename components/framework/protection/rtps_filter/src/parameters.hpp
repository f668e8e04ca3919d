// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "submessages.hpp"

namespace tocsin::rtps_filter {

/// Parameters of discovery and inline QoS (RTPS 2.5, tables 9.18 and 9.20; DDS Security 1.1, table
/// 7; the vendor's from 0x8000 on).
namespace pid {
inline constexpr std::uint16_t pad = 0x0000, sentinel = 0x0001, lease = 0x0002, topic_name = 0x0005,
                               type_name = 0x0007, partition = 0x0029, user_data = 0x002c,
                               group_data = 0x002d, topic_data = 0x002e, unicast_locator = 0x002f,
                               multicast_locator = 0x0030, default_unicast_locator = 0x0031,
                               metatraffic_unicast_locator = 0x0032,
                               metatraffic_multicast_locator = 0x0033, content_filter = 0x0035,
                               default_multicast_locator = 0x0048, participant_guid = 0x0050,
                               builtin_endpoints = 0x0058, property_list = 0x0059,
                               endpoint_guid = 0x005a, entity_name = 0x0062, type_id = 0x0069,
                               key_hash = 0x0070, status_info = 0x0071, type_object = 0x0072,
                               data_representation = 0x0073, type_information = 0x0075,
                               identity_token = 0x1001, permissions_token = 0x1002,
                               identity_status_token = 0x1006, domain_tag = 0x4014,
                               data_sharing = 0x8006;
}  // namespace pid

struct Parameter {
  std::uint16_t id = 0;
  Cursor value;
  const std::uint8_t* place = nullptr;  ///< where its id stands
};

/// Goes through a list that `bytes_of_list` has found complete.
class Parameters {
 public:
  explicit Parameters(const Cursor& list) : at_(list) {}
  /// Nothing at the sentinel.
  [[nodiscard]] std::optional<Parameter> next();

 private:
  Cursor at_;
};

/// Bytes of a parameter list with its sentinel; nothing when it has none.
[[nodiscard]] std::optional<std::size_t> bytes_of_list(const Cursor& list);
/// What Fast DDS reads of an inline QoS.
[[nodiscard]] Wrong check_inline_qos(const Cursor& list);
/// One parameter of discovery: lengths of its strings and sequences.
[[nodiscard]] Wrong check_parameter(const Parameter& parameter);
/// A DataHolder (DDS Security 1.1, 7.2.3): class id, properties, binary properties.
[[nodiscard]] bool is_data_holder(Cursor& at);
/// Class and content of a ParticipantGenericMessage (DDS Security 1.1, 7.4.4).
[[nodiscard]] bool is_message_data(Cursor& at);

}  // namespace tocsin::rtps_filter
