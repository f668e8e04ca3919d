// SPDX-License-Identifier: Apache-2.0
#include "run_tables.hpp"

#include <filesystem>

namespace tocsin::report {

const BagTables* RunTables::bags_of(Role role) {
  const auto [found, is_new] = bags_.try_emplace(role);
  if (is_new && !std::filesystem::exists(side(role) + "/" + messages_file)) {
    const auto bags = recorded_bags(side(role));
    if (!bags.empty()) found->second.emplace(bags);
  }
  return found->second ? &*found->second : nullptr;
}

CsvTable RunTables::messages(Role role) {
  const BagTables* const bags = bags_of(role);
  return bags == nullptr ? CsvTable::read(side(role) + "/" + messages_file)
                         : CsvTable(bags->messages());
}

CsvTable RunTables::of(Role role, const std::string& topic) {
  const BagTables* const bags = bags_of(role);
  return bags == nullptr ? CsvTable::read(side(role) + "/" + table_file(topic))
                         : CsvTable(bags->of(topic));
}

}  // namespace tocsin::report
