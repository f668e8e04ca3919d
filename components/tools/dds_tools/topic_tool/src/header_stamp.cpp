// SPDX-License-Identifier: Apache-2.0
#include "header_stamp.hpp"

#include <string>
#include <vector>

namespace tocsin::topic_tool {
namespace {

class StampFinder final : public FieldVisitor {
 public:
  void number(const char*, double) override {}
  void integer(const char* name, std::int64_t value) override {
    if (path_ != std::vector<std::string>{"header", "stamp"}) return;
    constexpr std::int64_t ns_per_s = 1'000'000'000;
    const bool whole = std::string(name) == "sec";
    stamp_ns = stamp_ns.value_or(0) + (whole ? value * ns_per_s : value);
  }
  void text(const char*, const std::string&) override {}
  void bytes(const char*, const std::uint8_t*, std::size_t) override {}
  void begin_struct(const char* name) override { path_.emplace_back(name); }
  void end_struct() override { path_.pop_back(); }
  void begin_list(const char* name, std::size_t) override { path_.emplace_back(name); }
  void end_list() override { path_.pop_back(); }
  std::optional<std::int64_t> stamp_ns;

 private:
  std::vector<std::string> path_;
};

}  // namespace

std::optional<std::int64_t> header_stamp_ns(const TypeInfo& type, const void* message) {
  StampFinder finder;
  type.visit(message, finder);
  return finder.stamp_ns;
}

}  // namespace tocsin::topic_tool
