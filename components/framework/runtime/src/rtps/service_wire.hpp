// SPDX-License-Identifier: Apache-2.0
// What requests and replies look like on the wire. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "graph/ros_graph.hpp"
#include "runtime/detail/services.hpp"

namespace tocsin {

/// The two DDS topics of a service.
struct ServiceTopics {
  std::string request;
  std::string reply;
};
/// `name` as of service_name; `ros_namespace` without slashes, empty for none. A name that begins
/// with a slash is in no namespace.
[[nodiscard]] ServiceTopics service_topics(const std::string& ros_namespace,
                                           const std::string& name);

/// What rmw_cyclonedds puts between encapsulation and message, in its byte order.
struct CycloneHeader {
  std::uint64_t client = 0;
  std::int64_t number = 0;
};
/// `bytes`: an encoded message with its encapsulation. Its alignment and byte order stay.
[[nodiscard]] std::vector<std::uint8_t> with_header(const std::vector<std::uint8_t>& bytes,
                                                    const CycloneHeader& header);

struct HeadedMessage {
  CycloneHeader header;
  std::vector<std::uint8_t> bytes;  ///< with the encapsulation, without the header
};
/// Nothing when the bytes are too few.
[[nodiscard]] std::optional<HeadedMessage> take_header(const std::vector<std::uint8_t>& bytes);

/// How an end with this gid and these user data says what belongs together.
[[nodiscard]] Correlation correlation_of(const Gid& gid, const std::string& user_data);

}  // namespace tocsin
