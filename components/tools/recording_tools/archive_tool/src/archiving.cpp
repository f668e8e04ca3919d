// SPDX-License-Identifier: Apache-2.0
#include "archiving.hpp"

#include "foundation/error.hpp"

namespace tocsin::archive {

std::string index_of(const Places& places) {
  if (!places.index.empty()) return places.index;
  if (!is_s3(places.store)) return places.store + "/index.sqlite";
  throw ConfigError("--index: a bucket needs an index beside it: postgresql://... or a file");
}

Round archive(const std::vector<std::string>& folders, ObjectStore& store, RecordingIndex& index) {
  Round round;
  for (const Recording& recording : closed_recordings(folders)) {
    if (index.has(recording.id)) {
      ++round.known;
      continue;
    }
    try {
      const Excerpt excerpt = excerpt_of(recording.path);
      store.put(object_of(recording), recording.path);
      index.add(recording, excerpt);
      ++round.added;
    } catch (const std::runtime_error& error) {
      round.problems.push_back(recording.path.string() + ": " + error.what());
    }
  }
  return round;
}

}  // namespace tocsin::archive
