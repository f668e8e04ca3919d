// SPDX-License-Identifier: Apache-2.0
#include "arrival_log.hpp"

#include "backfill_messages.hpp"
#include "router_messages.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {

void ArrivalLog::keep(const Flow& flow, const CarriedSample& sample, Time now) {
  if (!parts_.link.rules().keeps(flow.topic)) return;
  const std::string name = stream_rule(flow, {}).name;
  if (known_.insert(name).second) parts_.history.add(logged_stream(name, flow));
  const sample_log::SampleId id{sample_log::stream_key(name), sample.source, sample.sequence};
  parts_.history.append({id, sample.sent_wall_ns, parts_.link.bytes_of(sample)}, now,
                        parts_.wall_ns(now));
}

}  // namespace tocsin
