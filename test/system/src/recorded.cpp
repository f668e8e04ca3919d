// SPDX-License-Identifier: Apache-2.0
#include "recorded.hpp"

#include "csv_tables/bag_tables.hpp"
#include "foundation/error.hpp"

namespace tocsin {

std::string recorded_fields(const std::string& folder, const std::string& topic) {
  try {
    return BagTables(recorded_bags(folder),
                     [&topic](const std::string& one) { return one == topic; })
        .of(topic);
  } catch (const ConfigError&) {
    return {};  // it is being made
  }
}

std::string recorded_messages(const std::string& folder) {
  try {
    return BagTables(recorded_bags(folder)).messages();
  } catch (const ConfigError&) {
    return {};
  }
}

}  // namespace tocsin
