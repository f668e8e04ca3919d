// SPDX-License-Identifier: Apache-2.0
#include "link_router/backfill_receiver.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::router {
namespace {

/// Batches ahead of their turn that are kept; a sender has fewer under way.
constexpr std::uint32_t most_early = 16;

}  // namespace

std::uint64_t BackfillReceiver::stream_key(const std::string& peer, const std::string& stream) {
  return sample_log::stream_key(peer + "|" + stream);
}

void BackfillReceiver::recover(const sample_log::SampleSet& delivered) {
  for (const auto& [writer, known] : delivered.writers()) {
    for (const auto& [first, last] : known.sequences.ranges()) delivered_.add(writer, first, last);
  }
  recovered_ = true;
}

std::vector<BackfillBatch> BackfillReceiver::on_batch(const std::string& peer, InstanceId instance,
                                                      BackfillBatch batch) {
  std::vector<BackfillBatch> in_turn;
  if (!recovered_) return in_turn;
  Session& session = sessions_[peer];
  if (session.instance != instance || batch.session > session.progress.session) {
    session = {instance, {batch.session, 0}, {}};
  }
  const std::uint32_t last = session.progress.number;
  const bool too_far = batch.number > last + most_early;
  if (batch.session != session.progress.session || batch.number <= last || too_far) return in_turn;
  const std::uint32_t number = batch.number;
  session.early.emplace(number, std::move(batch));
  for (auto next = session.early.begin();
       next != session.early.end() && next->first == session.progress.number + 1;
       next = session.early.erase(next)) {
    ++session.progress.number;
    auto& samples = next->second.samples;
    const auto was_delivered = [this](const auto& entry) { return !delivered_.add(entry.id); };
    samples.erase(std::remove_if(samples.begin(), samples.end(), was_delivered), samples.end());
    in_turn.push_back(std::move(next->second));
  }
  return in_turn;
}

BackfillProgress BackfillReceiver::progress(const std::string& peer, InstanceId instance) const {
  const auto found = sessions_.find(peer);
  const bool known = found != sessions_.end() && found->second.instance == instance;
  return known ? found->second.progress : BackfillProgress{};
}

}  // namespace tocsin::router
