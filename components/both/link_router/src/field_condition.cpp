// SPDX-License-Identifier: Apache-2.0
#include "field_condition.hpp"

#include <charconv>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"

namespace tocsin {
namespace {

using FieldValue = std::variant<std::monostate, double, std::string>;

/// Finds a field by its path. What is in lists has none.
class FieldFinder final : public FieldVisitor {
 public:
  explicit FieldFinder(const std::string& wanted) : wanted_(wanted) {}

  void number(const char* name, double value) override { leaf(name, value); }
  void integer(const char* name, std::int64_t value) override {
    leaf(name, static_cast<double>(value));
  }
  void text(const char* name, const std::string& value) override { leaf(name, value); }
  void bytes(const char*, const std::uint8_t*, std::size_t) override {}
  void begin_struct(const char* name) override {
    ends_.push_back(path_.size());
    path_ += std::string(name) + ".";
  }
  void end_struct() override {
    path_.resize(ends_.back());
    ends_.pop_back();
  }
  void begin_list(const char*, std::size_t) override { ++lists_; }
  void end_list() override { --lists_; }

  FieldValue found;
  std::vector<std::string> all;  ///< paths of the fields that can be found

 private:
  template <class Value>
  void leaf(const char* name, const Value& value) {
    if (lists_ > 0) return;
    all.push_back(path_ + name);
    if (all.back() == wanted_) found = value;
  }
  const std::string& wanted_;
  std::string path_;
  std::vector<std::size_t> ends_;  ///< of the path, before each struct
  int lists_ = 0;
};

FieldFinder look(const TypeInfo& type, const void* message, const std::string& field) {
  FieldFinder finder(field);
  type.visit(message, finder);
  return finder;
}

std::optional<double> number_of(const std::string& text) {
  if (text == "true") return 1;
  if (text == "false") return 0;
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return whole ? std::optional(number) : std::nullopt;
}

}  // namespace

FieldCondition::FieldCondition(const TypeInfo& type, const FetchRule& rule)
    : type_(type), rule_(rule) {
  using Is = FetchRule::Is;
  if (rule.is == Is::any) return;
  const auto example = type.create();
  const FieldFinder finder = look(type, example.get(), rule.field);
  if (std::holds_alternative<std::monostate>(finder.found)) {
    throw ConfigError(rule.name + ".field: " + printable(rule.when) + " has no field " +
                      printable(rule.field) + did_you_mean(finder.all, rule.field, "it has"));
  }
  if (std::holds_alternative<std::string>(finder.found)) {
    if (rule.is == Is::equal) return;
    throw ConfigError(rule.name + ".field: " + printable(rule.field) +
                      " is a text, which is neither above nor below a number");
  }
  if (rule.is != Is::equal) return;
  const auto number = number_of(rule.value);
  if (!number) {
    throw ConfigError(rule.name + ".equals: '" + printable(rule.value) + "' is no number, and " +
                      printable(rule.field) + " is one");
  }
  number_ = *number;
}

bool FieldCondition::holds(const void* message) const {
  using Is = FetchRule::Is;
  if (rule_.is == Is::any) return true;
  const FieldValue value = look(type_, message, rule_.field).found;
  if (const auto* const text = std::get_if<std::string>(&value)) return *text == rule_.value;
  const auto* const number = std::get_if<double>(&value);
  if (number == nullptr) return false;
  if (rule_.is == Is::above) return *number > rule_.limit;
  return rule_.is == Is::below ? *number < rule_.limit : *number == number_;
}

}  // namespace tocsin
