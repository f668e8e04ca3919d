// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "decision/channel_qni.hpp"
#include "decision/joint_index.hpp"
#include "decision/qni.hpp"
#include "foundation/parameters.hpp"

namespace tocsin::decision {

/// The quality indexes that can be chosen.
inline constexpr Choices quality_indexes{"thesis", "channel", "joint"};

/// Which index, and its weights and ranges. PER and signal are weighed alike in both; in place of
/// the link quality `channel` has the channel's load; `joint` has no weights but what it knows of a
/// good and a bad link.
struct QualityIndexParams {
  std::string quality_index = "thesis";
  QniParams thesis;
  double weight_channel = 0.3;
  double retries_worst = 3.0;
  JointIndexParams joint;

  template <class Visitor>
  void visit(Visitor& v) {
    v("quality_index", quality_index, quality_indexes,
      "thesis: PER, signal and link quality; channel: PER, signal and how free the channel is; "
      "joint: all readings by how far good and bad lie apart");
    thesis.visit(v);
    v("weight_channel", weight_channel, {0, 1},
      "[1] index channel: weight of free air time or few retries, in place of weight_quality");
    v("retries_worst", retries_worst, {0.01, 100},
      "[1] index channel: retries per frame that score 0");
    joint.visit(v);
  }
};

/// What a NetworkQuality message says of the link; absent and NaN mean "not told".
struct QualityMeasurement {
  std::optional<double> per_percent{};      ///< lost probes [0,100]; a dead link is 100
  std::optional<double> signal_dbm{};       ///< received signal strength
  std::optional<double> quality_percent{};  ///< link quality, rescaled from x/70
  std::optional<double> retry_percent{};    ///< retried frames of all that were sent, [0,100]
  std::optional<double> busy_percent{};     ///< channel utilisation, [0,100]
  std::optional<double> rtt_ms{};           ///< mean of the answered probes
};

/// Those of them that the joint index weighs.
[[nodiscard]] JointIndexInput joint_input(const QualityMeasurement& measured);

/// The index that the parameters name. Pure; no allocation, no throw after construction.
class QualityIndex {
 public:
  /// Throws ConfigError when the weights of the chosen index do not sum to 1, the signal's range is
  /// empty, or the joint index has no sound parameters.
  explicit QualityIndex(const QualityIndexParams& params);
  /// [0,100], 100 is perfect; NaN when no term of the index was measured.
  [[nodiscard]] double evaluate(const QualityMeasurement& measured) const;

 private:
  std::optional<QniModel> thesis_;
  std::optional<ChannelQniModel> channel_;
  std::optional<JointIndex> joint_;
};

}  // namespace tocsin::decision
