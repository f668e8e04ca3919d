// SPDX-License-Identifier: Apache-2.0
#include "rtps/service_wire.hpp"

#include <cstddef>

namespace tocsin {
namespace {

constexpr std::size_t encapsulation_bytes = 4;
constexpr std::size_t call_header_bytes = 16;

bool is_little_endian(const std::vector<std::uint8_t>& bytes) { return (bytes[1] & 1U) != 0; }

/// In the byte order that the encapsulation in front tells.
void append(std::vector<std::uint8_t>& bytes, std::uint64_t value) {
  constexpr unsigned highest = 56;
  const bool little = is_little_endian(bytes);
  for (unsigned shift = 0; shift <= highest; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (little ? shift : highest - shift)));
  }
}

std::uint64_t identity_part(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  const bool little = is_little_endian(bytes);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    value = value << 8U | bytes[little ? at + sizeof value - 1 - i : at + i];
  }
  return value;
}

}  // namespace

ServiceTopics service_topics(const std::string& ros_namespace, const std::string& name) {
  const bool absolute = !name.empty() && name.front() == '/';
  const std::string in_namespace = ros_namespace.empty() ? name : ros_namespace + "/" + name;
  const std::string path = absolute ? name.substr(1) : in_namespace;
  return {"rq/" + path + "Request", "rr/" + path + "Reply"};
}

std::vector<std::uint8_t> with_header(const std::vector<std::uint8_t>& bytes,
                                      const CycloneHeader& header) {
  const auto content = bytes.begin() + static_cast<std::ptrdiff_t>(encapsulation_bytes);
  std::vector<std::uint8_t> headed(bytes.begin(), content);
  append(headed, header.client);
  append(headed, static_cast<std::uint64_t>(header.number));
  headed.insert(headed.end(), content, bytes.end());
  return headed;
}

std::optional<HeadedMessage> take_header(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() < encapsulation_bytes + call_header_bytes) return std::nullopt;
  HeadedMessage message;
  message.header.client = identity_part(bytes, encapsulation_bytes);
  message.header.number =
      static_cast<std::int64_t>(identity_part(bytes, encapsulation_bytes + sizeof(std::uint64_t)));
  const auto begin = bytes.begin();
  message.bytes.assign(begin, begin + static_cast<std::ptrdiff_t>(encapsulation_bytes));
  message.bytes.insert(message.bytes.end(),
                       begin + static_cast<std::ptrdiff_t>(encapsulation_bytes + call_header_bytes),
                       bytes.end());
  return message;
}

Correlation correlation_of(const Gid& gid, const std::string& user_data) {
  constexpr std::uint8_t vendors = 0x01;
  constexpr std::uint8_t cyclone = 0x10;  // OMG's list of RTPS vendors: 01.10 Eclipse Cyclone DDS
  const bool says_so = user_data.find("clientid=") != std::string::npos ||
                       user_data.find("serviceid=") != std::string::npos;
  const bool is_cyclone = gid[0] == vendors && gid[1] == cyclone;
  return says_so || is_cyclone ? Correlation::header : Correlation::identity;
}

}  // namespace tocsin
