// SPDX-License-Identifier: Apache-2.0
#include "runtime/detail/instance_table.hpp"

namespace tocsin {

bool InstanceTable::on_unregistered(std::uint64_t source, std::uint64_t instance) {
  const auto found = writers_.find(instance);
  if (found == writers_.end() || found->second.erase(source) == 0) return false;
  if (!found->second.empty()) return false;
  writers_.erase(found);
  return true;
}

std::vector<std::uint64_t> InstanceTable::on_writer_gone(std::uint64_t source) {
  std::vector<std::uint64_t> orphans;
  for (auto it = writers_.begin(); it != writers_.end();) {
    const bool was_writer = it->second.erase(source) > 0;
    if (was_writer && it->second.empty()) {
      orphans.push_back(it->first);
      it = writers_.erase(it);
    } else {
      ++it;
    }
  }
  return orphans;
}

}  // namespace tocsin
