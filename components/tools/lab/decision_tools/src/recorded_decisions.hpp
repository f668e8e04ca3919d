// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/csv_table.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {

/// Leaves the rows of one role in a recorded transmission_state.csv and says which one. Without
/// `wanted` there must be only one. Empty when the table has no column `role`.
/// Throws ConfigError naming the roles that are there.
std::optional<Role> keep_one_role(CsvTable& table, std::optional<Role> wanted);

/// Leaves each decision once: a recorder that was started again gets the last one again.
void drop_repeated_decisions(CsvTable& table);

/// Adds what was decided to a trace whose rows are those of `table`. Does nothing when the table
/// has no decisions. Throws ConfigError naming file, line and value.
void read_decisions(const CsvTable& table, QualityTrace& trace);

}  // namespace tocsin::tools
