// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <string>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_sources.hpp"
#include "message_yaml.hpp"

namespace tocsin::topic_tool {
namespace {

/// Takes the values of a message out of YAML.
class Filler final : public FieldEditor {
 public:
  explicit Filler(const YAML::Node& root) { frames_.push_back({root, "", false, 0, {}}); }

  void number(const char* name, double& value) override { take(name, value, "a number"); }
  void boolean(const char* name, bool& value) override { take(name, value, "true or false"); }
  void text(const char* name, std::string& value) override { take(name, value, "a text"); }
  void integer(const char* name, std::int64_t& value, const IntegerRange& range) override {
    std::int64_t given = value;
    take(name, given, "a whole number");
    if (given < range.least || given > range.most) {
      throw ConfigError(
          fmt::format("{}: {} is outside [{}, {}]", path_of(name), given, range.least, range.most));
    }
    value = given;
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
  void begin_struct(const char* name) override { enter(name, false); }
  void end_struct() override { leave(); }
  std::size_t begin_list(const char* name, std::size_t size) override {
    enter(name, true);
    const YAML::Node& list = frames_.back().node;
    return list.IsDefined() && !list.IsNull() ? list.size() : size;
  }
  void end_list() override { leave(); }
  /// Throws ConfigError for keys that no field has.
  void leave() {
    const Frame& frame = frames_.back();
    if (!frame.list && frame.node.IsMap()) {
      for (const auto& entry : frame.node) refuse_unknown(entry.first.Scalar(), frame);
    }
    frames_.pop_back();
  }

 private:
  struct Frame {
    YAML::Node node;
    std::string path;
    bool list;
    std::size_t index;
    std::vector<std::string> fields;
  };
  static void refuse_unknown(const std::string& key, const Frame& frame) {
    if (std::find(frame.fields.begin(), frame.fields.end(), key) != frame.fields.end()) return;
    throw ConfigError((frame.path.empty() ? "" : frame.path + ": ") + "no field '" +
                      printable(key) + "'" + did_you_mean(frame.fields, key, "fields"));
  }
  [[nodiscard]] std::string path_of(const char* name) const {
    const Frame& frame = frames_.back();
    if (frame.list) return frame.path + "[" + std::to_string(frame.index - 1) + "]";
    return frame.path.empty() ? name : frame.path + "." + name;
  }
  YAML::Node next(const char* name) {
    Frame& frame = frames_.back();
    const YAML::Node none(YAML::NodeType::Undefined);
    if (!frame.list) frame.fields.emplace_back(name);
    if (!frame.node.IsDefined() || frame.node.IsNull()) return none;
    if (!frame.list) return frame.node[name];
    return frame.index < frame.node.size() ? frame.node[frame.index++] : none;
  }
  void enter(const char* name, bool list) {
    const YAML::Node node = next(name);
    const std::string path = path_of(name);
    const bool given = node.IsDefined() && !node.IsNull();
    if (given && (list ? !node.IsSequence() : !node.IsMap())) {
      throw ConfigError(path + ": must be " + (list ? "a list" : "a map of its fields"));
    }
    frames_.push_back({node, path, list, 0, {}});
  }
  template <class Value>
  void take(const char* name, Value& value, const char* what) {
    const YAML::Node node = next(name);
    if (!node.IsDefined() || node.IsNull()) return;
    if (node.IsScalar() && YAML::convert<Value>::decode(node, value)) return;
    const std::string given =
        node.IsScalar() ? "'" + printable(node.Scalar()) + "' is not" : "is not";
    throw ConfigError(path_of(name) + ": " + given + " " + what);
  }
  std::vector<Frame> frames_;
};

}  // namespace

std::shared_ptr<void> from_yaml(const TypeInfo& type, const std::string& text) {
  YamlSources sources;
  const YAML::Node root = sources.parse(text, "message");
  if (root.IsDefined() && !root.IsNull() && !root.IsMap()) {
    throw ConfigError("message: must be a map of fields, such as '{data: hello}'");
  }
  std::shared_ptr<void> message = type.create();
  Filler filler(root);
  type.edit(message.get(), filler);
  filler.leave();
  return message;
}

}  // namespace tocsin::topic_tool
