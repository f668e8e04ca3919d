// SPDX-License-Identifier: Apache-2.0
// Tries to get onto a secured link beside a vehicle and a station that may be there, by real UDP
// in a network of its own: one participant after the other, each a process.
// usage: strangers [TRIES [MILLISECONDS [MAKER [ROW]]]]
// ROW: a word of the rows wanted, such as revoked.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "strangers.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::interop;
using std::chrono::milliseconds;

constexpr int tries_between = 100;

struct Row {
  std::string name;
  std::string maker;
  std::string enclave;
  int tries = 0;
};

void print(const Row& row, const Reached& all, std::vector<double> joins) {
  std::sort(joins.begin(), joins.end());
  fmt::print("{:<40} {:5} tries: joined {}, samples written {}, read {}, disturbed {}, failed {}; ",
             row.name, row.tries, all.joined, all.commanded, all.read, all.disturbed, all.failed);
  fmt::print("heard after {:.0f} ms at most; the right one joins in {:.0f} ms, at most {:.0f}\n",
             all.heard_ms, joins[joins.size() / 2], joins.back());
  std::fflush(stdout);
}

void campaign(Link& link, const Row& row, milliseconds time) {
  Reached all;
  std::vector<double> joins{link.rejoin()};
  for (int i = 1; i <= row.tries; ++i) {
    const Role role = i % 2 == 0 ? Role::uxv : Role::gcs;
    all += link.attempt({row.maker, role, row.enclave, time});
    if (i % tries_between == 0) joins.push_back(link.rejoin());
  }
  print(row, all, joins);
}

void try_all(int tries, milliseconds time, const std::string& maker, const std::string& row) {
  const Identities identities;
  constexpr int few = 5;  // that this program sees who gets in
  const auto wanted = [&](const std::string& one) { return maker.empty() || maker == one; };
  for (const char* const one : {"fast_dds", "cyclone"}) {
    if (!wanted(one)) continue;
    Link plain(nullptr);
    campaign(plain, {"on a plain link: " + std::string(one), one, "", few}, time);
  }
  Link link(&identities);
  for (const char* const one : {"fast_dds", "cyclone"}) {
    if (!wanted(one)) continue;
    const std::string name = one;
    campaign(link, {name + ", the right identity", one, identities.good("rover"), few}, time);
    for (const Row& each : {Row{name + ", no identity", one, "", tries},
                            {name + ", another authority's", one, identities.other("rover"), tries},
                            {name + ", revoked", one, identities.revoked(), tries}}) {
      if (each.name.find(row) != std::string::npos) campaign(link, each, time);
    }
  }
}

int run(const std::vector<std::string>& words) {
  if (!words.empty() && words[0] == "live") return tell(words);
  if (!enter_own_network()) throw EnvironmentError("needs the right to make a network namespace");
  try_all(words.empty() ? 1000 : std::stoi(words[0]),
          milliseconds(words.size() > 1 ? std::stoi(words[1]) : 300),
          words.size() > 2 ? words[2] : "", words.size() > 3 ? words[3] : "");
  return 0;
}

}  // namespace

int main(int count, char** words) {
  return run_program("strangers", [&] { return run({words + 1, words + count}); });
}
