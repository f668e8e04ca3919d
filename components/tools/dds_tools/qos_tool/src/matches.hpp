// SPDX-License-Identifier: Apache-2.0
// Whether a writer and a reader match, policy by policy.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "runtime/middleware/host_graph.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::qos_tool {

/// Who is to be matched: an end of a running system, or a profile as its writers or readers.
struct End {
  std::string name;  ///< as a person reads it
  std::string type;  ///< on the wire; empty: any
  QosContract qos;
};

/// A writer beside a reader.
struct Pair {
  End writer;
  End reader;

  /// What stops it: policies of the specification's table, or `type`.
  [[nodiscard]] std::vector<std::string> stopped_by() const;
  /// The specification and Fast DDS 2.9.1 decide it in different ways.
  [[nodiscard]] bool fast_dds_departs() const;
};

/// The profile as its writers offer it, and as its readers request it.
[[nodiscard]] End writer_of(const std::string& name, const QosProfile& profile);
[[nodiscard]] End reader_of(const std::string& name, const QosProfile& profile);

/// The ends of a topic that write or read. `topic` is the name on the wire.
[[nodiscard]] std::vector<End> ends_of(const std::vector<GraphEnd>& ends, const std::string& topic,
                                       bool writers);

/// Each writer beside each reader.
[[nodiscard]] std::vector<Pair> pairs_of(const std::vector<End>& writers,
                                         const std::vector<End>& readers);

/// A page for each pair: with `all` every policy, else those that stop it.
[[nodiscard]] std::string match_text(const std::vector<Pair>& pairs, bool all);
[[nodiscard]] nlohmann::json match_json(const std::vector<Pair>& pairs);

}  // namespace tocsin::qos_tool
