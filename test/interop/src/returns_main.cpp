// SPDX-License-Identifier: Apache-2.0
// How soon participants of all makers on two hosts hear each other again after the radio was dead,
// or a host's router was stopped. Prints rows of a table of the README.
// usage: returns [OUTAGE...] [-- FREEZE...]     in seconds; 10 30 120 -- 7 12 60
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "foundation/program.hpp"
#include "returns.hpp"

namespace {

using namespace tocsin::interop;

std::vector<Interruption> planned(const std::vector<std::string>& words) {
  std::vector<Interruption> all;
  bool freezes = false;
  for (const std::string& word : words) {
    if (word == "--") {
      freezes = true;
      continue;
    }
    const std::chrono::seconds time(std::stoi(word));
    if (!freezes) all.push_back({"", time});
    if (freezes) all.push_back({"uxv/link", time});
    if (freezes) all.push_back({"gcs/link", time});
  }
  return all;
}

void print(const Interruption& what, Return result) {
  fmt::print("| {} | {} | {} | {} | {}: {} |\n", to_text(what),
             result.heard_after["tocsin"].count(), result.heard_after["cyclone"].count(),
             result.heard_after["fast_dds"].count(), result.oldest.count(), result.oldest_is);
  std::fflush(stdout);
}

int run(std::vector<std::string> words) {
  if (words.empty()) words = {"10", "30", "120", "--", "7", "12", "60"};
  RoutedPeers peers;
  fmt::print(
      "| | with ours | with Cyclone DDS | with Fast DDS | oldest given |\n"
      "| --- | --- | --- | --- | --- |\n");
  for (const Interruption& what : planned(words)) print(what, peers.after(what));
  return 0;
}

}  // namespace

int main(int count, char** words) {
  return tocsin::run_program("returns", [&] { return run({words + 1, words + count}); });
}
