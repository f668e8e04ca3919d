// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "radio_link.hpp"
#include "runtime/middleware/gated_writer.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::simulation {

/// Sizes of what RTPS 2.2 puts around data, in bytes (DDSI-RTPS 2.2, 9.4). Checked against captured
/// packets of Debian's Fast DDS 2.9.1: a full fragment is an IP packet of 1396 bytes with 1224 of
/// the sample, an ACKNACK without bits one of 152, a HEARTBEAT one of 140.
namespace wire {
inline constexpr std::size_t ip_and_udp = 28;
inline constexpr std::size_t message_header = 20;
inline constexpr std::size_t info_destination = 16;  ///< before fragments, ACKNACK and GAP only
inline constexpr std::size_t info_timestamp = 12;
inline constexpr std::size_t data_header = 24;
inline constexpr std::size_t data_fragment_header = 36;
/// Ends every message: the vendor's submessage 0x80, since Debian builds with statistics.
inline constexpr std::size_t statistics = 60;
inline constexpr std::size_t heartbeat = 32;
inline constexpr std::size_t acknack = 28;
inline constexpr std::size_t gap = 32;
inline constexpr std::size_t longest_message = 1400;  ///< as FastDdsParticipant sets it
/// IP packets that carry a sample of `bytes`, in order.
[[nodiscard]] std::vector<std::size_t> packets_of(std::size_t bytes);
}  // namespace wire

/// A sample in the history of a writer.
struct Change {
  std::uint64_t sequence;
  Time sent;
  std::shared_ptr<const void> message;  ///< shared by all readers, never changed
  std::size_t bytes = 0;                ///< serialised
  const TopicEnd* from = nullptr;
  std::uint64_t written = 0;  ///< as in Written::sequence
  Time written_at{};
  std::int64_t sent_wall_ns = 0;  ///< by the writer's clock
};

/// A write that is going on or that the gate may still let through, so that its sample is known
/// again when it is sent.
struct Origin {
  std::shared_ptr<const void> message;
  std::uint64_t sequence = 0;
  Time time{};
};

/// The reading end of a link topic in one process. Gives the samples of each writer in order and
/// each once; a reliable one waits for those that can still come.
class RtpsReader {
 public:
  using Deliver = std::function<void(const Change& change, std::uint64_t source)>;
  RtpsReader(const QosProfile& qos, Deliver deliver) : qos_(qos), deliver_(std::move(deliver)) {}

  /// A new writer, of whose samples those from `first` on are wanted.
  void match(std::uint64_t source, std::uint64_t first) { sources_[source].next = first; }
  void on_data(std::uint64_t source, const Change& change, Time now);
  /// What is still missing of `first` to `last`; older samples are gone for good.
  [[nodiscard]] std::vector<std::uint64_t> on_heartbeat(std::uint64_t source, std::uint64_t first,
                                                        std::uint64_t last, Time now);
  /// The sample will never come.
  void on_gap(std::uint64_t source, std::uint64_t sequence, Time now);
  [[nodiscard]] const QosProfile& qos() const { return qos_; }
  /// Its process has died: packets under way find nobody.
  void die() { alive_ = false; }
  [[nodiscard]] bool alive() const { return alive_; }

 private:
  struct Source {
    std::uint64_t next = 1;
    std::map<std::uint64_t, Change> early;  ///< without `message`: a gap
  };
  void release(std::uint64_t id, Source& source, Time now);
  void give(std::uint64_t id, const Change& change, Time now);
  QosProfile qos_;
  bool alive_ = true;
  Deliver deliver_;
  std::map<std::uint64_t, Source> sources_;
};

/// The writing end of a link topic in one process, with KEEP_LAST history and, when reliable,
/// repair by heartbeats and negative acknowledgements; all of it costs packets. One copy of a
/// sample goes to each reading process, since the link is unicast.
class RtpsWriter final : public LinkWriter {
 public:
  /// Whose writer it is.
  struct Owner {
    radio::Direction direction;
    std::uint64_t source;
    const TopicEnd* end;
    const Origin* origin;
    std::function<std::int64_t(Time)> wall_ns = Core::wall_ns;  ///< of its host
  };
  RtpsWriter(Core& core, RadioLink& link, const Owner& owner, const QosProfile& qos);

  /// A transient local writer sends its history to a late reader. Both live as long as the core.
  void match(RtpsReader& reader);
  std::size_t send(const void* message) override;
  void silence() override { history_.clear(); }
  /// Its process has died: what is on the air may still arrive.
  void die() {
    alive_ = false;
    history_.clear();
  }
  [[nodiscard]] bool alive() const { return alive_; }
  [[nodiscard]] std::uint64_t source() const { return owner_.source; }
  [[nodiscard]] WriterInfo info() const {
    return {owner_.end->host + "_" + owner_.end->process, owner_.end->user_data};
  }

 private:
  struct Proxy {
    RtpsReader* reader;
    std::uint64_t acknowledged;  ///< this one and all before
  };
  void transmit(RtpsReader& reader, const Change& change);
  void forget_expired();
  void ask_for_heartbeat();
  void heartbeat();
  void send_heartbeat(Proxy& proxy);
  void on_acknack(Proxy& proxy, std::uint64_t last, const std::vector<std::uint64_t>& missing);
  void repair(RtpsReader& reader, std::uint64_t sequence);
  [[nodiscard]] const Change* find(std::uint64_t sequence) const;

  Core& core_;
  RadioLink& link_;
  Owner owner_;
  QosProfile qos_;
  std::uint64_t sent_ = 0;
  std::deque<Change> history_;
  std::deque<Proxy> proxies_;  ///< a deque: packets under way refer to its elements
  bool heartbeat_asked_ = false;
  bool alive_ = true;
};

}  // namespace tocsin::simulation
