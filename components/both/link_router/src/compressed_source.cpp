// SPDX-License-Identifier: Apache-2.0
#include "link_router/compressed_source.hpp"

#include <algorithm>

namespace tocsin::router {
namespace {

/// A gain that is worth the work on both sides: [B], and one part of so many of the sample.
constexpr std::size_t least_gain = 16;
constexpr std::size_t least_gain_part = 16;
/// Samples until a source is tried again that gained less.
constexpr unsigned rest_samples = 64;
/// Samples are of about one size when they differ by at most one part of so many.
constexpr std::size_t alike_part = 8;

}  // namespace

Sample CompressedSource::send(const Sample& plain, const Compress& compress) {
  if (plain.bytes > SampleCoding::largest) return plain;
  if (rest_ > 0 && plain.bytes <= resting_bytes_) {
    --rest_;
    return plain;
  }
  const Sample* const base = base_of(plain);
  const auto compressed = compress(plain, base);
  if (!compressed || !gains(*compressed, plain, base != nullptr)) {
    rest_ = rest_samples;
    resting_bytes_ = plain.bytes;
    return plain;
  }
  sent_.push_back(plain.origin.sequence);
  if (sent_.size() > kept_bases) {
    bases_.erase(sent_.front());
    sent_.pop_front();
  }
  Sample sent = *compressed;
  sent.origin = plain.origin;
  return sent;
}

bool CompressedSource::gains(const Sample& compressed, const Sample& plain, bool has_base) {
  // The first ones are what the gain begins with.
  const bool may_become_base = !has_base && plain.bytes <= largest_base;
  const std::size_t gain = std::max(least_gain, plain.bytes / least_gain_part);
  return may_become_base || compressed.bytes + gain <= plain.bytes;
}

const Sample* CompressedSource::base_of(const Sample& plain) const {
  const std::uint64_t sequence = plain.origin.sequence;
  const Sample* newest = nullptr;
  for (auto it = bases_.rbegin(); it != bases_.rend(); ++it) {
    const Sample& base = it->second;
    if (it->first >= sequence || sequence - it->first > SampleCoding::farthest) continue;
    const std::size_t larger = std::max(base.bytes, plain.bytes);
    if (larger - std::min(base.bytes, plain.bytes) <= larger / alike_part) return &base;
    if (newest == nullptr) newest = &base;
  }
  return newest;
}

void CompressedSource::on_delivered(const Sample& plain) {
  const std::uint64_t sequence = plain.origin.sequence;
  const bool is_kept = std::find(sent_.begin(), sent_.end(), sequence) != sent_.end();
  if (is_kept && plain.bytes <= largest_base) bases_[sequence] = plain;
}

void CompressedSource::on_new_reader() {
  sent_.clear();
  bases_.clear();
}

}  // namespace tocsin::router
