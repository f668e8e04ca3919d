// SPDX-License-Identifier: Apache-2.0
// What clients of the Foxglove WebSocket protocol say (foxglove-sdk, protocol v1). Pure.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tocsin::foxglove {

struct Subscribe {
  struct Wish {
    std::uint32_t id;  ///< of the subscription, chosen by the client
    std::uint32_t channel;
  };
  std::vector<Wish> wishes;
};
struct Unsubscribe {
  std::vector<std::uint32_t> ids;
};

/// A topic on which a client wants to publish.
struct ClientChannel {
  std::uint32_t id = 0;     ///< chosen by the client
  std::string topic;        ///< `/goal`
  std::string encoding;     ///< of its messages: `cdr`, `json`
  std::string schema_name;  ///< `tocsin_msgs/msg/Goal`
};
struct Advertise {
  std::vector<ClientChannel> channels;
};
struct Unadvertise {
  std::vector<std::uint32_t> ids;
};
struct Publish {
  std::uint32_t channel;
  std::string payload;
};

struct GetParameters {
  std::vector<std::string> names;  ///< none: all
  std::optional<std::string> id;   ///< of the request, repeated in the answer
};
/// A parameter as the protocol shows it.
struct Parameter {
  std::string name;      ///< `/node.parameter`
  nlohmann::json value;  ///< null: it is not set
  std::string type;      ///< `float64`, `float64_array`, `byte_array`; empty: as the value shows
};
struct SetParameters {
  std::vector<Parameter> parameters;
  std::optional<std::string> id;
};
struct SubscribeParameters {
  std::vector<std::string> names;  ///< none: all
};
struct UnsubscribeParameters {
  std::vector<std::string> names;
};
struct SubscribeGraph {};
struct UnsubscribeGraph {};
struct CallService {
  std::uint32_t service;
  std::uint32_t call;  ///< chosen by the client, repeated in the answer
  std::string encoding;
  std::string payload;
};

/// Why bytes of a client are no message: one line, without what could harm a terminal.
struct ProtocolFault {
  std::string reason;
};

using ClientMessage =
    std::variant<ProtocolFault, Subscribe, Unsubscribe, Advertise, Unadvertise, Publish,
                 GetParameters, SetParameters, SubscribeParameters, UnsubscribeParameters,
                 SubscribeGraph, UnsubscribeGraph, CallService>;

/// A text frame. Keys that the protocol does not know are passed over.
[[nodiscard]] ClientMessage parse_text(std::string_view frame);
/// A binary frame.
[[nodiscard]] ClientMessage parse_binary(std::string_view frame);

}  // namespace tocsin::foxglove
