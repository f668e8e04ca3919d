// SPDX-License-Identifier: Apache-2.0
#include "reliable.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tocsin::simulation {
namespace {

constexpr Duration lease = std::chrono::seconds(60);  // of the runtime's participants on the radio

/// From a writer to a reader.
class MessageOnAir final : public Cargo {
 public:
  MessageOnAir(std::uint64_t source, RtpsReader& reader, rtps::MessagePtr message)
      : source_(source), reader_(reader), message_(std::move(message)) {}
  void arrive(std::size_t) override { reader_.on_message(source_, *message_); }
  [[nodiscard]] bool waits_after(std::size_t) const override { return false; }

 private:
  std::uint64_t source_;
  RtpsReader& reader_;
  rtps::MessagePtr message_;
};

/// From a reader to a writer.
class AnswerOnAir final : public Cargo {
 public:
  AnswerOnAir(rtps::EndId reader, RtpsWriter& writer, rtps::MessagePtr message)
      : reader_(reader), writer_(writer), message_(std::move(message)) {}
  void arrive(std::size_t) override { writer_.on_answer(reader_, *message_); }
  [[nodiscard]] bool waits_after(std::size_t) const override { return false; }

 private:
  rtps::EndId reader_;
  RtpsWriter& writer_;
  rtps::MessagePtr message_;
};

std::size_t kept_by(const QosProfile& qos) {
  return static_cast<std::size_t>(qos.keeps_all() ? qos.room() : qos.depth);
}

rtps::WriterSettings writer_settings(const QosProfile& qos, const Pacer* pacer) {
  rtps::WriterSettings settings;
  settings.keep_all = qos.keeps_all();
  settings.room = kept_by(qos);
  settings.transient_local = qos.keeps_last();
  if (pacer != nullptr) settings.fragment_bytes = pacer->fragment_bytes();
  settings.lifespan = seconds(qos.lifespan_s);
  settings.heartbeat_period = seconds(qos.heartbeat_period_s);
  settings.nack_response_delay = seconds(qos.nack_response_delay_s);
  settings.nack_suppression = seconds(qos.nack_suppression_s);
  settings.heartbeat_piggyback = qos.heartbeat_piggyback;
  return settings;
}

rtps::ReaderSettings reader_settings(const QosProfile& qos) {
  rtps::ReaderSettings settings;
  settings.keep_all = qos.keeps_all();
  settings.depth = static_cast<std::size_t>(qos.depth);
  settings.room = static_cast<std::size_t>(qos.room());
  settings.heartbeat_response_delay = seconds(qos.heartbeat_response_delay_s);
  settings.initial_acknack_delay = seconds(qos.initial_acknack_delay_s);
  return settings;
}

}  // namespace

ReliableWriter::ReliableWriter(Core& core, RadioLink& link, const Owner& owner,
                               const QosProfile& qos, Pacer* pacer)
    : RtpsWriter(core, link, owner),
      pacer_(pacer),
      fragment_bytes_(writer_settings(qos, pacer).fragment_bytes),
      max_blocking_(seconds(qos.max_blocking_time_s)),
      model_(writer_settings(qos, pacer), *this, pacer == nullptr ? nullptr : this),
      alarm_(
          core, [this] { return model_.next_event(); },
          [this] {
            model_.on_time(core_.now);
            update();
          }) {
  if (pacer_ != nullptr) number_ = pacer_->add(*this, qos);
}

void ReliableWriter::match(RtpsReader& reader) {
  const rtps::EndId number = ++last_reader_;
  reader.match(*this, number);
  if (!reader.reliable()) {
    unacknowledging_.push_back(&reader);
    return;
  }
  readers_[number] = &reader;
  model_.match(number, core_.now);
  update();
}

void ReliableWriter::unmatch(const RtpsReader& reader) {
  unacknowledging_.erase(std::remove(unacknowledging_.begin(), unacknowledging_.end(), &reader),
                         unacknowledging_.end());
  const auto found = std::find_if(readers_.begin(), readers_.end(),
                                  [&](const auto& one) { return one.second == &reader; });
  if (found == readers_.end()) return;
  model_.unmatch(found->first, core_.now);
  readers_.erase(found);
  update();
}

