// SPDX-License-Identifier: Apache-2.0
#include "run_tables.hpp"

namespace tocsin::report {

const BagTables& RunTables::bags_of(Role role) {
  auto& bags = bags_[role];
  if (!bags) bags.emplace(recorded_bags(folder_ + "/" + to_string(role)));
  return *bags;
}

}  // namespace tocsin::report
