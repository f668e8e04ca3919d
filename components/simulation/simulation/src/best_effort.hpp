// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "pacer.hpp"
#include "rtps.hpp"

namespace tocsin::simulation {

class SampleOnAir;

/// Puts the sample on the radio once, for readers that ask for nothing again.
void send_once(RadioLink& link, const RtpsWriter::Owner& owner,
               const std::vector<RtpsReader*>& readers, const std::shared_ptr<const Change>& change,
               std::size_t fragment_bytes);

/// Sends each sample once; with a flow controller, piece by piece as the periods allow, the newest
/// samples of its depth only.
class BestEffortWriter final : public RtpsWriter, public PacedWriter {
 public:
  BestEffortWriter(Core& core, RadioLink& link, const Owner& owner, const QosProfile& qos,
                   Pacer* pacer);
  void match(RtpsReader& reader) override;
  void unmatch(const RtpsReader& reader) override;
  void on_answer(rtps::EndId, const rtps::Message&) override {}
  void silence() override;
  bool deliver(rtps::Sequence sequence, rtps::ByteBudget& budget) override;
  void end_turn() override {}

 private:
  /// A sample that waits for the flow controller.
  struct Waiting {
    std::shared_ptr<const Change> change;
    std::size_t next_piece = 0;
    std::vector<std::shared_ptr<SampleOnAir>> on_air;  ///< of each reader, once it has begun
  };
  [[nodiscard]] std::uint64_t next_sequence() const override { return sent_ + 1; }
  bool publish(Change&& change) override;
  void make_room();

  Pacer* pacer_;
  std::size_t number_ = 0;  ///< at the pacer
  std::size_t depth_;
  Duration lifespan_;
  std::size_t fragment_bytes_;
  std::uint64_t sent_ = 0;
  std::vector<RtpsReader*> readers_;
  std::map<rtps::Sequence, Waiting> waiting_;
};

/// Gives what comes, except what is older than that.
class BestEffortReader final : public RtpsReader {
 public:
  BestEffortReader(Core& core, const QosProfile& qos, Deliver deliver)
      : RtpsReader(core, qos, std::move(deliver)) {}
  [[nodiscard]] bool reliable() const override { return false; }
  void match(RtpsWriter& writer, rtps::EndId) override { writers_.push_back(&writer); }
  void unmatch(std::uint64_t) override {}
  void on_sample(std::uint64_t source, const Change& change) override;
  void on_message(std::uint64_t, const rtps::Message&) override {}
  void die() override;

 private:
  std::vector<RtpsWriter*> writers_;
  std::map<std::uint64_t, std::uint64_t> last_;  ///< of each writer
};

}  // namespace tocsin::simulation
