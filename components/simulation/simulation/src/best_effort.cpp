// SPDX-License-Identifier: Apache-2.0
#include "best_effort.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::simulation {

/// A sample on its way to one reader, which gets it when all its packets have come.
class SampleOnAir final : public Cargo {
 public:
  SampleOnAir(std::uint64_t source, RtpsReader& reader, std::shared_ptr<const Change> change,
              std::size_t packets)
      : source_(source),
        reader_(reader),
        change_(std::move(change)),
        missing_(packets, true),
        left_(packets) {}
  void arrive(std::size_t packet) override {
    if (!missing_[packet]) return;
    missing_[packet] = false;
    if (--left_ == 0) reader_.on_sample(source_, *change_);
  }
  [[nodiscard]] bool waits_after(std::size_t packet) const override {
    return left_ > 1 || !missing_[packet];
  }

 private:
  std::uint64_t source_;
  RtpsReader& reader_;
  std::shared_ptr<const Change> change_;
  std::vector<bool> missing_;
  std::size_t left_;
};

namespace {

using SamplesOnAir = std::vector<std::shared_ptr<SampleOnAir>>;

SamplesOnAir begin(const RtpsWriter::Owner& owner, const std::vector<RtpsReader*>& readers,
                   const std::shared_ptr<const Change>& change, std::size_t pieces) {
  SamplesOnAir all;
  all.reserve(readers.size());
  for (RtpsReader* reader : readers) {
    all.push_back(std::make_shared<SampleOnAir>(owner.source, *reader, change, pieces));
  }
  return all;
}

}  // namespace

void send_once(RadioLink& link, const RtpsWriter::Owner& owner,
               const std::vector<RtpsReader*>& readers, const std::shared_ptr<const Change>& change,
               std::size_t fragment_bytes) {
  if (readers.empty()) return;
  const auto packets = rtps::packets_of(change->bytes, readers.size(), fragment_bytes);
  const SamplesOnAir on_air = begin(owner, readers, change, packets.size());
  for (std::size_t i = 0; i < packets.size(); ++i) {
    for (const auto& sample : on_air) link.send(owner.way, packets[i], sample, i);
  }
}

BestEffortWriter::BestEffortWriter(Core& core, RadioLink& link, const Owner& owner,
                                   const QosProfile& qos, Pacer* pacer)
    : RtpsWriter(core, link, owner),
      pacer_(pacer),
      depth_(static_cast<std::size_t>(qos.keeps_all() ? qos.room() : qos.depth)),
      lifespan_(seconds(qos.lifespan_s)),
      fragment_bytes_(pacer == nullptr ? rtps::wire::largest_payload : pacer->fragment_bytes()) {
  if (pacer_ != nullptr) number_ = pacer_->add(*this, qos);
}

void BestEffortWriter::match(RtpsReader& reader) {
  readers_.push_back(&reader);
  reader.match(*this, readers_.size());
}

void BestEffortWriter::unmatch(const RtpsReader& reader) {
  readers_.erase(std::remove(readers_.begin(), readers_.end(), &reader), readers_.end());
}

bool BestEffortWriter::publish(Change&& made) {
  const auto change = std::make_shared<const Change>(std::move(made));
  ++sent_;
  tell_observer(*change);
  if (readers_.empty()) return true;
  if (pacer_ == nullptr) {
    send_once(link_, owner(), readers_, change, fragment_bytes_);
    return true;
  }
  make_room();
  waiting_[change->sequence].change = change;
  const bool whole = change->bytes <= fragment_bytes_;
  pacer_->enqueue({number_, change->sequence, change->bytes, whole ? 0 : fragment_bytes_}, false);
  pacer_->run();
  return true;
}

void BestEffortWriter::make_room() {
  while (waiting_.size() >= depth_) {
    pacer_->remove(number_, waiting_.begin()->first);
    waiting_.erase(waiting_.begin());
  }
}

void BestEffortWriter::silence() {
  for (const auto& entry : waiting_) pacer_->remove(number_, entry.first);
  waiting_.clear();
}

bool BestEffortWriter::deliver(rtps::Sequence sequence, rtps::ByteBudget& budget) {
  const auto found = waiting_.find(sequence);
  if (found == waiting_.end()) return true;
  Waiting& sample = found->second;
  if (core_.now - sample.change->sent > lifespan_) {
    waiting_.erase(found);
    return true;
  }
  const auto packets = rtps::packets_of(sample.change->bytes, readers_.size(), fragment_bytes_);
  if (sample.on_air.empty())
    sample.on_air = begin(owner(), readers_, sample.change, packets.size());
  for (; sample.next_piece < packets.size(); ++sample.next_piece) {
    const std::size_t left = sample.change->bytes - sample.next_piece * fragment_bytes_;
    if (budget.is_exceeded_by(std::min(left, fragment_bytes_))) return false;
    const std::size_t packet = packets[sample.next_piece];
    budget.sent += packet - rtps::wire::ip_and_udp;
    for (const auto& one : sample.on_air) {
      link_.send(owner().way, packet, one, sample.next_piece);
    }
  }
  waiting_.erase(found);
  return true;
}

void BestEffortReader::die() {
  RtpsReader::die();
  for (RtpsWriter* writer : writers_) writer->unmatch(*this);
  writers_.clear();
}

void BestEffortReader::on_sample(std::uint64_t source, const Change& change) {
  std::uint64_t& last = last_[source];
  if (!alive() || change.sequence <= last) return;
  last = change.sequence;
  give(source, change);
}

}  // namespace tocsin::simulation