void ReliableWriter::silence() {
  waiting_.reset();
  model_.clear();
}

void ReliableWriter::die() {
  RtpsWriter::die();
  // Until then its readers think that it lives.
  core_.events.at(core_.now + lease, [this] {
    for (const auto& one : readers_) one.second->unmatch(owner().source);
  });
}

bool ReliableWriter::publish(Change&& change) {
  if (waiting_) return false;
  if (model_.has_room(core_.now)) {
    write(std::move(change));
    return true;
  }
  if (max_blocking_ == Duration{0}) return false;
  waiting_ = std::move(change);
  core_.events.at(core_.now + max_blocking_, [this, number = ++waited_] {
    if (waited_ == number) waiting_.reset();
  });
  return true;
}

void ReliableWriter::write(Change&& made) {
  made.sequence = model_.next_sequence();
  tell_observer(made);
  const auto change = std::make_shared<const Change>(std::move(made));
  send_once(link_, owner(), unacknowledging_, change, fragment_bytes_);
  model_.write(change, change->bytes, core_.now);
  update();
}

void ReliableWriter::write_waiting() {
  if (!waiting_ || !model_.has_room(core_.now)) return;
  Change change = std::move(*waiting_);
  waiting_.reset();
  write(std::move(change));
}

void ReliableWriter::on_answer(rtps::EndId reader, const rtps::Message& message) {
  if (!alive()) return;
  model_.on_message(reader, message, core_.now);
  update();
}

void ReliableWriter::update() {
  if (pacer_ != nullptr) pacer_->run();
  write_waiting();
  alarm_.update();
}

void ReliableWriter::send(rtps::EndId to, const rtps::MessagePtr& message) {
  const auto found = readers_.find(to);
  assert(found != readers_.end());
  link_.send(owner().way, message->ip_bytes,
             std::make_shared<MessageOnAir>(owner().source, *found->second, message), 0);
}

void ReliableWriter::add(rtps::Sequence sequence, bool resent) {
  const rtps::SamplePtr sample = model_.find(sequence);
  if (sample) pacer_->enqueue({number_, sequence, sample->bytes, sample->fragment_bytes}, resent);
}

bool ReliableWriter::deliver(rtps::Sequence sequence, rtps::ByteBudget& budget) {
  if (!group_) group_.emplace(static_cast<rtps::Sender&>(*this), &budget);
  return model_.deliver(sequence, *group_, core_.now);
}

ReliableReader::ReliableReader(Core& core, RadioLink& link, const QosProfile& qos, Deliver deliver)
    : RtpsReader(core, qos, std::move(deliver)),
      link_(link),
      model_(reader_settings(qos), *this,
             [this](rtps::EndId source, const rtps::SamplePtr& sample) {
               give(source, *static_cast<const Change*>(sample->content.get()));
             }),
      alarm_(
          core, [this] { return model_.next_event(); }, [this] { model_.on_time(core_.now); }) {}

void ReliableReader::match(RtpsWriter& writer, rtps::EndId number) {
  writers_[writer.owner().source] = {&writer, number};
  model_.match(writer.owner().source, core_.now);
  alarm_.update();
}

void ReliableReader::unmatch(std::uint64_t source) {
  writers_.erase(source);
  model_.unmatch(source);
}

void ReliableReader::on_message(std::uint64_t source, const rtps::Message& message) {
  if (!alive()) return;
  model_.on_message(source, message, core_.now);
  alarm_.update();
}

void ReliableReader::die() {
  RtpsReader::die();
  for (const auto& [source, one] : writers_) {
    one.writer->unmatch(*this);
    model_.unmatch(source);
  }
  writers_.clear();
}

void ReliableReader::send(rtps::EndId to, const rtps::MessagePtr& message) {
  const auto found = writers_.find(to);
  if (found == writers_.end()) return;
  RtpsWriter& writer = *found->second.writer;
  link_.send(back(writer.owner().way), message->ip_bytes,
             std::make_shared<AnswerOnAir>(found->second.number, writer, message), 0);
}

}  // namespace tocsin::simulation
