// SPDX-License-Identifier: Apache-2.0
#include "command_line/stop_signal.hpp"

#include <algorithm>
#include <csignal>
#include <thread>

namespace tocsin {
namespace {

volatile std::sig_atomic_t stopped = 0;

}  // namespace

void catch_stop_signals() {
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, [](int) { stopped = 1; });
}

bool is_stopped() { return stopped != 0; }

void sleep_until_stopped(Time due) {
  constexpr Duration look = std::chrono::milliseconds(50);  // a signal wakes nobody
  for (Time now = std::chrono::steady_clock::now(); now < due && !is_stopped();
       now = std::chrono::steady_clock::now()) {
    std::this_thread::sleep_for(std::min(look, due - now));
  }
}

}  // namespace tocsin
