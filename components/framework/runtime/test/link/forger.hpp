// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tocsin {

/// Somebody beside a link on loopback, who overhears routers and speaks in their name, from their
/// address and port. Needs CAP_NET_RAW.
class Forger {
 public:
  using Packet = std::vector<std::uint8_t>;
  struct Overheard {
    std::uint16_t port = 0;  ///< from which it was sent
    Packet announcement;     ///< DATA(p), with the RTPS header
  };

  explicit Forger(int link_domain);
  ~Forger();
  Forger(const Forger&) = delete;
  Forger& operator=(const Forger&) = delete;

  /// False when the sockets could not be opened.
  [[nodiscard]] bool ok() const { return raw_ >= 0 && capture_ >= 0; }
  /// Waits up to 5 s for the announcement of the router of `host`.
  [[nodiscard]] std::optional<Overheard> overhear(const std::string& host) const;
  /// Its own port on loopback: of a socket that is there.
  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// To all who are on the link, as if `from` had sent it.
  void send(const Packet& packet, std::uint16_t from) const;

  /// Says that the participant leaves.
  [[nodiscard]] static Packet departure_of(const Overheard& victim);
  /// The announcement with another lease [s], and a number that is not ignored.
  [[nodiscard]] static Packet with_lease(const Overheard& victim, std::uint32_t lease_s);
  /// The announcement of a stranger that never ends; `number` makes its GUID.
  [[nodiscard]] static Packet stranger_like(const Overheard& victim, std::uint32_t number);

 private:
  const int link_domain_;
  int raw_;
  int capture_;
  int own_;
  std::uint16_t port_ = 0;
};

}  // namespace tocsin
