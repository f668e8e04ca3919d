// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "foundation/role.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::interop {

/// Who tries to get onto a link: a participant of `fast_dds`, which is a router of ours as vehicle
/// or as station, or of `cyclone`, which is both at once, for a while, in a process of its own.
struct Stranger {
  std::string maker;
  Role role = Role::uxv;
  std::string enclave;  ///< folder of its identity; empty: none
  std::chrono::milliseconds time{};
};

/// The process that `Link::attempt` starts, by its arguments: lives as a stranger and prints how
/// many samples of others it has read. Returns its exit code; throws ConfigError.
[[nodiscard]] int tell(const std::vector<std::string>& words);

/// Keystores: the good one with `uxv`, `gcs` and `rover`, which may do all; another authority's;
/// and a copy of an identity of the good one from before it was revoked.
class Identities {
 public:
  Identities();
  [[nodiscard]] std::string good(const std::string& name) const;
  [[nodiscard]] std::string other(const std::string& name) const;
  [[nodiscard]] std::string revoked() const;

 private:
  void make(const std::string& name) const;
  [[nodiscard]] std::string store(const std::string& name) const { return folder_.path(name); }
  const TemporaryFolder folder_;
};

/// What a stranger has reached in one try or in many.
struct Reached {
  int joined = 0;        ///< the vehicle or the station took it for a peer, or saw a flow of it
  int commanded = 0;     ///< samples of it that they got
  std::size_t read = 0;  ///< samples of theirs that it got
  int disturbed = 0;     ///< tries in which the station got less than half of the vehicle's
  int failed = 0;        ///< tries whose process could not even be
  double heard_ms = 0;  ///< longest from the start of its process to its first sample that they got
  [[nodiscard]] bool nothing() const { return joined + commanded + disturbed == 0 && read == 0; }
  Reached& operator+=(const Reached& more);
};

/// Gives this process a network of its own, which has a loopback.
/// False without the right to. While there is one thread only.
[[nodiscard]] bool enter_own_network();

/// A vehicle and a station that may be on the link, each with a process that writes all the time.
class Link {
 public:
  /// `identities`: of a secured link; null: of a plain one.
  explicit Link(const Identities* identities);
  ~Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// One try of a stranger, in a process of its own that leaves nothing behind.
  [[nodiscard]] Reached attempt(const Stranger& stranger);
  /// The vehicle's router starts anew: how long until the station gets the first sample of it [ms].
  [[nodiscard]] double rejoin();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tocsin::interop
