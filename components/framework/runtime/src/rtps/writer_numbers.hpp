// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "foundation/time.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// The numbers of the samples that come over a plain link, by their writers.
///
/// A best-effort reader of Fast DDS takes no sample whose number is not above all that it has taken
/// from this writer (StatelessReader::thereIsUpperRecordOf), so that one sample with a forged
/// number mutes the writer for good. Two samples with ascending numbers 0.3 s or more apart, and
/// none above the highest between them, tell that this has happened: packets that overtook each
/// other are not that far apart. The reader must be made anew. Any thread.
class WriterNumbers {
 public:
  using Guid = eprosima::fastdds::rtps::GUID_t;
  static constexpr Duration contradicts_after = std::chrono::milliseconds(300);
  /// Beyond them all are forgotten.
  static constexpr std::size_t most_writers = 4096;

  /// `wake` is called when a writer is muted, in the thread that sees the packet, without a lock
  /// held.
  explicit WriterNumbers(std::function<void()> wake) : wake_(std::move(wake)) {}

  /// A packet that the participant is shown.
  void see(const std::uint8_t* packet, std::size_t size, Time now);
  /// A sample of a writer. Whether readers that have seen the samples before do not take it, and
  /// what follows.
  [[nodiscard]] bool is_muted(const Guid& writer, std::uint64_t number, Time now);
  /// Those of the packets that were seen since one looked last.
  [[nodiscard]] std::set<Guid> take_muted();

 private:
  struct Numbers {
    std::uint64_t highest = 0;
    std::uint64_t lower = 0;  ///< the first that contradicts it; 0: none does
    Time since{};
  };
  void tell(const Guid& writer);
  const std::function<void()> wake_;
  std::mutex mutex_;
  std::map<Guid, Numbers> writers_;
  std::set<Guid> muted_;
};

}  // namespace tocsin
