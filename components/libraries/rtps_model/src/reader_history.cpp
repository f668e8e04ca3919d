// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/reader_history.hpp"

#include <algorithm>

namespace tocsin::rtps {

ReaderHistory::Entries::iterator ReaderHistory::find(const Key& key) {
  return std::find_if(entries_.begin(), entries_.end(), [&key](const Entry& one) {
    return one.writer == key.writer && one.sample->sequence == key.sequence;
  });
}

ReaderHistory::Entries::const_iterator ReaderHistory::find(const Key& key) const {
  return const_cast<ReaderHistory*>(this)->find(key);
}

bool ReaderHistory::has(const Key& key) const { return find(key) != entries_.end(); }

bool ReaderHistory::is_whole(const Key& key) const {
  const auto found = find(key);
  return found != entries_.end() && found->lacking == 0;
}

bool ReaderHistory::has_room(std::size_t missing) const {
  return missing == 0 || entries_.size() + missing < settings_.room;
}

ReaderHistory::Added ReaderHistory::add(EndId writer, const Data& data, std::size_t missing) {
  if (!has_room(missing)) return {Taken::rejected, {}};
  Added added{Taken::kept, {}};
  if (!settings_.keep_all && entries_.size() >= settings_.depth) {
    const Entry& oldest = entries_.front();
    if (data.sample->written < oldest.sample->written) return {Taken::too_old, {}};
    if (oldest.lacking > 0) added.dropped.push_back({oldest.writer, oldest.sample->sequence});
    entries_.pop_front();
  }
  if (entries_.size() >= settings_.room) return {Taken::rejected, std::move(added.dropped)};
  insert(writer, data);
  return added;
}

void ReaderHistory::insert(EndId writer, const Data& data) {
  const auto comes_before = [&](const Entry& one) {
    return one.writer == writer ? data.sample->sequence < one.sample->sequence
                                : data.sample->written < one.sample->written;
  };
  const auto place = std::find_if(entries_.begin(), entries_.end(), comes_before);
  Entry& entry = *entries_.insert(place, {writer, data.sample, {}, 0});
  if (data.fragment == 0) return;
  entry.lacks.assign(data.sample->fragments(), true);
  entry.lacks[data.fragment - 1] = false;
  entry.lacking = entry.lacks.size() - 1;
}

bool ReaderHistory::add_piece(EndId writer, const Data& data) {
  const auto entry = find({writer, data.sample->sequence});
  if (entry->lacks[data.fragment - 1]) {
    entry->lacks[data.fragment - 1] = false;
    --entry->lacking;
  }
  return entry->lacking == 0;
}

std::vector<Fragment> ReaderHistory::missing_pieces(const Key& key) const {
  std::vector<Fragment> all;
  const auto entry = find(key);
  if (entry == entries_.end()) return all;
  for (std::size_t i = 0; i < entry->lacks.size(); ++i) {
    if (!entry->lacks[i]) continue;
    const auto fragment = static_cast<Fragment>(i + 1);
    if (!all.empty() && fragment - all.front() >= wire::longest_list) break;
    all.push_back(fragment);
  }
  return all;
}

void ReaderHistory::drop_pieces_before(EndId writer, Sequence first) {
  entries_.remove_if([&](const Entry& one) {
    return one.writer == writer && one.sample->sequence < first && one.lacking > 0;
  });
}

void ReaderHistory::drop_pieces_of(const Key& key) {
  const auto entry = find(key);
  if (entry != entries_.end() && entry->lacking > 0) entries_.erase(entry);
}

std::vector<SamplePtr> ReaderHistory::take(EndId writer, Sequence last) {
  std::vector<SamplePtr> taken;
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    if (entry->writer == writer && entry->sample->sequence <= last && entry->lacking == 0) {
      taken.push_back(entry->sample);
      entry = entries_.erase(entry);
    } else {
      ++entry;
    }
  }
  return taken;
}

void ReaderHistory::forget(EndId writer) {
  entries_.remove_if([writer](const Entry& one) { return one.writer == writer; });
}

}  // namespace tocsin::rtps
