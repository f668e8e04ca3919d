// SPDX-License-Identifier: Apache-2.0
#include "link_router/compressed_samples.hpp"

#include "link_router/compressed_source.hpp"

namespace tocsin::router {
namespace {

constexpr std::size_t kept = 2 * kept_bases;
/// [B] What a sample takes beside its content, at least.
constexpr std::size_t beside = 200;

}  // namespace

void CompressedSamples::add(std::uint64_t stream, const Sample& plain) {
  if (plain.bytes > largest_base) return;
  const Source source{stream, plain.origin.source};
  Samples& samples = sources_[source];
  if (samples.count(plain.origin.sequence) != 0) return;
  const auto arrival = arrivals_.insert(arrivals_.end(), {source, plain.origin.sequence});
  samples.emplace(plain.origin.sequence, Kept{plain, arrival});
  bytes_ += plain.bytes + beside;
  if (samples.size() > kept) erase(source, samples.begin()->first);
  while (bytes_ > most_bytes) {
    const auto [first, sequence] = arrivals_.front();
    erase(first, sequence);
  }
}

const Sample* CompressedSamples::find(std::uint64_t stream, SourceId source,
                                      std::uint64_t sequence) const {
  const auto samples = sources_.find({stream, source});
  if (samples == sources_.end()) return nullptr;
  const auto found = samples->second.find(sequence);
  return found == samples->second.end() ? nullptr : &found->second.sample;
}

void CompressedSamples::erase(const Source& source, std::uint64_t sequence) {
  const auto samples = sources_.find(source);
  if (samples == sources_.end()) return;
  const auto found = samples->second.find(sequence);
  if (found == samples->second.end()) return;
  bytes_ -= found->second.sample.bytes + beside;
  arrivals_.erase(found->second.arrival);
  samples->second.erase(found);
  if (samples->second.empty()) sources_.erase(samples);
}

void CompressedSamples::forget(std::uint64_t stream) {
  for (auto it = sources_.lower_bound({stream, 0});
       it != sources_.end() && it->first.first == stream;) {
    for (const auto& [sequence, kept_one] : it->second) {
      bytes_ -= kept_one.sample.bytes + beside;
      arrivals_.erase(kept_one.arrival);
    }
    it = sources_.erase(it);
  }
}

}  // namespace tocsin::router
