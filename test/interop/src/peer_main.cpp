// SPDX-License-Identifier: Apache-2.0
// interop_peer MAKER DOMAIN NAME: writes "NAME INSTANT NUMBER" twenty times a second, until its
// input ends, and prints each that it hears. Instants are milliseconds of the clock that all
// processes of a computer share, numbers rise by one.
#include <poll.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <map>
#include <thread>

#include "peer.hpp"

namespace {

using tocsin::interop::Peer;
using Clock = std::chrono::steady_clock;

long long now_ms() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now().time_since_epoch())
      .count();
}

bool input_has_ended() {
  pollfd input{0, 0, 0};
  return poll(&input, 1, 0) == 1 && (input.revents & POLLHUP) != 0;
}

void run(Peer& peer, const std::string& name) {
  constexpr auto period = std::chrono::milliseconds(50);
  long long number = 0;
  for (auto next = Clock::now(); !input_has_ended(); next = Clock::now() + period) {
    peer.write(name + " " + std::to_string(now_ms()) + " " + std::to_string(++number));
    do {
      for (const std::string& text : peer.take()) std::cout << text << '\n';
      std::cout.flush();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    } while (Clock::now() < next + period);
  }
}

}  // namespace

int main(int count, char** words) {
  const std::map<std::string, std::unique_ptr<Peer> (*)(int)> makers{
      {"cyclone", tocsin::interop::make_cyclone_peer},
      {"fast_dds", tocsin::interop::make_fast_dds_peer},
      {"tocsin", tocsin::interop::make_tocsin_peer}};
  if (count != 4 || makers.count(words[1]) == 0) return 2;
  try {
    run(*makers.at(words[1])(std::stoi(words[2])), words[3]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
