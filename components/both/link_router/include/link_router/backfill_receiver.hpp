// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "link_router/backfill_batch.hpp"
#include "link_router/transmission.hpp"
#include "sample_log/sample_set.hpp"

namespace tocsin::router {

/// Takes the batches of peers in their order and leaves out what was delivered to the host before,
/// live or in a batch. Of samples, `stream` is the stream_key of the peer's name and the stream's
/// name. What was delivered to the host is remembered by whoever calls it, over the instances of
/// this router; a batch is confirmed only when that is safe. Pure.
class BackfillReceiver {
 public:
  using SampleId = sample_log::SampleId;

  /// The number of a peer's stream here.
  [[nodiscard]] static std::uint64_t stream_key(const std::string& peer, const std::string& stream);

  /// What earlier instances of this router have delivered. Before it, batches are not taken.
  void recover(const sample_log::SampleSet& delivered);
  /// The host gets a sample that was received live. Whether it is the first time.
  bool on_live(const SampleId& id) { return delivered_.add(id); }

  /// What to deliver to the host, in this order; empty when the batch is a repetition or too early.
  /// One that is too early is kept until its turn.
  [[nodiscard]] std::vector<BackfillBatch> on_batch(const std::string& peer, InstanceId instance,
                                                    BackfillBatch batch);
  /// All batches of this instance of the peer up to this one were taken; zeroes before the first.
  [[nodiscard]] BackfillProgress progress(const std::string& peer, InstanceId instance) const;

 private:
  struct Session {
    InstanceId instance = 0;
    BackfillProgress progress;
    std::map<std::uint32_t, BackfillBatch> early;
  };
  bool recovered_ = false;
  sample_log::SampleSet delivered_;
  std::map<std::string, Session> sessions_;
};

}  // namespace tocsin::router
