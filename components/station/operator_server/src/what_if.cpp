// SPDX-License-Identifier: Apache-2.0
#include "operator_server/what_if.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "foundation/printable.hpp"
#include "operator_server/access.hpp"

namespace tocsin::foxglove {
namespace {

constexpr std::size_t most_changes = 20;
constexpr std::size_t longest_word = 100;

/// Names and numbers, and lists of them. Not at the beginning of an option.
bool is_word(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == '-' || c == '+' || c == ',' || c == '[' || c == ']';
  };
  return !text.empty() && text.size() <= longest_word &&
         std::all_of(text.begin(), text.end(), is_plain);
}

}  // namespace

std::variant<WhatIf, std::string> parse_what_if(const std::string& query) {
  auto values = query_values(query);
  values.erase("token");
  const auto role = role_of(values["host"]);
  if (!role) return "host '" + printable(values["host"], 40) + "' is not one of: uxv, gcs";
  WhatIf question{*role, values["policy"]};
  values.erase("host");
  values.erase("policy");
  for (const auto& [key, value] : values) {
    if (!is_word(key) || !is_word(value) || key.front() == '-') {
      return "'" + printable(key, 40) + "=" + printable(value, 40) + "' is no parameter=value";
    }
    question.changes.push_back(key + "=" + value);
  }
  if (question.changes.size() > most_changes) {
    return std::to_string(question.changes.size()) + " parameters; at most " +
           std::to_string(most_changes);
  }
  const std::string& policy = question.policy;
  if (!policy.empty() && (!is_word(policy) || policy.front() == '-')) {
    return "policy '" + printable(policy, 40) + "' is no name";
  }
  return question;
}

std::vector<std::string> what_if_command(const std::string& program, const std::string& recording,
                                         const WhatIf& question) {
  std::vector<std::string> command{program,  recording, "--host", to_string(question.host),
                                   "--json", "--rows"};
  if (!question.policy.empty()) command.insert(command.end(), {"--policy", question.policy});
  for (const std::string& change : question.changes) {
    command.insert(command.end(), {"--set", change});
  }
  return command;
}

std::string last_rows(const std::string& printed, double window_s) {
  auto answer = nlohmann::json::parse(printed, nullptr, false);
  if (!answer.is_object() || !answer.contains("rows")) return printed;
  auto& rows = answer["rows"];
  const double last = rows.empty() ? 0 : rows.back().value("time_s", 0.0);
  auto kept = nlohmann::json::array();
  for (auto& row : rows) {
    if (row.value("time_s", 0.0) >= last - window_s) kept.push_back(std::move(row));
  }
  answer["rows"] = std::move(kept);
  answer.erase("file");
  answer.erase("parameters");
  return answer.dump();
}

}  // namespace tocsin::foxglove
