// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/flat_message.hpp"

#include <cmath>

#include "foundation/printable.hpp"

namespace tocsin {
namespace {

constexpr std::size_t longest_text = 4096;  // [byte]
constexpr std::size_t longest_list = 4096;

std::string json_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : printable(text, longest_text)) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

/// Outside of lists a leaf becomes a column; inside, the whole list becomes one JSON text.
class Flattener : public FieldVisitor {
 public:
  std::vector<FlatField> fields;

  void number(const char* name, double value) override {
    const std::string text = std::isfinite(value) ? shortest_text(value) : "";
    leaf(name, text, text.empty() ? "null" : text);
  }
  void integer(const char* name, std::int64_t value) override {
    leaf(name, std::to_string(value), std::to_string(value));
  }
  void text(const char* name, const std::string& value) override {
    leaf(name, lists_ == 0 ? printable(value, longest_text) : "", json_text(value));
  }
  void bytes(const char* name, const std::uint8_t*, std::size_t size) override {
    leaf((std::string(name) + ".size").c_str(), std::to_string(size), std::to_string(size));
  }
  void begin_struct(const char* name) override {
    if (lists_ == 0) {
      path_.push_back(path(name) + ".");
    } else {
      open(name, '{');
    }
  }
  void end_struct() override {
    if (lists_ == 0) {
      path_.pop_back();
    } else {
      close('}');
    }
  }
  void begin_list(const char* name, std::size_t size) override {
    if (lists_ == 0) {
      list_name_ = path(name);
      list_size_ = size;
      json_.clear();
    }
    open(name, '[');
    ++lists_;
  }
  void end_list() override {
    close(']');
    if (--lists_ > 0) return;
    fields.push_back({list_name_, is_too_long() ? std::to_string(list_size_) : json_});
  }

 private:
  [[nodiscard]] bool is_too_long() const { return list_size_ > longest_list; }
  [[nodiscard]] std::string path(const char* name) const {
    return (path_.empty() ? "" : path_.back()) + name;
  }
  void leaf(const char* name, const std::string& plain, const std::string& json) {
    if (lists_ == 0) {
      fields.push_back({path(name), plain});
    } else if (!is_too_long()) {
      separate(name);
      json_ += json;
    }
  }
  /// The comma, and within an object the key, in front of a value.
  void separate(const char* name) {
    if (!json_.empty() && json_.back() != '[' && json_.back() != '{') json_ += ",";
    if (!brackets_.empty() && brackets_.back() == '{') json_ += json_text(name) + ":";
  }
  void open(const char* name, char bracket) {
    separate(name);
    brackets_.push_back(bracket);
    json_ += bracket;
  }
  void close(char bracket) {
    brackets_.pop_back();
    json_ += bracket;
  }

  std::vector<std::string> path_;
  std::string list_name_;
  std::size_t list_size_ = 0;
  std::string json_;
  std::string brackets_;
  int lists_ = 0;
};

}  // namespace

std::vector<FlatField> flatten(const TypeInfo& type, const void* message) {
  Flattener flattener;
  type.visit(message, flattener);
  return std::move(flattener.fields);
}

}  // namespace tocsin
