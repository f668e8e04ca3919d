// SPDX-License-Identifier: Apache-2.0
#include "fetching.hpp"

#include <chrono>
#include <cstdio>
#include <utility>

#include "command_line/stop_signal.hpp"
#include "foundation/ros_names.hpp"
#include "idl_support/encode.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::log_tool {
namespace {

using Request = tocsin_msgs::msg::LogRequest;

constexpr Duration look = std::chrono::milliseconds(50);
/// What was given before the last state was told has come within it.
constexpr Duration last_words = std::chrono::seconds(1);
/// [ns] A sample comes to the log a little after it was sent.
constexpr std::int64_t margin_ns = 1'000'000'000;

}  // namespace

Waiting real_waiting() {
  return {[] { return std::chrono::steady_clock::now(); }, sleep_until_stopped};
}

Fetching::Fetching(HostGraph& graph, StateListener& states, const Request& request,
                   const std::string& output, Waiting waiting)
    : graph_(graph),
      states_(states),
      waiting_(std::move(waiting)),
      fetch_(request),
      writer_(output, {mcap::Compression::zstd, 0, 0}),
      request_(graph.write({states.on_wire(topic::LogRequest::info.name), type_info<Request>().name,
                            true, false})) {}

bool Fetching::run() {
  Time end = never;
  while (!is_stopped() && waiting_.now() < end) {
    const Time now = waiting_.now();
    if (fetch_.has_to_ask(now)) ask();
    if (!reading_) look_for_writer();
    write_what_came();
    for (const auto& [state, at] : states_.take()) fetch_.on_state(state, at);
    const std::string news = fetch_.news(now);
    if (!news.empty()) std::fprintf(stderr, "%s\n", news.c_str());
    if (fetch_.is_done() && end == never) end = now + last_words;
    waiting_.sleep_until(now + look);
  }
  reading_.reset();
  write_what_came();
  (void)writer_.close();
  return fetch_.is_done();
}

void Fetching::ask() {
  const Request request = fetch_.request();
  (void)request_->write(encode(type_info<Request>(), &request));
}

void Fetching::look_for_writer() {
  const std::string name = states_.on_wire(fetch_.request().topic() + "/backfilled");
  const std::vector<GraphEnd> ends = graph_.ends();
  std::vector<const GraphEnd*> writers;
  for (const GraphEnd& end : ends) {
    if (end.writer && end.topic == name) writers.push_back(&end);
  }
  if (writers.empty()) return;
  const RawTopic raw = readable(writers);
  topic_ = writer_.add(bag::make_topic(wire_topic(fetch_.request().topic()), raw.type));
  reading_ = graph_.read(raw, [this](RawSample&& sample) {
    const std::lock_guard<std::mutex> lock(mutex_);
    came_.push_back(std::move(sample));
  });
}

bool Fetching::is_in_range(const RawSample& sample) const {
  return sample.sent_wall_ns >= fetch_.request().from_ns() - margin_ns &&
         sample.sent_wall_ns <= fetch_.request().to_ns() + margin_ns;
}

void Fetching::write_what_came() {
  std::vector<RawSample> came;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    came.swap(came_);
  }
  for (const RawSample& sample : came) {
    if (!is_in_range(sample)) continue;  // of an earlier request, which late readers get, too
    const bag::Message message{static_cast<std::uint32_t>(sample.sequence),
                               sample.sent_wall_ns,
                               sample.sent_wall_ns,
                               sample.bytes->data(),
                               sample.bytes->size(),
                               sample.source};
    if (writer_.write(topic_, message) != mcap::Kept::nothing) ++written_;
  }
}

}  // namespace tocsin::log_tool
