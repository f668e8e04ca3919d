// SPDX-License-Identifier: Apache-2.0
#include "operator_server/client_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "little_endian.hpp"

namespace tocsin::foxglove {
namespace {

using nlohmann::json;

constexpr std::size_t deepest_frame = 32;  ///< no message of the protocol needs a quarter

/// Ends the reading of one frame; goes no further than parse_text and parse_binary.
class Fault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void fail(const std::string& where, const std::string& rule) {
  throw Fault(where + ": must be " + rule);
}

/// One object of a message, and where it stands in it.
class Fields {
 public:
  Fields(const json& object, std::string where) : object_(object), where_(std::move(where)) {
    if (!object.is_object()) fail(where_, "an object");
  }
  [[nodiscard]] std::string text(const char* key) const {
    const json& value = at(key);
    if (!value.is_string()) fail(path(key), "a text");
    return value.get<std::string>();
  }
  [[nodiscard]] std::string text_or_none(const char* key) const {
    return has(key) ? text(key) : std::string();
  }
  [[nodiscard]] std::optional<std::string> optional_text(const char* key) const {
    return has(key) ? std::optional<std::string>(text(key)) : std::nullopt;
  }
  [[nodiscard]] std::uint32_t id(const char* key) const { return id_of(at(key), path(key)); }
  [[nodiscard]] std::vector<std::uint32_t> ids(const char* key) const {
    std::vector<std::uint32_t> ids;
    each(key,
         [&](const json& value, const std::string& where) { ids.push_back(id_of(value, where)); });
    return ids;
  }
  [[nodiscard]] std::vector<std::string> texts(const char* key) const {
    std::vector<std::string> texts;
    each(key, [&](const json& value, const std::string& where) {
      if (!value.is_string()) fail(where, "a text");
      texts.push_back(value.get<std::string>());
    });
    return texts;
  }
  /// Calls `take` with each object of a list.
  template <class Take>
  void objects(const char* key, Take take) const {
    each(key, [&](const json& value, const std::string& where) { take(Fields(value, where)); });
  }
  [[nodiscard]] json value_or_null(const char* key) const {
    return has(key) ? object_.at(key) : json();
  }

 private:
  [[nodiscard]] std::string path(const char* key) const { return where_ + "." + key; }
  [[nodiscard]] bool has(const char* key) const {
    const auto found = object_.find(key);
    return found != object_.end() && !found->is_null();
  }
  [[nodiscard]] const json& at(const char* key) const {
    const auto found = object_.find(key);
    if (found == object_.end()) throw Fault(path(key) + ": is missing");
    return *found;
  }
  template <class Take>
  void each(const char* key, Take take) const {
    const json& list = at(key);
    if (!list.is_array()) fail(path(key), "a list");
    for (std::size_t i = 0; i < list.size(); ++i)
      take(list[i], fmt::format("{}[{}]", path(key), i));
  }
  static std::uint32_t id_of(const json& value, const std::string& where) {
    constexpr auto most = std::numeric_limits<std::uint32_t>::max();
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most) {
      fail(where, fmt::format("a whole number in [0, {}]", most));
    }
    return value.get<std::uint32_t>();
  }
  const json& object_;
  const std::string where_;
};

ClientMessage read_subscribe(const Fields& fields) {
  Subscribe message;
  fields.objects("subscriptions", [&](const Fields& one) {
    message.wishes.push_back({one.id("id"), one.id("channelId")});
  });
  return message;
}

ClientMessage read_advertise(const Fields& fields) {
  Advertise message;
  fields.objects("channels", [&](const Fields& one) {
    message.channels.push_back(
        {one.id("id"), one.text("topic"), one.text("encoding"), one.text("schemaName")});
  });
  return message;
}

ClientMessage read_set_parameters(const Fields& fields) {
  SetParameters message;
  fields.objects("parameters", [&](const Fields& one) {
    message.parameters.push_back(
        {one.text("name"), one.value_or_null("value"), one.text_or_none("type")});
  });
  message.id = fields.optional_text("id");
  return message;
}

using Read = ClientMessage (*)(const Fields&);
const std::map<std::string, Read>& readers() {
  static const std::map<std::string, Read> all{
      {"subscribe", read_subscribe},
      {"unsubscribe",
       [](const Fields& f) -> ClientMessage { return Unsubscribe{f.ids("subscriptionIds")}; }},
      {"advertise", read_advertise},
      {"unadvertise",
       [](const Fields& f) -> ClientMessage { return Unadvertise{f.ids("channelIds")}; }},
      {"getParameters",
       [](const Fields& f) -> ClientMessage {
         return GetParameters{f.texts("parameterNames"), f.optional_text("id")};
       }},
      {"setParameters", read_set_parameters},
      {"subscribeParameterUpdates",
       [](const Fields& f) -> ClientMessage {
         return SubscribeParameters{f.texts("parameterNames")};
       }},
      {"unsubscribeParameterUpdates",
       [](const Fields& f) -> ClientMessage {
         return UnsubscribeParameters{f.texts("parameterNames")};
       }},
      {"subscribeConnectionGraph", [](const Fields&) -> ClientMessage { return SubscribeGraph{}; }},
      {"unsubscribeConnectionGraph",
       [](const Fields&) -> ClientMessage { return UnsubscribeGraph{}; }},
  };
  return all;
}

/// Lists and objects within each other, of which texts hold none.
std::size_t depth_of(std::string_view frame) {
  std::size_t depth = 0;
  std::size_t deepest = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const char c = frame[i];
    if (in_text && c == '\\') ++i;
    if (c == '"') in_text = !in_text;
    if (in_text) continue;
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    if ((c == ']' || c == '}') && depth > 0) --depth;
  }
  return deepest;
}

