// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <utility>

#include "link_router/transmission.hpp"

namespace tocsin::router {

/// The samples that came compressed lately, which later ones are based on: of each source as many
/// as a base may lie back, with as many more for repairs, and in all at most `most_bytes`; then
/// those that came first go. Pure.
class CompressedSamples {
 public:
  static constexpr std::size_t most_bytes = 4'000'000;  ///< [B]

  /// `stream` is any number that tells the streams of all peers apart. One that is too large to be
  /// a base is not kept.
  void add(std::uint64_t stream, const Sample& plain);
  /// Null when it is not here.
  [[nodiscard]] const Sample* find(std::uint64_t stream, SourceId source,
                                   std::uint64_t sequence) const;
  void forget(std::uint64_t stream);
  /// [B]
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  using Source = std::pair<std::uint64_t, SourceId>;
  using Arrivals = std::list<std::pair<Source, std::uint64_t>>;
  struct Kept {
    Sample sample;
    Arrivals::iterator arrival;
  };
  using Samples = std::map<std::uint64_t, Kept>;  ///< by sequence number
  void erase(const Source& source, std::uint64_t sequence);

  std::map<Source, Samples> sources_;
  Arrivals arrivals_;  ///< the first one first
  std::size_t bytes_ = 0;
};

}  // namespace tocsin::router
