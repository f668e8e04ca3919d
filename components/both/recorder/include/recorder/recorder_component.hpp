// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "recorder/bag_recording.hpp"
#include "recorder/topic_choice.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// Records every link topic that reaches its process, and any other topic that it is told to, while
/// it is told to.
class RecorderComponent final : public Component {
 public:
  struct Params {
    bool recording = true;
    std::string directory;
    double flush_period_s = 0.5;
    bool link_topics = true;
    bool backfilled = false;
    std::vector<std::string> topics;
    mcap::Compression bag_compression = mcap::Compression::zstd;
    double keep_free = 0.05;
    template <class Visitor>
    void visit(Visitor& v) {
      live(v)("recording", recording,
              "whether it records now; each time it begins, a bag of its own");
      v("directory", directory, "folder of the bag; made when absent; empty: run folder/role");
      v("flush_period_s", flush_period_s, {0.05, 60}, "[s] between writes to the disk");
      v("link_topics", link_topics, "whether every topic that crosses the link is recorded");
      v("backfilled", backfilled,
        "whether of each of these also <topic>/backfilled is, where a router gives stored samples");
      v("topics", topics, "others: names, patterns, or NAME TYPE [QOS [host|link]]");
      visit_enum(v, "bag_compression", bag_compression, Choices{"none", "lz4", "zstd"},
                 "of the bag's chunks");
      v("keep_free", keep_free, {0, 0.9},
        "[1] of the disk that recording leaves to others, of a large one 1 GB");
    }
  };

  RecorderComponent(Context& context, const Params& params);
  void tick(Time now) override;
  /// Begins or ends at the next tick.
  void set_parameters(const Params& params) { wanted_ = params.recording; }

 private:
  /// Throws ConfigError when a recording cannot be made, or a topic has no QoS profile.
  void begin(Time now);
  void end();
  void follow_wish(Time now);
  void take_samples();
  [[nodiscard]] std::unique_ptr<InputPort> listen_to(const ChosenTopic& topic);
  /// One topic: where it comes from, and its number in the recording.
  struct Track {
    std::size_t number;
    std::unique_ptr<InputPort> input;
  };
  void flush(Time now);

  const Params params_;
  const std::string directory_;
  const Duration flush_period_;
  Time next_flush_{};
  Time next_try_{};
  const std::vector<ChosenTopic> topics_;
  bool wanted_;
  Time began_{};
  std::int64_t began_wall_ns_ = 0;
  bool said_fault_ = false;
  std::optional<BagRecording> recording_;  ///< none: it does not record
  std::vector<Track> tracks_;
  bool disk_full_ = false;
  std::uint64_t lost_ = 0;
};

}  // namespace tocsin
