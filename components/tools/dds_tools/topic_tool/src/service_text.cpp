// SPDX-License-Identifier: Apache-2.0
#include "service_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "graph_names.hpp"
#include "python_float.hpp"

namespace tocsin::topic_tool {
namespace {

/// Python's repr of each field, with commas between.
class PythonWriter final : public FieldVisitor {
 public:
  void number(const char* name, double value) override { add(name, python_float(value)); }
  void single(const char* name, float value) override { add(name, python_float(value)); }
  void integer(const char* name, std::int64_t value) override { add(name, std::to_string(value)); }
  void boolean(const char* name, bool value) override { add(name, value ? "True" : "False"); }
  void text(const char* name, const std::string& value) override {
    add(name, "'" + printable(value) + "'");
  }
  void bytes(const char* name, const std::uint8_t* data, std::size_t size) override {
    begin_list(name, size);
    for (std::size_t i = 0; i < size; ++i) add("", std::to_string(data[i]));
    end_list();
  }
  void begin_struct(const char* name) override { begin(name, "("); }
  void end_struct() override { end(")"); }
  void begin_list(const char* name, std::size_t) override { begin(name, "["); }
  void end_list() override { end("]"); }
  [[nodiscard]] const std::string& written() const { return text_; }

 private:
  void begin(const char* name, const char* bracket) {
    add(name, bracket);
    first_ = true;
    in_list_.push_back(*bracket == '[');
  }
  void end(const char* bracket) {
    text_ += bracket;
    first_ = false;
    in_list_.pop_back();
  }
  /// What stands in a list has no name of its own.
  void add(const char* name, const std::string& value) {
    if (name == std::string_view("structure_needs_at_least_one_member")) return;  // of nothing
    if (!first_) text_ += ", ";
    first_ = false;
    const bool named = in_list_.empty() || !in_list_.back();
    text_ += (named ? std::string(name) + "=" : "") + value;
  }
  std::string text_;
  bool first_ = true;
  std::vector<bool> in_list_;
};

}  // namespace

std::map<std::string, std::set<std::string>> services_in(const std::vector<GraphEnd>& ends) {
  std::map<std::string, std::set<std::string>> services;
  for (const GraphEnd& end : ends) {
    const auto service = ros_service(end.topic);
    if (service) services[service->name].insert(ros_service_type(end.type));
  }
  return services;
}

std::string service_list_text(const std::vector<GraphEnd>& ends,
                              const ServiceListOptions& options) {
  std::string text;
  int count = 0;
  for (const auto& [name, types] : services_in(ends)) {
    if (!options.hidden && is_hidden(name)) continue;
    ++count;
    text += printable(name) + (options.types ? " [" + types_text(types) + "]" : "") + "\n";
  }
  return options.count ? fmt::format("{}\n", count) : text;
}

std::string python_text(const TypeInfo& type, const void* message) {
  PythonWriter writer;
  type.visit(message, writer);
  std::string name = ros_type(type.name);
  std::replace(name.begin(), name.end(), '/', '.');
  return name + "(" + writer.written() + ")";
}

}  // namespace tocsin::topic_tool