ClientMessage read_operation(const json& message) {
  const std::string op = Fields(message, "message").text("op");
  const auto found = readers().find(op);
  if (found == readers().end()) {
    std::vector<std::string> known;
    for (const auto& reader : readers()) known.push_back(reader.first);
    throw Fault("op: '" + printable(op, 50) + "' is not known here" +
                did_you_mean(known, op, "known are"));
  }
  return found->second(Fields(message, op));
}

}  // namespace

ClientMessage parse_text(std::string_view frame) {
  if (depth_of(frame) > deepest_frame) {
    return ProtocolFault{fmt::format("the frame is deeper than {}", deepest_frame)};
  }
  const json message = json::parse(frame, nullptr, false);
  if (message.is_discarded())
    return ProtocolFault{"the frame is not JSON: " + printable(frame, 50)};
  try {
    return read_operation(message);
  } catch (const Fault& fault) {
    return ProtocolFault{fault.what()};
  }
}

ClientMessage parse_binary(std::string_view frame) {
  enum : std::uint8_t { message_data = 1, service_request = 2 };
  Bytes bytes(frame);
  const auto opcode = bytes.take<std::uint8_t>();
  if (!opcode) return ProtocolFault{"the binary frame is empty"};
  if (*opcode == message_data) {
    const auto channel = bytes.take<std::uint32_t>();
    if (!channel) return ProtocolFault{"message data: the frame ends before its channel"};
    return Publish{*channel, std::string(bytes.rest())};
  }
  if (*opcode == service_request) {
    const auto service = bytes.take<std::uint32_t>();
    const auto call = bytes.take<std::uint32_t>();
    const auto length = bytes.take<std::uint32_t>();
    const auto encoding = length ? bytes.take_text(*length) : std::nullopt;
    if (!service || !call || !encoding) {
      return ProtocolFault{"service request: the frame ends before its payload"};
    }
    return CallService{*service, *call, std::string(*encoding), std::string(bytes.rest())};
  }
  return ProtocolFault{
      fmt::format("the binary frame has opcode {}, not 1 (message data) or 2 "
                  "(service request)",
                  *opcode)};
}

}  // namespace tocsin::foxglove
