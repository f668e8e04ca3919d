// SPDX-License-Identifier: Apache-2.0
// Participants of all makers on both hosts of a running stack, and how soon they hear each other
// again after the radio was dead or a router was stopped.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "foundation/temporary_folder.hpp"
#include "peer_process.hpp"
#include "stack.hpp"

namespace tocsin::interop {

/// What comes between the hosts for a while.
struct Interruption {
  std::string process;  ///< of the launch, that is stopped (SIGSTOP); empty: the radio is dead
  std::chrono::seconds time{};
};
/// "outage of 10 s", "gcs/link stopped for 7 s".
[[nodiscard]] std::string to_text(const Interruption& interruption);

/// What came of one.
struct Return {
  /// Until the last pair of participants on different hosts, of which one is of that maker, heard
  /// a sample that was written after the return; both ways. By maker.
  std::map<std::string, std::chrono::milliseconds> heard_after;
  std::chrono::milliseconds longest{};
  std::chrono::milliseconds oldest{};  ///< age of the oldest sample that crossed since
  std::string oldest_is;               ///< "READER of WRITER"
};

/// The mission's processes over the emulated radio, the vehicle standing in good reception, and on
/// each host one participant of each maker. All six write one topic of class critical, ten
/// samples a second, each worthless after `lifespan`.
class RoutedPeers {
 public:
  static constexpr std::chrono::milliseconds lifespan{500};
  /// Waits until all hear all of the other host. Throws std::runtime_error when they do not.
  RoutedPeers();
  /// Returns when all hear all again. Throws std::runtime_error when they do not within a minute,
  /// or when samples crossed meanwhile.
  [[nodiscard]] Return after(const Interruption& interruption);

 private:
  using Time = std::chrono::steady_clock::time_point;
  struct Pair {
    const PeerProcess& reader;
    const PeerProcess& writer;
    std::string makers;  ///< of both
  };
  [[nodiscard]] std::vector<Pair> pairs() const;
  /// Who does not hear whom, a line each.
  [[nodiscard]] std::string unheard(Time since) const;
  /// Throws what the launch said when it does not become true.
  void wait_until(std::chrono::seconds limit, const std::function<bool()>& condition) const;
  /// Begins it and waits until it is over.
  Time interrupt(const Interruption& interruption) const;

  TemporaryFolder folder_;
  Stack stack_;
  std::vector<std::unique_ptr<PeerProcess>> vehicle_;
  std::vector<std::unique_ptr<PeerProcess>> station_;
};

}  // namespace tocsin::interop
