// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tocsin {

/// Somebody on a link, who overhears routers and speaks in their name, from their address and port.
/// Needs CAP_NET_RAW.
class Forger {
 public:
  using Packet = std::vector<std::uint8_t>;
  struct Overheard {
    std::uint16_t port = 0;  ///< from which it was sent
    Packet announcement;     ///< DATA(p) or another message, with the RTPS header
  };

  /// IPv4 addresses of the link: whose name it uses, and to whom it speaks. On loopback all have
  /// one.
  struct Way {
    std::string from = "127.0.0.1";
    std::string to = "127.0.0.1";
  };

  explicit Forger(int link_domain) : Forger(link_domain, Way()) {}
  Forger(int link_domain, const Way& way);
  ~Forger();
  Forger(const Forger&) = delete;
  Forger& operator=(const Forger&) = delete;

  /// False when the sockets could not be opened.
  [[nodiscard]] bool ok() const { return raw_ >= 0 && capture_ >= 0; }
  /// Waits up to 5 s for the announcement of the router of `host`.
  [[nodiscard]] std::optional<Overheard> overhear(const std::string& host) const;
  /// What routers of the link have sent since one looked last, with an announcement or without;
  /// waits for 0.1 s at most.
  [[nodiscard]] std::vector<Overheard> overhear_all() const;
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
  /// The message under much higher numbers of its samples, and with an end of its last sample that
  /// says the most it can: origins, counts and times are among these bytes.
  [[nodiscard]] static Packet exaggerated(const Packet& message, std::uint32_t by);

 private:
  /// Empty: none within 0.1 s.
  [[nodiscard]] std::optional<Overheard> receive() const;
  const int link_domain_;
  const std::uint32_t from_;  ///< IPv4, as on the wire
  const std::uint32_t to_;
  int raw_;
  int capture_;
  int own_;
  std::uint16_t port_ = 0;
};

}  // namespace tocsin
