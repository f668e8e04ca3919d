// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "radio_link.hpp"
#include "rtps_model/message.hpp"
#include "runtime/middleware/gated_writer.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::simulation {

class Pacer;
class RtpsReader;

/// A sample on its way from a writer to readers on other hosts.
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

/// The writing end of a link topic in one process. One copy of a sample goes to each reading
/// process, since the link is unicast.
class RtpsWriter : public LinkWriter {
 public:
  /// Whose writer it is.
  struct Owner {
    Way way;  ///< of its packets; what readers answer goes back with the same DSCP
    std::uint64_t source;
    const TopicEnd* end;
    const Origin* origin;
    std::function<std::int64_t(Time)> wall_ns = Core::wall_ns;  ///< of its host
  };
  /// Reliable or best effort, as the profile says; `pacer` is the flow controller that it names, or
  /// null. Lives as long as the core.
  [[nodiscard]] static std::unique_ptr<RtpsWriter> make(Core& core, RadioLink& link,
                                                        const Owner& owner, const QosProfile& qos,
                                                        Pacer* pacer);

  /// The reader lives as long as the core.
  virtual void match(RtpsReader& reader) = 0;
  /// The reader's process has died.
  virtual void unmatch(const RtpsReader& reader) = 0;
  /// What one of its readers says.
  virtual void on_answer(rtps::EndId reader, const rtps::Message& message) = 0;
  std::size_t send(const void* message) final;
  /// Its process has died: what is on the air may still arrive.
  virtual void die() {
    silence();
    alive_ = false;
  }
  [[nodiscard]] bool alive() const { return alive_; }
  [[nodiscard]] const Owner& owner() const { return owner_; }
  [[nodiscard]] WriterInfo info() const {
    return {owner_.end->host + "_" + owner_.end->process, owner_.end->user_data};
  }

 protected:
  RtpsWriter(Core& core, RadioLink& link, const Owner& owner)
      : core_(core), link_(link), owner_(owner) {}
  /// The number of the next sample that is sent.
  [[nodiscard]] virtual std::uint64_t next_sequence() const = 0;
  /// False when there is no room for it.
  virtual bool publish(Change&& change) = 0;
  void tell_observer(const Change& change) const;
  Core& core_;
  RadioLink& link_;

 private:
  Owner owner_;
  bool alive_ = true;
};

/// The reading end of a link topic in one process. Gives the samples of each writer in order and
/// each once; none later than its lifespan.
class RtpsReader {
 public:
  using Deliver = std::function<void(const Change& change, std::uint64_t source)>;
  /// Lives as long as the core.
  [[nodiscard]] static std::unique_ptr<RtpsReader> make(Core& core, RadioLink& link,
                                                        const QosProfile& qos, Deliver deliver);
  virtual ~RtpsReader() = default;

  /// Asks for what it misses.
  [[nodiscard]] virtual bool reliable() const = 0;
  /// A new writer, which knows this reader by `number`.
  virtual void match(RtpsWriter& writer, rtps::EndId number) = 0;
  /// The writer is known no more.
  virtual void unmatch(std::uint64_t source) = 0;
  /// A whole sample of a best-effort writer.
  virtual void on_sample(std::uint64_t source, const Change& change) = 0;
  /// A message of a reliable writer.
  virtual void on_message(std::uint64_t source, const rtps::Message& message) = 0;
  /// Its process has died: packets under way find nobody.
  virtual void die() { alive_ = false; }
  [[nodiscard]] bool alive() const { return alive_; }

 protected:
  RtpsReader(Core& core, const QosProfile& qos, Deliver deliver)
      : core_(core), lifespan_(seconds(qos.lifespan_s)), deliver_(std::move(deliver)) {}
  void give(std::uint64_t source, const Change& change) const {
    if (core_.now - change.sent <= lifespan_) deliver_(change, source);
  }
  Core& core_;

 private:
  Duration lifespan_;
  Deliver deliver_;
  bool alive_ = true;
};

}  // namespace tocsin::simulation
