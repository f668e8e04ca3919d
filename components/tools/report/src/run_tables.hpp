// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "csv_tables/bag_tables.hpp"
#include "foundation/csv_table.hpp"
#include "foundation/role.hpp"

namespace tocsin::report {

/// The tables of a run's recorders, of the bags of each side.
class RunTables {
 public:
  explicit RunTables(std::string folder) : folder_(std::move(folder)) {}

  /// Empty when there is no recording of that side.
  [[nodiscard]] CsvTable messages(Role role) { return CsvTable(bags_of(role).messages()); }
  /// The fields of a topic; empty when there are none.
  [[nodiscard]] CsvTable of(Role role, const std::string& topic) {
    return CsvTable(bags_of(role).of(topic));
  }

 private:
  const BagTables& bags_of(Role role);

  const std::string folder_;
  std::map<Role, std::optional<BagTables>> bags_;
};

}  // namespace tocsin::report
