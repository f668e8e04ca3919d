// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace tocsin {

/// Who writes which instances of a topic. Pure.
class InstanceTable {
 public:
  /// `source` has written `instance`, which lives from then on.
  void on_sample(std::uint64_t source, std::uint64_t instance) {
    writers_[instance].insert(source);
  }
  /// The instance is no more, whoever wrote it. False: it was not known to live.
  bool on_disposed(std::uint64_t instance) { return writers_.erase(instance) > 0; }
  /// `source` does not write the instance any more. True: nobody does.
  bool on_unregistered(std::uint64_t source, std::uint64_t instance);
  /// `source` is gone. The instances that nobody writes any more.
  [[nodiscard]] std::vector<std::uint64_t> on_writer_gone(std::uint64_t source);

 private:
  std::map<std::uint64_t, std::set<std::uint64_t>> writers_;  ///< of each instance that lives
};

}  // namespace tocsin
