// SPDX-License-Identifier: Apache-2.0
#include "backfill/arrival_log.hpp"

#include "backfill/backfill_messages.hpp"
#include "router_messages.hpp"

namespace tocsin {

void ArrivalLog::keep(const Flow& flow, const CarriedSample& sample, Instant at) {
  if (!link_.rules().keeps(flow.topic)) return;
  const std::string name = stream_rule(flow, {}).name;
  if (known_.insert(name).second) history_.add(logged_stream(name, flow));
  const sample_log::SampleId id{sample_log::stream_key(name), sample.source, sample.sequence};
  history_.append({id, sample.sent_wall_ns, link_.bytes_of(sample)}, at);
}

}  // namespace tocsin
