// SPDX-License-Identifier: Apache-2.0
#include "recording.hpp"

#include <chrono>
#include <cstdio>
#include <utility>

#include "command_line/stop_signal.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "writer_qos.hpp"

namespace tocsin::bag_tool {
namespace {

/// A process that is killed loses no more than came within it.
constexpr Duration flush_period = std::chrono::milliseconds(500);
constexpr Duration look = std::chrono::milliseconds(50);  // a signal wakes nobody

}  // namespace

Recording::Recording(HostGraph& graph, const RecordOrder& order)
    : graph_(graph),
      order_(order),
      choice_(order.topics),
      writer_(order.output, order.options),
      queue_(order.cache_bytes) {}

void Recording::run() {
  Time next_look = std::chrono::steady_clock::now();
  Time next_flush = next_look;
  while (!is_stopped()) {
    const Time now = std::chrono::steady_clock::now();
    if (now >= next_look) {
      look_for_topics();
      next_look = order_.discovery ? now + seconds(order_.polling_interval_s) : never;
    }
    write_what_came(look);
    if (now >= next_flush) {
      (void)writer_.flush();
      tell_loss();
      next_flush = now + flush_period;
    }
  }
  readings_.clear();
  write_what_came(Duration{0});
  (void)writer_.close();
  tell_loss();
}

void Recording::look_for_topics() {
  const std::vector<GraphEnd> ends = graph_.ends();
  std::map<std::string, std::vector<const GraphEnd*>> writers;
  for (const GraphEnd& end : ends) {
    const auto name = ros_topic(end.topic);
    if (end.writer && name && readings_.count(*name) == 0) writers[*name].push_back(&end);
  }
  for (const auto& [name, of_topic] : writers) {
    if (choice_.contains(name)) subscribe(name, of_topic);
  }
}

void Recording::subscribe(const std::string& name, const std::vector<const GraphEnd*>& writers) {
  const RawTopic raw = readable(writers);
  bag::Topic topic = bag::make_topic(raw.name, raw.type);
  topic.offered_qos = offered_by(writers);
  const std::size_t number = writer_.add(topic);
  ++topics_;
  readings_[name] = graph_.read(
      raw, [this, number](RawSample&& sample) { queue_.push(number, std::move(sample)); });
  std::printf("Subscribed to topic '%s'%s\n", printable(name).c_str(),
              topic.definition_encoding.empty()
                  ? ", whose type is not known here: it is recorded without its definition"
                  : "");
  std::fflush(stdout);
}

void Recording::write_what_came(Duration patience) {
  for (const RecordQueue::Item& item : queue_.take(patience)) {
    const RawSample& sample = item.sample;
    const bag::Message message{static_cast<std::uint32_t>(sample.sequence),
                               sample.received_wall_ns,
                               sample.sent_wall_ns,
                               sample.bytes->data(),
                               sample.bytes->size(),
                               sample.source};
    (void)writer_.write(item.topic, message);
    ++messages_;
  }
}

void Recording::tell_loss() {
  const std::uint64_t now_lost = lost();
  if (now_lost == told_lost_) return;
  told_lost_ = now_lost;
  std::fprintf(stderr, "messages are being lost: %llu so far (%llu had no room in memory)\n",
               static_cast<unsigned long long>(now_lost),
               static_cast<unsigned long long>(queue_.dropped()));
}

}  // namespace tocsin::bag_tool
