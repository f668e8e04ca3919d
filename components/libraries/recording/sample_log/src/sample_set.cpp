// SPDX-License-Identifier: Apache-2.0
#include "sample_log/sample_set.hpp"

#include <algorithm>

namespace tocsin::sample_log {
namespace {

constexpr std::size_t most_writers = 4096;
constexpr std::size_t most_ranges = 4096;  ///< of one writer

}  // namespace

SampleSet::Known& SampleSet::known(const Writer& writer) {
  Known& found = writers_[writer];
  found.used = ++uses_;
  if (writers_.size() <= most_writers) return found;
  const auto oldest = std::min_element(
      writers_.begin(), writers_.end(),
      [](const auto& one, const auto& other) { return one.second.used < other.second.used; });
  writers_.erase(oldest);  // never the one just found
  return found;
}

bool SampleSet::contains(const SampleId& id) const {
  const auto found = writers_.find({id.stream, id.source});
  return found != writers_.end() && found->second.sequences.contains(id.sequence);
}

bool SampleSet::add(const SampleId& id) {
  Known& writer = known({id.stream, id.source});
  const bool is_new = writer.sequences.insert(id.sequence);
  writer.sequences.close_gaps(most_ranges);
  return is_new;
}

void SampleSet::add(const Writer& writer, std::uint64_t first, std::uint64_t last) {
  known(writer).sequences.insert(first, last);
}

}  // namespace tocsin::sample_log
