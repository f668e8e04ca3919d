// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "alarm.hpp"
#include "best_effort.hpp"
#include "pacer.hpp"
#include "rtps.hpp"
#include "rtps_model/reliable_reader.hpp"
#include "rtps_model/reliable_writer.hpp"

namespace tocsin::simulation {

/// rtps::ReliableWriter on the radio. When a history of keep_all is full, a sample waits for room
/// as long as a component's write would block; its component does not, and others are refused
/// meanwhile. Readers that are best effort get each sample once, past the flow controller.
class ReliableWriter final : public RtpsWriter,
                             public PacedWriter,
                             private rtps::Sender,
                             private rtps::SampleQueue {
 public:
  ReliableWriter(Core& core, RadioLink& link, const Owner& owner, const QosProfile& qos,
                 Pacer* pacer);
  using RtpsWriter::send;
  void match(RtpsReader& reader) override;
  void unmatch(const RtpsReader& reader) override;
  void on_answer(rtps::EndId reader, const rtps::Message& message) override;
  void silence() override;
  void die() override;
  bool deliver(rtps::Sequence sequence, rtps::ByteBudget& budget) override;
  void end_turn() override { group_.reset(); }

 private:
  [[nodiscard]] std::uint64_t next_sequence() const override { return model_.next_sequence(); }
  bool publish(Change&& change) override;
  void send(rtps::EndId to, const rtps::MessagePtr& message) override;
  void add(rtps::Sequence sequence, bool resent) override;
  void remove(rtps::Sequence sequence) override { pacer_->remove(number_, sequence); }
  void write(Change&& change);
  void write_waiting();
  void update();

  Pacer* pacer_;
  std::size_t number_ = 0;  ///< at the pacer
  std::size_t fragment_bytes_;
  Duration max_blocking_;
  rtps::ReliableWriter model_;
  std::map<rtps::EndId, RtpsReader*> readers_;
  std::vector<RtpsReader*> unacknowledging_;  ///< the best-effort ones
  rtps::EndId last_reader_ = 0;
  std::optional<rtps::MessageGroup> group_;  ///< during a turn of the pacer
  std::optional<Change> waiting_;
  std::uint64_t waited_ = 0;  ///< how many have
  Alarm alarm_;
};

/// rtps::ReliableReader on the radio.
class ReliableReader final : public RtpsReader, private rtps::Sender {
 public:
  ReliableReader(Core& core, RadioLink& link, const QosProfile& qos, Deliver deliver);
  void match(RtpsWriter& writer, rtps::EndId number) override;
  void unmatch(std::uint64_t source) override;
  [[nodiscard]] bool reliable() const override { return true; }
  void on_sample(std::uint64_t, const Change&) override {}
  void on_message(std::uint64_t source, const rtps::Message& message) override;
  void die() override;

 private:
  void send(rtps::EndId to, const rtps::MessagePtr& message) override;
  struct Writer {
    RtpsWriter* writer;
    rtps::EndId number;  ///< of this reader there
  };
  RadioLink& link_;
  rtps::ReliableReader model_;
  std::map<std::uint64_t, Writer> writers_;
  Alarm alarm_;
};

}  // namespace tocsin::simulation
