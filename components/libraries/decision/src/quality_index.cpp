// SPDX-License-Identifier: Apache-2.0
#include "decision/quality_index.hpp"

namespace tocsin::decision {
namespace {

constexpr double link_quality_max = 70;  // the scale of /proc/net/wireless

ChannelQniParams channel_params(const QualityIndexParams& p) {
  return {p.thesis.weight_per,       p.thesis.weight_signal,   p.weight_channel,
          p.thesis.signal_worst_dbm, p.thesis.signal_best_dbm, p.retries_worst};
}

/// Retries per frame of a share r/(1 + r).
std::optional<double> retries_per_frame(const std::optional<double>& percent) {
  if (!percent) return std::nullopt;
  return *percent >= 100 ? 1e9 : *percent / (100 - *percent);
}

}  // namespace

JointIndexInput joint_input(const QualityMeasurement& measured) {
  return {measured.per_percent, measured.rtt_ms, measured.retry_percent, measured.busy_percent,
          measured.signal_dbm};
}

QualityIndex::QualityIndex(const QualityIndexParams& params) {
  if (params.quality_index == "channel") {
    channel_.emplace(channel_params(params));
  } else if (params.quality_index == "joint") {
    joint_.emplace(params.joint);
  } else {
    thesis_.emplace(params.thesis);
  }
}

double QualityIndex::evaluate(const QualityMeasurement& measured) const {
  if (joint_) return joint_->evaluate(joint_input(measured));
  if (channel_) {
    std::optional<double> busy;
    if (measured.busy_percent) busy = *measured.busy_percent / 100;
    return channel_
        ->evaluate({measured.per_percent, measured.signal_dbm, busy,
                    retries_per_frame(measured.retry_percent)})
        .value;
  }
  std::optional<double> quality;
  if (measured.quality_percent) quality = *measured.quality_percent / 100 * link_quality_max;
  return thesis_->evaluate({measured.per_percent, measured.signal_dbm, quality}).value;
}

}  // namespace tocsin::decision
