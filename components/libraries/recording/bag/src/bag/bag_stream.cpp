// SPDX-License-Identifier: Apache-2.0
#include "bag_stream.hpp"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

#include "totals.hpp"

namespace tocsin::bag {
namespace {

/// One file whose next message is known.
struct Source {
  BagReader::File* file;
  std::unique_ptr<mcap::MessageStream> stream;
  mcap::Message next;
};

class MergedStream final : public BagStream {
 public:
  MergedStream(std::vector<BagReader::File>& files, const std::vector<Metadata::TopicCount>& topics,
               const Selection& selection)
      : topics_(topics), selection_(selection), sources_(files.size()) {
    for (BagReader::File& file : files) waiting_.push_back(&file);
    std::stable_sort(waiting_.begin(), waiting_.end(),
                     [](const auto* a, const auto* b) { return start_of(*a) < start_of(*b); });
  }

  std::optional<TopicMessage> next() override {
    if (current_) advance(*current_);
    current_.reset();
    open_what_is_due();
    if (due_.empty()) return std::nullopt;
    current_ = std::get<1>(due_.top());
    due_.pop();
    const Source& source = sources_[*current_];
    const mcap::Message& message = source.next;
    return TopicMessage{
        source.file->topic_of_channel[message.channel_id],
        {message.sequence, time_of(message.log_time_ns), time_of(message.publish_time_ns),
         message.data, message.size, source.file->writer_of_channel[message.channel_id]}};
  }

 private:
  static std::uint64_t start_of(const BagReader::File& file) {
    return file.reader->summary().statistics.start_ns;
  }

  /// Every file that may hold an earlier message than the next one.
  void open_what_is_due() {
    while (opened_ < waiting_.size()) {
      BagReader::File& file = *waiting_[opened_];
      if (!due_.empty() && start_of(file) > std::get<0>(due_.top())) return;
      mcap::Query query;
      query.from_ns = static_cast<std::uint64_t>(std::max<std::int64_t>(0, selection_.from_ns));
      query.to_ns = static_cast<std::uint64_t>(std::max<std::int64_t>(0, selection_.to_ns));
      query.wanted = [this, &file](const mcap::Channel& channel) {
        const Topic& topic = topics_[file.topic_of_channel[channel.id]].topic;
        return !selection_.wanted || selection_.wanted(topic);
      };
      sources_[opened_] = {&file, file.reader->messages(std::move(query)), {}};
      advance(opened_++);
    }
  }

  void advance(std::size_t number) {
    Source& source = sources_[number];
    if (const auto message = source.stream->next()) {
      source.next = *message;
      due_.emplace(message->log_time_ns, number);
    } else {
      source.stream.reset();
    }
  }

  const std::vector<Metadata::TopicCount>& topics_;
  const Selection selection_;
  std::vector<BagReader::File*> waiting_;  ///< by the time of their first message
  std::size_t opened_ = 0;
  std::vector<Source> sources_;
  std::optional<std::size_t> current_;  ///< whose message was given out last
  using Due = std::tuple<std::uint64_t, std::size_t>;
  std::priority_queue<Due, std::vector<Due>, std::greater<>> due_;
};

}  // namespace

std::unique_ptr<BagStream> merged(std::vector<BagReader::File>& files,
                                  const std::vector<Metadata::TopicCount>& topics,
                                  const Selection& selection) {
  return std::make_unique<MergedStream>(files, topics, selection);
}

}  // namespace tocsin::bag
