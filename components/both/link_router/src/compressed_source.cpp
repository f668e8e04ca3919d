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

}  // namespace

Sample CompressedSource::send(const Sample& plain, const Compress& compress) {
  if (plain.bytes > largest_compressed) return plain;
  if (rest_ > 0) {
    --rest_;
    return plain;
  }
  const Sample* const base = base_of(plain);
  const auto compressed = compress(plain, base);
  if (!compressed || !gains(*compressed, plain, base != nullptr)) {
    rest_ = rest_samples;
    return plain;
  }
  sent_.push_back(plain.origin.sequence);
  if (sent_.size() > kept_bases) sent_.pop_front();
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
  if (!base_) return nullptr;
  const std::uint64_t base = base_->origin.sequence;
  const bool is_kept = std::find(sent_.begin(), sent_.end(), base) != sent_.end();
  const std::uint64_t sequence = plain.origin.sequence;
  return is_kept && base < sequence && sequence - base <= SampleCoding::farthest ? &*base_
                                                                                 : nullptr;
}

void CompressedSource::on_delivered(const Sample& plain) {
  const std::uint64_t sequence = plain.origin.sequence;
  const bool is_kept = std::find(sent_.begin(), sent_.end(), sequence) != sent_.end();
  if (!is_kept || plain.bytes > largest_base) return;
  if (!base_ || base_->origin.sequence < sequence) base_ = plain;
}

void CompressedSource::on_new_reader() {
  sent_.clear();
  base_.reset();
}

}  // namespace tocsin::router
