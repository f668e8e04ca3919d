// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "foundation/stop_value.hpp"
#include "foundation/time.hpp"
#include "keystore/signature.hpp"

namespace tocsin {

/// In host byte order; zero for what is no IPv4 address.
[[nodiscard]] std::vector<std::uint32_t> ipv4_addresses(const std::vector<std::string>& texts);

/// The emergency stop's way over the link: a submessage of a kind that RTPS leaves to vendors, last
/// in the packets of a router's participant, or alone behind a header. On a secured link it is
/// signed with the identity's key, and the certificate follows in packets of its own.
///
/// Between the router's decision (say, take_news), its sending socket and its receptions. Any
/// thread; values and `now` only, no socket and no clock.
class StopChannel {
 public:
  using Bytes = std::vector<std::uint8_t>;
  struct Options {
    std::vector<std::uint32_t> peers;  ///< IPv4 of those who are listened to and told, host order
    std::string enclave;               ///< folder of the identity; empty: nothing is signed
    std::size_t packet_bytes;          ///< a packet with it is not larger
    std::function<void()> on_news = [] {};  ///< something else than before was received
  };
  /// Throws ConfigError when the identity cannot be read.
  explicit StopChannel(Options options);

  /// What the packets say from now on, for stop_value_lives. Calls what `on_say` has set when it is
  /// something else than before.
  void say(const StopValue& value, Time now);
  void on_say(std::function<void()> wake);

  /// The submessage for a packet of `size` bytes to a peer, of which it is then taken to be sent;
  /// null: there is no fresh value, no room, or the packet goes to no peer.
  [[nodiscard]] std::shared_ptr<const Bytes> ride(std::uint32_t to, std::size_t size, Time now);
  /// Messages without header that are due at `now` for a peer of their own; then it is asked again
  /// at `deadline`.
  [[nodiscard]] std::vector<Bytes> due(std::uint32_t to, Time now);
  [[nodiscard]] Time deadline() const;
  [[nodiscard]] const std::vector<std::uint32_t>& peers() const { return options_.peers; }

  /// Takes what is its own off a packet that has come from an address. The packet's size without
  /// it; zero when nothing is left but the header.
  [[nodiscard]] std::size_t take(const std::uint8_t* packet, std::size_t size, std::uint32_t from,
                                 Time now, std::int64_t wall_s);
  [[nodiscard]] StopNews take_news();

 private:
  struct Told {
    Time last{};  ///< when a packet took the value to it
    Time certificate{};
    std::uint64_t router = 0;  ///< of which a packet came last
    int certificates = 0;      ///< so many follow each other fast: it has restarted
    int burst = 0;             ///< so many packets of its own follow at once
    Time next{};
  };
  struct Seal {
    keystore::Signer signer;
    keystore::SignatureCheck check;
    Bytes certificate;  ///< the submessage
  };
  [[nodiscard]] bool is_fresh(Time now) const { return now - said_ < stop_value_lives; }
  [[nodiscard]] Bytes sealed(const StopValue& value) const;
  void receive(const std::uint8_t* content, std::size_t size, std::uint64_t router, Time now);
  [[nodiscard]] std::optional<std::string> identity_in(const std::uint8_t* content,
                                                       std::size_t value_bytes,
                                                       std::size_t size) const;
  void learn(const std::uint8_t* content, std::size_t size, std::int64_t wall_s);
  void keep(ReceivedStop received);
  [[nodiscard]] bool is_news(const ReceivedStop& received);
  void note_packet(std::uint64_t router, Time now);
  [[nodiscard]] bool knows_peer(std::uint32_t address) const;

  const Options options_;
  mutable std::mutex mutex_;
  std::optional<Seal> seal_;
  std::function<void()> wake_ = [] {};
  std::optional<StopValue> value_;  ///< as it was said last
  std::shared_ptr<const Bytes> submessage_;
  Time said_{};
  std::map<std::uint32_t, Told> told_;
  StopNews news_;
  std::map<std::uint64_t, StopValue> last_;  ///< by router: what was received before
  bool has_news_ = false;
};

}  // namespace tocsin
