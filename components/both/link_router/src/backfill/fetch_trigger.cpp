// SPDX-License-Identifier: Apache-2.0
#include "backfill/fetch_trigger.hpp"

#include <cstdint>
#include <string>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "idl_support/topic_registry.hpp"
#include "idl_support/type_info.hpp"
#include "runtime/middleware/idl_libraries.hpp"

namespace tocsin {
namespace {

std::optional<KnownTopic> registered(const std::string& name) {
  for (const KnownTopic& one : known_topics()) {
    if (one.info.name == name) return one;
  }
  return std::nullopt;
}

KnownTopic known_topic(const FetchRule& rule) {
  if (const auto known = registered(rule.when)) return *known;
  load_idl_libraries();
  if (const auto known = registered(rule.when)) return *known;
  std::vector<std::string> names;
  for (const KnownTopic& one : known_topics()) names.emplace_back(one.info.name);
  throw ConfigError(rule.name + ".when: no installed package knows a topic " +
                    printable(rule.when) + did_you_mean(names, rule.when, "they know"));
}

Endpoint endpoint_of(const FetchRule& rule) {
  const KnownTopic topic = known_topic(rule);
  return {topic.info, topic.type, Writers::optional};
}

/// Finds a number, or a truth as 0 or 1, by its path. What is in lists has none.
class NumberFinder final : public FieldVisitor {
 public:
  explicit NumberFinder(std::string path) : path_(std::move(path)) {}
  void number(const char* name, double value) override {
    if (lists_ > 0) return;
    all.push_back(prefix_ + name);
    if (all.back() == path_) found = value;
  }
  void integer(const char* name, std::int64_t value) override {
    number(name, static_cast<double>(value));
  }
  void text(const char*, const std::string&) override {}
  void bytes(const char*, const std::uint8_t*, std::size_t) override {}
  void begin_struct(const char* name) override { prefix_ += std::string(name) + "."; }
  void end_struct() override {
    prefix_.pop_back();
    prefix_.erase(prefix_.rfind('.') + 1);  // npos + 1 is 0
  }
  void begin_list(const char*, std::size_t) override { ++lists_; }
  void end_list() override { --lists_; }

  std::optional<double> found;
  std::vector<std::string> all;  ///< paths of what can be found

 private:
  const std::string path_;
  std::string prefix_;
  int lists_ = 0;
};

}  // namespace

FetchTrigger::FetchTrigger(Component& owner, const FetchRule& rule)
    : rule_(rule),
      type_(*known_topic(rule).type),
      input_(owner, endpoint_of(rule), WakeMode::time_triggered) {
  if (rule.field.empty()) return;
  NumberFinder finder(rule.field);
  type_.visit(type_.create().get(), finder);
  if (finder.found) return;
  throw ConfigError(rule.name + ".field: " + printable(rule.when) + " has no number or truth " +
                    printable(rule.field) + did_you_mean(finder.all, rule.field, "it has"));
}

bool FetchTrigger::holds(const void* message) const {
  if (rule_.field.empty()) return true;
  NumberFinder finder(rule_.field);
  type_.visit(message, finder);
  return finder.found && *finder.found > rule_.above && *finder.found < rule_.below;
}

std::optional<Time> FetchTrigger::take() {
  std::optional<Time> event;
  while (const auto sample = input_.take_sample()) {
    if (sample->message == nullptr) continue;
    const bool held = std::exchange(holds_, holds(sample->message.get()));
    if (!holds_) continue;
    const bool is_late = !last_ || sample->received - *last_ > seconds(rule_.min_interval_s);
    const bool goes_on = held && !rule_.field.empty();
    last_ = sample->received;
    if (is_late && !goes_on) event = sample->received;
  }
  return event;
}

std::vector<std::unique_ptr<FetchTrigger>> make_triggers(Component& owner,
                                                         const std::vector<FetchRule>& rules) {
  std::vector<std::unique_ptr<FetchTrigger>> triggers;
  for (const FetchRule& rule : rules) {
    triggers.push_back(std::make_unique<FetchTrigger>(owner, rule));
  }
  return triggers;
}

}  // namespace tocsin
