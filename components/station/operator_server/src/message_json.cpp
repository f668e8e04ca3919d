// SPDX-License-Identifier: Apache-2.0
#include "operator_server/message_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "idl_support/decode.hpp"

namespace tocsin::foxglove {
namespace {

using nlohmann::json;

/// Ends the reading of one message; goes no further than message_from_json.
class BadMessage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes the values of a message out of JSON.
class JsonFiller final : public FieldEditor {
 public:
  explicit JsonFiller(const json& root) { frames_.push_back({&root, "", 0, {}}); }

  void number(const char* name, double& value) override {
    const json* const given = next(name);
    if (given == nullptr) return;
    if (given->is_null()) {
      value = std::numeric_limits<double>::quiet_NaN();
    } else if (given->is_number()) {
      value = given->get<double>();
    } else {
      refuse(name, "a number, or null for NaN");
    }
  }
  void integer(const char* name, std::int64_t& value, const IntegerRange& range) override {
    const json* const given = next(name);
    if (given == nullptr) return;
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    const bool fits = given->is_number_integer() &&
                      (!given->is_number_unsigned() || given->get<std::uint64_t>() <= most);
    if (!fits || given->get<std::int64_t>() < range.least ||
        given->get<std::int64_t>() > range.most) {
      refuse(name, fmt::format("a whole number in [{}, {}]", range.least, range.most));
    }
    value = given->get<std::int64_t>();
  }
  void boolean(const char* name, bool& value) override {
    const json* const given = next(name);
    if (given == nullptr) return;
    if (!given->is_boolean()) refuse(name, "true or false");
    value = given->get<bool>();
  }
  void text(const char* name, std::string& value) override {
    const json* const given = next(name);
    if (given == nullptr) return;
    if (!given->is_string()) refuse(name, "a text");
    value = given->get<std::string>();
  }
  void bytes(const char* name, std::vector<std::uint8_t>& value) override {
    value.resize(begin_list(name, value.size()));
    for (std::uint8_t& byte : value) {
      std::int64_t wide = byte;
      integer(name, wide, {0, 255});
      byte = static_cast<std::uint8_t>(wide);
    }
    end_list();
  }
  void begin_struct(const char* name) override {
    const json* const given = next(name);
    if (given != nullptr && !given->is_object()) refuse(name, "an object");
    frames_.push_back({given, path_of(name), 0, {}});
  }
  void end_struct() override { leave(); }
  std::size_t begin_list(const char* name, std::size_t size) override {
    const json* const given = next(name);
    if (given != nullptr && !given->is_array()) refuse(name, "a list");
    frames_.push_back({given, path_of(name), 0, {}});
    return given == nullptr ? size : given->size();
  }
  void end_list() override { frames_.pop_back(); }
  /// Refuses keys that no field has.
  void leave() {
    const Frame& frame = frames_.back();
    if (frame.node != nullptr && frame.node->is_object()) {
      for (const auto& entry : frame.node->items()) refuse_unknown(entry.key(), frame);
    }
    frames_.pop_back();
  }

 private:
  struct Frame {
    const json* node;  ///< null: not given
    std::string path;
    std::size_t index;  ///< of a list's next element
    std::vector<std::string> fields;
  };
  static void refuse_unknown(const std::string& key, const Frame& frame) {
    if (std::find(frame.fields.begin(), frame.fields.end(), key) != frame.fields.end()) return;
    throw BadMessage((frame.path.empty() ? "" : frame.path + ": ") + "there is no field '" +
                     printable(key, 50) + "'" + did_you_mean(frame.fields, key, "fields:"));
  }
  [[noreturn]] void refuse(const char* name, const std::string& rule) const {
    throw BadMessage(path_of(name) + ": must be " + rule);
  }
  [[nodiscard]] std::string path_of(const char* name) const {
    const Frame& frame = frames_.back();
    if (frame.node != nullptr && frame.node->is_array()) {
      return fmt::format("{}[{}]", frame.path, frame.index - 1);
    }
    return frame.path.empty() ? name : frame.path + "." + name;
  }
  /// Null: not given.
  const json* next(const char* name) {
    Frame& frame = frames_.back();
    if (frame.node == nullptr) return nullptr;
    if (frame.node->is_array()) {
      return frame.index < frame.node->size() ? &(*frame.node)[frame.index++] : nullptr;
    }
    frame.fields.emplace_back(name);
    const auto found = frame.node->find(name);
    return found == frame.node->end() ? nullptr : &*found;
  }
  std::vector<Frame> frames_;
};

/// Makes JSON of a message.
class JsonWriter final : public FieldVisitor {
 public:
  void number(const char* name, double value) override {
    add(name, std::isfinite(value) ? json(value) : json());
  }
  void integer(const char* name, std::int64_t value) override { add(name, value); }
  void boolean(const char* name, bool value) override { add(name, value); }
  void text(const char* name, const std::string& value) override { add(name, value); }
  void bytes(const char* name, const std::uint8_t* data, std::size_t size) override {
    add(name, std::vector<std::uint8_t>(data, data + size));
  }
  void begin_struct(const char* name) override { open(name, json::object()); }
  void end_struct() override { close(); }
  void begin_list(const char* name, std::size_t /*size*/) override { open(name, json::array()); }
  void end_list() override { close(); }
  [[nodiscard]] json take() { return std::move(stack_.front().second); }

 private:
  void add(const char* name, json value) {
    json& at = stack_.back().second;
    if (at.is_array()) {
      at.push_back(std::move(value));
    } else {
      at[name] = std::move(value);
    }
  }
  void open(const char* name, json empty) { stack_.emplace_back(name, std::move(empty)); }
  void close() {
    auto [name, value] = std::move(stack_.back());
    stack_.pop_back();
    add(name.c_str(), std::move(value));
  }
  std::vector<std::pair<std::string, json>> stack_{{"", json::object()}};
};

}  // namespace

MadeMessage message_from_json(const TypeInfo& type, std::string_view text) {
  const json root = json::parse(text, nullptr, false);
  if (!root.is_object()) return {nullptr, "the message is not a JSON object"};
  MadeMessage made{type.create()};
  try {
    JsonFiller filler(root);
    type.edit(made.message.get(), filler);
    filler.leave();
  } catch (const BadMessage& fault) {
    return {nullptr, fault.what()};
  }
  return made;
}

MadeMessage message_from_cdr(const TypeInfo& type, std::string_view bytes) {
  if (auto message = decode(type, {bytes.begin(), bytes.end()})) return {std::move(message)};
  return {nullptr, fmt::format("{} bytes are not the CDR of a {}", bytes.size(), type.name)};
}

MadeMessage message_from(const TypeInfo& type, const std::string& encoding,
                         std::string_view payload) {
  return encoding == "json" ? message_from_json(type, payload) : message_from_cdr(type, payload);
}

nlohmann::json json_of(const TypeInfo& type, const void* message) {
  JsonWriter writer;
  type.visit(message, writer);
  return writer.take();
}

}  // namespace tocsin::foxglove
