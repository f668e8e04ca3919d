// SPDX-License-Identifier: Apache-2.0
#include "link/flow_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "runtime/middleware/qos_policies.hpp"

namespace tocsin {
namespace {

const std::string flow_key = "tocsinflow=";
constexpr int largest_depth = 10000;

/// What stands between the flow_key and the next semicolon.
struct Words {
  char reliability[16] = "";
  char durability[16] = "";
  int depth = 0;
  double lifespan_s = 0;
  char more[2][8] = {"", ""};  ///< of these two, in any order
};
constexpr std::string_view stored_word = "stored";
constexpr std::string_view second_word = "second";

std::optional<Words> words_in(const std::string& text) {
  Words words;
  const int found =
      std::sscanf(text.c_str(), "%15[a-z_],%15[a-z_],%d,%lf,%7[a-z],%7[a-z]", words.reliability,
                  words.durability, &words.depth, &words.lifespan_s, words.more[0], words.more[1]);
  const bool sensible =
      found >= 4 && words.depth >= 1 && words.depth <= largest_depth && words.lifespan_s > 0;
  return sensible ? std::optional(words) : std::nullopt;
}

}  // namespace

std::string announcement_of(const Flow& flow) {
  const bool separate = !flow.user_data.empty() && flow.user_data.back() != ';';
  return flow.user_data + (separate ? ";" : "") +
         fmt::format("{}{},{},{},{}{}{};", flow_key,
                     word_of(flow.reliable ? Reliability::reliable : Reliability::best_effort),
                     word_of(flow.transient_local ? Durability::transient_local
                                                  : Durability::volatile_kind),
                     flow.depth, flow.lifespan_s,
                     flow.stored ? fmt::format(",{}", stored_word) : "",
                     flow.path != 0 ? fmt::format(",{}", second_word) : "");
}

void read_announcement(Flow& flow) {
  const std::size_t at = flow.user_data.find(flow_key);
  if (at == std::string::npos) return;
  const std::size_t end = std::min(flow.user_data.find(';', at), flow.user_data.size() - 1);
  const auto words =
      words_in(flow.user_data.substr(at + flow_key.size(), end - at - flow_key.size()));
  flow.user_data.erase(at, end - at + 1);
  if (!words) return;
  flow.reliable = value_of<Reliability>(words->reliability) == Reliability::reliable;
  flow.transient_local = value_of<Durability>(words->durability) == Durability::transient_local;
  flow.depth = words->depth;
  flow.lifespan_s = words->lifespan_s;
  for (const std::string_view word : words->more) {
    if (word == stored_word) flow.stored = true;
    if (word == second_word) flow.path = 1;
  }
}

}  // namespace tocsin
