// SPDX-License-Identifier: Apache-2.0
// interop_peer MAKER DOMAIN NAME: writes "NAME INSTANT NUMBER" twenty times a second, until its
// input ends, and prints each that it hears, with the instant of that. Instants are milliseconds
// of the clock that all processes of a computer share, numbers rise by one.
// $INTEROP_LIFESPAN_MS: lifespan of what it writes.
#include <poll.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <thread>

#include "peer.hpp"

long long tocsin::interop::now_ms() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::milliseconds(1);
}

namespace {

using namespace tocsin::interop;
using Clock = std::chrono::steady_clock;

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
      for (const HeardText& heard : peer.take()) {
        std::cout << heard.text << ' ' << heard.at_ms << '\n';
      }
      std::cout.flush();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    } while (Clock::now() < next + period);
  }
}

}  // namespace

int main(int count, char** words) {
  const std::map<std::string, std::unique_ptr<Peer> (*)(const PeerSettings&)> makers{
      {"cyclone", make_cyclone_peer},
      {"fast_dds", make_fast_dds_peer},
      {"tocsin", make_tocsin_peer}};
  const char* const lifespan = std::getenv("INTEROP_LIFESPAN_MS");
  if (count != 4 || makers.count(words[1]) == 0) return 2;
  try {
    const PeerSettings settings{std::stoi(words[2]), lifespan == nullptr ? 0 : std::atoi(lifespan)};
    run(*makers.at(words[1])(settings), words[3]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
