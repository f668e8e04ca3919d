// SPDX-License-Identifier: Apache-2.0
#include "topic_choice.hpp"

#define PCRE2_CODE_UNIT_WIDTH 8
#include <pcre2.h>

#include <algorithm>
#include <array>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::bag_tool {
namespace {

std::string meaning_of(int error) {
  std::array<PCRE2_UCHAR, 256> text{};
  pcre2_get_error_message(error, text.data(), text.size());
  return reinterpret_cast<const char*>(text.data());
}

PCRE2_SPTR units(const std::string& text) { return reinterpret_cast<PCRE2_SPTR>(text.data()); }

/// A regular expression, or none.
class Expression {
 public:
  /// Throws ConfigError, which names `option`.
  Expression(const char* option, const std::string& text) : text_(text) {
    if (text.empty()) return;
    int error = 0;
    PCRE2_SIZE where = 0;
    code_.reset(pcre2_compile(units(text), text.size(), 0, &error, &where, nullptr));
    if (code_) return;
    throw ConfigError(std::string(option) + ": '" + printable(text) +
                      "' is no regular expression: " + meaning_of(error) + ", at character " +
                      std::to_string(where + 1));
  }

  [[nodiscard]] bool matches(const std::string& topic) const {
    if (!code_) return false;
    const std::unique_ptr<pcre2_match_data, Free> found(
        pcre2_match_data_create_from_pattern(code_.get(), nullptr));
    const int code =
        pcre2_match(code_.get(), units(topic), topic.size(), 0, 0, found.get(), nullptr);
    if (code >= 0) return true;
    if (code == PCRE2_ERROR_NOMATCH) return false;
    throw ConfigError("the regular expression '" + printable(text_) +
                      "' takes too long for the topic " + printable(topic) + ": " +
                      meaning_of(code));
  }

 private:
  struct Free {
    void operator()(pcre2_code* code) const { pcre2_code_free(code); }
    void operator()(pcre2_match_data* data) const { pcre2_match_data_free(data); }
  };
  std::string text_;
  std::unique_ptr<pcre2_code, Free> code_;
};

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
      expressions_(std::make_unique<Expressions>(
          Expressions{{"--regex", wishes.regex}, {"--exclude-regex", wishes.exclude_regex}})) {
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
  return wishes_.all || nothing_said || expressions_->wanted.matches(topic);
}

bool TopicChoice::is_excluded(const std::string& topic) const {
  return names(wishes_.exclude_topics, topic) || expressions_->excluded.matches(topic);
}

}  // namespace tocsin::bag_tool
