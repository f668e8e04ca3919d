// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <vector>

#include "rtps_model/message.hpp"

namespace tocsin::rtps {

/// QoS of a reliable reader.
struct ReaderSettings {
  bool keep_all = false;  ///< else the oldest sample makes room for a newer one
  std::size_t depth = 1;  ///< samples of keep_last
  std::size_t room = 2;   ///< max_samples
  Duration heartbeat_response_delay{0};
  Duration initial_acknack_delay = std::chrono::milliseconds(70);
};

/// What a reliable reader holds until the component may have it: whole samples behind a missing one
/// and samples of which pieces have come (Fast DDS: DataReaderHistory, topic without key). What a
/// component may have it takes at once.
class ReaderHistory {
 public:
  explicit ReaderHistory(const ReaderSettings& settings) : settings_(settings) {}

  /// A sample of one writer.
  struct Key {
    EndId writer;
    Sequence sequence;
  };
  /// What became of a sample that came.
  enum class Taken : std::uint8_t {
    kept,
    too_old,   ///< older than all that are kept: never wanted again
    rejected,  ///< no room beside those that are missing: wanted again
  };
  /// Of `add`. A sample of which pieces were missing may have made room.
  struct Added {
    Taken taken;
    std::vector<Key> dropped;  ///< samples that had not come whole: never wanted again
  };

  [[nodiscard]] bool has(const Key& key) const;
  [[nodiscard]] bool is_whole(const Key& key) const;
  /// A whole sample, or the first piece of one to come; `missing` are lacking before it.
  [[nodiscard]] Added add(EndId writer, const Data& data, std::size_t missing);
  /// Another piece. True when the sample is whole with it.
  [[nodiscard]] bool add_piece(EndId writer, const Data& data);
  /// The pieces that are missing of a sample, in rising order, within a list's length.
  [[nodiscard]] std::vector<Fragment> missing_pieces(const Key& key) const;
  /// Removes samples of the writer before `first` that have not come whole.
  void drop_pieces_before(EndId writer, Sequence first);
  void drop_pieces_of(const Key& key);
  /// Takes out the whole samples of the writer up to `last`, in order.
  [[nodiscard]] std::vector<SamplePtr> take(EndId writer, Sequence last);
  void forget(EndId writer);

 private:
  struct Entry {
    EndId writer;
    SamplePtr sample;
    std::vector<bool> lacks;  ///< of each fragment
    std::size_t lacking = 0;
  };
  using Entries = std::list<Entry>;
  [[nodiscard]] Entries::iterator find(const Key& key);
  [[nodiscard]] Entries::const_iterator find(const Key& key) const;
  [[nodiscard]] bool has_room(std::size_t missing) const;
  void insert(EndId writer, const Data& data);
  ReaderSettings settings_;
  Entries entries_;  ///< by time of writing; those of one writer by sequence
};

}  // namespace tocsin::rtps
