// SPDX-License-Identifier: Apache-2.0
#include "message_stream.hpp"

#include <algorithm>
#include <deque>
#include <queue>
#include <tuple>
#include <utility>

#include "chunk.hpp"

namespace tocsin::mcap {
namespace {

/// A message of a chunk in memory.
struct Entry {
  std::uint64_t log_time_ns;
  Span content;
};

struct OpenChunk {
  std::uint64_t offset = 0;  ///< in the file
  LoadedChunk loaded;
  std::vector<Entry> entries;
  std::size_t next = 0;
};

class ChunkwiseStream final : public MessageStream {
 public:
  ChunkwiseStream(ByteSource& source, const Summary& summary, Query query, Damage& damage)
      : source_(source), query_(std::move(query)), damage_(damage), wanted_(65'536) {
    for (const auto& [id, channel] : summary.channels) {
      wanted_[id] = !query_.wanted || query_.wanted(channel);
    }
    for (const ChunkIndex& index : summary.chunks) {
      if (is_wanted(index)) waiting_.push_back(&index);
    }
    if (query_.order == Order::log_time) {
      std::stable_sort(waiting_.begin(), waiting_.end(),
                       [](const auto* a, const auto* b) { return a->start_ns < b->start_ns; });
    }
  }

  std::optional<Message> next() override {
    release();
    load_what_is_due();
    if (open_.empty()) return std::nullopt;
    const auto place = open_.top();
    open_.pop();
    current_ = std::get<2>(place);
    const Entry& entry = current_->entries[current_->next++];
    if (current_->next < current_->entries.size()) enqueue(current_);
    return decode<Message>(entry.content);
  }

 private:
  using Due = std::tuple<std::uint64_t, std::uint64_t, OpenChunk*>;

  [[nodiscard]] bool is_wanted(const ChunkIndex& index) const {
    if (index.end_ns < query_.from_ns || index.start_ns > query_.to_ns) return false;
    const auto& channels = index.message_indexes;
    return channels.empty() || std::any_of(channels.begin(), channels.end(),
                                           [&](const auto& one) { return wanted_[one.first]; });
  }

  /// Gives back the chunk whose last message was taken.
  void release() {
    if (current_ == nullptr || current_->next < current_->entries.size()) return;
    const auto found = std::find_if(chunks_.begin(), chunks_.end(),
                                    [&](const auto& one) { return one.get() == current_; });
    spare_ = std::move(*found);
    chunks_.erase(found);
    current_ = nullptr;
  }

  /// Every chunk that may hold an earlier message than the next one.
  void load_what_is_due() {
    while (next_ < waiting_.size()) {
      const ChunkIndex& index = *waiting_[next_];
      const bool enough = query_.order == Order::file || index.start_ns > std::get<0>(first_due());
      if (!open_.empty() && enough) return;
      ++next_;
      load(index);
    }
  }
  [[nodiscard]] Due first_due() const { return open_.empty() ? Due{} : open_.top(); }

  void load(const ChunkIndex& index) {
    auto chunk = spare_ ? std::move(spare_) : std::make_unique<OpenChunk>();
    chunk->offset = index.offset;
    chunk->entries.clear();
    chunk->next = 0;
    load_chunk(source_, index, chunk->loaded);
    if (chunk->loaded.state == LoadedChunk::State::damaged) ++damage_.chunks;
    for_each_record(chunk->loaded.records, [&](Opcode opcode, Span content, std::size_t) {
      if (opcode != Opcode::message) return;
      const auto message = decode<Message>(content);
      if (!message || !wanted_[message->channel_id]) return;
      if (message->log_time_ns < query_.from_ns || message->log_time_ns > query_.to_ns) return;
      chunk->entries.push_back({message->log_time_ns, content});
    });
    if (chunk->entries.empty()) {
      spare_ = std::move(chunk);
      return;
    }
    if (query_.order == Order::log_time) {
      std::stable_sort(
          chunk->entries.begin(), chunk->entries.end(),
          [](const Entry& a, const Entry& b) { return a.log_time_ns < b.log_time_ns; });
    }
    chunks_.push_back(std::move(chunk));
    enqueue(chunks_.back().get());
  }

  void enqueue(OpenChunk* chunk) {
    const bool by_time = query_.order == Order::log_time;
    open_.emplace(by_time ? chunk->entries[chunk->next].log_time_ns : 0, chunk->offset, chunk);
  }

  ByteSource& source_;
  const Query query_;
  Damage& damage_;
  std::vector<bool> wanted_;  ///< by channel id
  std::vector<const ChunkIndex*> waiting_;
  std::size_t next_ = 0;
  std::vector<std::unique_ptr<OpenChunk>> chunks_;
  std::unique_ptr<OpenChunk> spare_;  ///< its memory is used again
  OpenChunk* current_ = nullptr;
  std::priority_queue<Due, std::vector<Due>, std::greater<>> open_;
};

}  // namespace

std::unique_ptr<MessageStream> make_message_stream(ByteSource& source, const Summary& summary,
                                                   Query query, Damage& damage) {
  return std::make_unique<ChunkwiseStream>(source, summary, std::move(query), damage);
}

}  // namespace tocsin::mcap
