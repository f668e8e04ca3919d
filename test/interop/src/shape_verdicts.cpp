// SPDX-License-Identifier: Apache-2.0
// What the output of a case's programs says.
#include <algorithm>
#include <cstdio>
#include <map>

#include "shape_cases.hpp"

namespace tocsin::interop {
namespace {

/// Sizes of the samples of each colour, in their order.
std::map<std::string, std::vector<int>> sizes_of(const std::vector<std::string>& output) {
  std::map<std::string, std::vector<int>> sizes;
  for (const std::string& line : output) {
    char topic[32];
    char color[32];
    int x = 0;
    int y = 0;
    int size = 0;
    if (std::sscanf(line.c_str(), "%31s %31s %d %d [%d]", topic, color, &x, &y, &size) == 5) {
      sizes[color].push_back(size);
    }
  }
  return sizes;
}

std::size_t count_of(const std::vector<std::string>& output, const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      output.begin(), output.end(),
      [&text](const std::string& line) { return line.find(text) != std::string::npos; }));
}

bool has(const std::vector<std::string>& output, const char* text) {
  return count_of(output, text) > 0;
}

/// Each size differs from the one before by `least` to `most`. The first of all may be any, as the
/// suite has it.
bool steps(const std::vector<int>& sizes, int least, int most) {
  for (std::size_t i = 2; i < sizes.size(); ++i) {
    const int step = sizes[i] - sizes[i - 1];
    if (step < least || step > most) return false;
  }
  return true;
}

/// Runs of consecutive sizes, of which the first and the last may be cut, have two or three
/// members.
bool has_runs_of_two_or_three(const std::vector<int>& sizes) {
  std::vector<int> runs{1};
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    sizes[i] == sizes[i - 1] + 1 ? ++runs.back() : (runs.push_back(1), 0);
  }
  if (runs.size() < 3) return false;
  return std::all_of(runs.begin() + 1, runs.end() - 1,
                     [](int run) { return run == 2 || run == 3; });
}

template <class Holds>
Code ok_if_all(const std::map<std::string, std::vector<int>>& sizes, const Holds& holds) {
  return std::all_of(sizes.begin(), sizes.end(),
                     [&holds](const auto& one) { return holds(one.second); })
             ? Code::ok
             : Code::data_not_correct;
}

Code one_or_both(std::size_t count) {
  return count == 1 ? Code::receiving_from_one : Code::receiving_from_both;
}

std::size_t different_sizes(const std::map<std::string, std::vector<int>>& sizes) {
  std::map<int, int> seen;
  for (const auto& one : sizes) {
    // Before the stronger writer is known, a sample of the weaker one may pass.
    for (std::size_t i = one.second.size() / 2; i < one.second.size(); ++i) ++seen[one.second[i]];
  }
  return seen.size();
}

Code checked(const std::vector<std::string>& output, Check check) {
  const auto sizes = sizes_of(output);
  switch (check) {
    case Check::in_order:
      return ok_if_all(sizes, [](const auto& s) { return steps(s, 1, 1 << 20); });
    case Check::no_losses:
      return ok_if_all(sizes, [](const auto& s) { return steps(s, 1, 1); });
    case Check::every_tenth:
      return ok_if_all(sizes, [](const auto& s) { return steps(s, 9, 19); });
    case Check::two_or_three:
      return ok_if_all(sizes, has_runs_of_two_or_three);
    case Check::at_most_20:
      return ok_if_all(sizes,
                       [](const auto& s) { return *std::max_element(s.begin(), s.end()) <= 20; });
    case Check::first_kept:
      return ok_if_all(sizes, [](const auto& s) { return s.front() == 1; });
    case Check::first_gone:
      return ok_if_all(sizes, [](const auto& s) { return s.front() > 1; });
    case Check::sizes:
      return one_or_both(different_sizes(sizes));
    case Check::colors:
      return one_or_both(sizes.size());
    case Check::no_writers:
      return count_of(output, "NO_WRITERS") >= 4 ? Code::ok : Code::data_not_correct;
    case Check::disposed:
      return count_of(output, "DISPOSED") >= 4 ? Code::ok : Code::data_not_correct;
    case Check::ballast:
      return has(output, "{255}") ? Code::ok : Code::data_not_correct;
    default:
      return Code::ok;
  }
}

/// Samples of each colour that decide.
std::size_t wanted(Check check) {
  switch (check) {
    case Check::received:
    case Check::first_kept:
    case Check::first_gone:
      return 1;
    case Check::every_tenth:
      return 4;
    case Check::two_or_three:
      return 12;
    case Check::ballast:
      return 10;
    default:
      return 60;
  }
}

}  // namespace

const char* word_of(Code code) {
  constexpr const char* words[] = {"OK",
                                   "INCOMPATIBLE_QOS",
                                   "READER_NOT_MATCHED",
                                   "DATA_NOT_RECEIVED",
                                   "DATA_NOT_CORRECT",
                                   "DEADLINE_MISSED",
                                   "RECEIVING_FROM_ONE",
                                   "RECEIVING_FROM_BOTH",
                                   "UNSUPPORTED_FEATURE",
                                   "NOT_CREATED"};
  return words[static_cast<std::size_t>(code)];
}

Code code_of_publisher(const std::vector<std::string>& output, bool prints) {
  if (has(output, "not supported")) return Code::unsupported;
  if (!has(output, "Create writer for topic")) return Code::not_created;
  if (has(output, "on_offered_incompatible_qos")) return Code::incompatible_qos;
  if (!has(output, "on_publication_matched")) return Code::reader_not_matched;
  return prints && has(output, "on_offered_deadline_missed") ? Code::deadline_missed : Code::ok;
}

Code code_of_subscriber(const std::vector<std::string>& output, Check check) {
  if (has(output, "not supported")) return Code::unsupported;
  if (!has(output, "Create reader for topic")) return Code::not_created;
  if (has(output, "on_requested_incompatible_qos")) return Code::incompatible_qos;
  if (check == Check::deadline && has(output, "on_requested_deadline_missed")) {
    return Code::deadline_missed;
  }
  if (sizes_of(output).empty()) return Code::data_not_received;
  return checked(output, check);
}

bool is_enough(const std::vector<std::string>& output, Check check) {
  if (has(output, "incompatible_qos") || has(output, "not supported")) return true;
  if (check == Check::deadline) return has(output, "deadline_missed");
  if (check == Check::no_writers) return count_of(output, "NO_WRITERS") >= 4;
  if (check == Check::disposed) return count_of(output, "NOT_ALIVE") >= 4;
  const auto sizes = sizes_of(output);
  return !sizes.empty() && std::all_of(sizes.begin(), sizes.end(), [check](const auto& one) {
    return one.second.size() >= wanted(check);
  });
}

}  // namespace tocsin::interop
