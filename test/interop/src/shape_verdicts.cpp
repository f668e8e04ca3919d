// SPDX-License-Identifier: Apache-2.0
// What the output of a case's programs says.
#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "shape_cases.hpp"

namespace tocsin::interop {
namespace {

constexpr long long ns_in_ms = 1'000'000;
constexpr int any = 1 << 20;

/// A sample in a subscriber's output; stamps in ns, 0 without --stamps.
struct Seen {
  int size = 0;
  long long stamp_ns = 0;
  long long read_ns = 0;
};
using Colour = std::vector<Seen>;
using Colours = std::map<std::string, Colour>;

/// The samples of each colour, in their order.
Colours colours_of(const std::vector<std::string>& output) {
  Colours colours;
  for (const std::string& line : output) {
    char topic[32];
    char color[32];
    int x = 0;
    int y = 0;
    Seen seen;
    if (std::sscanf(line.c_str(), "%31s %31s %d %d [%d] @%lld %lld", topic, color, &x, &y,
                    &seen.size, &seen.stamp_ns, &seen.read_ns) >= 5) {
      colours[color].push_back(seen);
    }
  }
  return colours;
}

std::size_t count_of(const std::vector<std::string>& output, const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      output.begin(), output.end(),
      [&text](const std::string& line) { return line.find(text) != std::string::npos; }));
}

bool has(const std::vector<std::string>& output, const char* text) {
  return count_of(output, text) > 0;
}

/// Whether it holds of each sample and the one before. The first of all may be any, as the suite
/// has it.
template <class Holds>
bool holds_of_neighbours(const Colour& seen, const Holds& holds) {
  for (std::size_t i = 2; i < seen.size(); ++i) {
    if (!holds(seen[i - 1], seen[i])) return false;
  }
  return true;
}

bool steps(const Colour& seen, int least, int most) {
  return holds_of_neighbours(seen, [&](const Seen& before, const Seen& next) {
    return next.size >= before.size + least && next.size <= before.size + most;
  });
}

bool are_separated(const Colour& seen, int separation_ms) {
  const auto apart = [=](const Seen& before, const Seen& next) {
    return next.stamp_ns - before.stamp_ns >= separation_ms * ns_in_ms;
  };
  return holds_of_neighbours(seen, apart) && !steps(seen, 1, 1);
}

/// A reader that is late takes what is older, once in a while much older; without a lifespan a
/// quarter of what it reads is half as old again.
bool have_expired_in_time(const Colour& seen, int lifespan_ms) {
  constexpr std::size_t one_in = 10;
  std::size_t late = 0;
  bool in_a_row = false;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    late += seen[i].read_ns - seen[i].stamp_ns > lifespan_ms * ns_in_ms * 3 / 2 ? 1 : 0;
    in_a_row = in_a_row || (i > 0 && seen[i].size == seen[i - 1].size + 1);
  }
  return late <= seen.size() / one_in && in_a_row && steps(seen, 1, any) && !steps(seen, 1, 1);
}

/// A late reader loses what its history has no place for.
bool newest_are_kept(const Colour& seen, std::ptrdiff_t depth) {
  std::map<long long, std::ptrdiff_t> read;
  for (const Seen& one : seen) ++read[one.read_ns];
  return holds_of_neighbours(seen, [&](const Seen& before, const Seen& next) {
    return next.size == before.size + 1 || (next.size > before.size && read[next.read_ns] >= depth);
  });
}

template <class Holds>
Code ok_if_all(const Colours& colours, const Holds& holds) {
  return std::all_of(colours.begin(), colours.end(),
                     [&holds](const auto& one) { return holds(one.second); })
             ? Code::ok
             : Code::data_not_correct;
}

Code one_or_both(std::size_t count) {
  return count == 1 ? Code::receiving_from_one : Code::receiving_from_both;
}

/// From the largest on: before the stronger writer is known, samples of the weaker one may pass.
std::size_t different_sizes(const Colours& colours) {
  std::set<int> sizes;
  for (const auto& [color, seen] : colours) {
    const auto by_size = [](const Seen& a, const Seen& b) { return a.size < b.size; };
    for (auto one = std::max_element(seen.begin(), seen.end(), by_size); one != seen.end(); ++one) {
      sizes.insert(one->size);
    }
  }
  return sizes.size();
}

Code checked(const std::vector<std::string>& output, Check check, int limit) {
  const Colours sizes = colours_of(output);
  switch (check) {
    case Check::in_order:
      return ok_if_all(sizes, [](const auto& s) { return steps(s, 1, any); });
    case Check::no_losses:
      return ok_if_all(sizes, [](const auto& s) { return steps(s, 1, 1); });
    case Check::separated:
      return ok_if_all(sizes, [=](const auto& s) { return are_separated(s, limit); });
    case Check::short_lived:
      return ok_if_all(sizes, [=](const auto& s) { return have_expired_in_time(s, limit); });
    case Check::newest_kept:
      return ok_if_all(sizes, [=](const auto& s) { return newest_are_kept(s, limit); });
    case Check::at_most_20:
      return ok_if_all(sizes, [](const auto& s) {
        return std::all_of(s.begin(), s.end(), [](const Seen& one) { return one.size <= 20; });
      });
    case Check::first_kept:
      return ok_if_all(sizes, [](const auto& s) { return s.front().size == 1; });
    case Check::first_gone:
      return ok_if_all(sizes, [](const auto& s) { return s.front().size > 1; });
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
    case Check::separated:
      return 4;
    case Check::short_lived:
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

Code code_of_subscriber(const std::vector<std::string>& output, Check check, int limit) {
  if (has(output, "not supported")) return Code::unsupported;
  if (!has(output, "Create reader for topic")) return Code::not_created;
  if (has(output, "on_requested_incompatible_qos")) return Code::incompatible_qos;
  if (check == Check::deadline && has(output, "on_requested_deadline_missed")) {
    return Code::deadline_missed;
  }
  if (colours_of(output).empty()) return Code::data_not_received;
  return checked(output, check, limit);
}

bool is_enough(const std::vector<std::string>& output, Check check) {
  if (has(output, "incompatible_qos") || has(output, "not supported")) return true;
  if (check == Check::deadline) return has(output, "deadline_missed");
  if (check == Check::no_writers) return count_of(output, "NO_WRITERS") >= 4;
  if (check == Check::disposed) return count_of(output, "NOT_ALIVE") >= 4;
  const Colours sizes = colours_of(output);
  return !sizes.empty() && std::all_of(sizes.begin(), sizes.end(), [check](const auto& one) {
    return one.second.size() >= wanted(check);
  });
}

}  // namespace tocsin::interop
