// SPDX-License-Identifier: Apache-2.0
#include "topic_choice.hpp"

#include <algorithm>
#include <boost/regex.hpp>
#include <optional>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::bag_tool {
namespace {

using Expression = std::optional<boost::regex>;

Expression compiled(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  try {
    return boost::regex(text);
  } catch (const boost::regex_error& error) {
    throw ConfigError(std::string(option) + ": '" + printable(text) +
                      "' is no regular expression: " + error.what());
  }
}

bool matches(const Expression& expression, const std::string& topic) {
  try {
    return expression && boost::regex_search(topic, *expression);
  } catch (const std::runtime_error&) {
    throw ConfigError("the regular expression '" + printable(expression->str()) +
                      "' takes too long for the topic " + printable(topic));
  }
}

bool names(const std::vector<std::string>& topics, const std::string& topic) {
  return std::find(topics.begin(), topics.end(), topic) != topics.end();
}

}  // namespace

struct TopicChoice::Expressions {
  Expression wanted;
  Expression excluded;
};

std::string absolute(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic : "/" + topic;
}

TopicChoice::TopicChoice(const TopicWishes& wishes)
    : wishes_(wishes),
      expressions_(std::make_unique<Expressions>(Expressions{
          compiled("--regex", wishes.regex), compiled("--exclude-regex", wishes.exclude_regex)})) {
  for (auto* const topics : {&wishes_.topics, &wishes_.exclude_topics}) {
    std::transform(topics->begin(), topics->end(), topics->begin(), absolute);
  }
}

TopicChoice::~TopicChoice() = default;

bool TopicChoice::contains(const std::string& topic) const {
  return is_wanted(topic) && !is_excluded(topic);
}

bool TopicChoice::is_wanted(const std::string& topic) const {
  if (names(wishes_.topics, topic)) return true;
  if (!wishes_.hidden && topic.find("/_") != std::string::npos) return false;
  const bool nothing_said = wishes_.topics.empty() && wishes_.regex.empty();
  return wishes_.all || nothing_said || matches(expressions_->wanted, topic);
}

bool TopicChoice::is_excluded(const std::string& topic) const {
  return names(wishes_.exclude_topics, topic) || matches(expressions_->excluded, topic);
}

}  // namespace tocsin::bag_tool
