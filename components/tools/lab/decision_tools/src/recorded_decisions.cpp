// SPDX-License-Identifier: Apache-2.0
#include "recorded_decisions.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "decision/policy.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "recorded_run.hpp"

namespace tocsin::tools {
namespace {

using decision::Reason;

bool has_decisions(const CsvTable& table) {
  const auto columns = {"sequence",      "stamp.sec", "stamp.nanosec", "active", "reason",
                        "pause_samples", "qni"};
  return std::all_of(columns.begin(), columns.end(),
                     [&](const char* column) { return table.has(column); });
}

/// The numbers of a column, each of which counts something.
std::vector<double> counts(const CsvTable& table, const std::string& column) {
  constexpr double most = 1e9;
  std::vector<double> values = table.numbers(column);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= 0 && values[i] <= most && values[i] == std::floor(values[i])) continue;
    table.reject(i, column,
                 "'" + printable(table.texts(column)[i]) + "' is not a whole number in [0, 1e9]");
  }
  return values;
}

std::vector<Role> roles_in(const CsvTable& table) {
  const std::vector<std::string> words = table.texts("role");
  std::vector<Role> roles;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto role = role_of(words[i]);
    if (!role) table.reject(i, "role", "'" + printable(words[i]) + "' is not uxv or gcs");
    roles.push_back(*role);
  }
  return roles;
}

/// A row without a sample is a call at the deadline of a pause unless it counts as a sample of the
/// pause: Policy::on_deadline neither counts nor tells another reason.
bool is_at_deadline(const RecordedDecision& decision, double qni, int pause_samples_before) {
  if (!std::isnan(qni)) return false;
  if (decision.reason == to_string(Reason::steady)) return true;
  return decision.reason == to_string(Reason::forced_resume_time) &&
         decision.pause_samples == pause_samples_before;
}

/// Recordings of former versions have none.
decision::Outlook outlook_in(const CsvTable& table, std::size_t row) {
  decision::Outlook outlook;
  if (!table.has("outlook")) return outlook;
  const auto list = nlohmann::json::parse(table.text(row, "outlook"), nullptr, false);
  const bool is_list = list.is_array() && list.size() <= decision::Outlook::most;
  if (!is_list) table.reject(row, "outlook", "is no list of at most 61 percentages");
  for (const auto& one : list) {
    const bool is_percent = one.is_number_unsigned() && one.get<unsigned>() <= 100;
    if (!is_percent) table.reject(row, "outlook", "'" + one.dump() + "' is not in [0, 100]");
    outlook.risk_percent[outlook.size++] = one.get<std::uint8_t>();
  }
  return outlook;
}

}  // namespace

std::optional<Role> keep_one_role(CsvTable& table, std::optional<Role> wanted) {
  if (!table.has("role")) return std::nullopt;
  const std::vector<Role> roles = roles_in(table);
  const std::set<Role> known(roles.begin(), roles.end());
  const std::string list = joined_roles({known.begin(), known.end()});
  if (!wanted && known.size() > 1) {
    throw ConfigError(table.path() + ": has decisions of the roles " + list +
                      "; choose one by --host");
  }
  const Role role = wanted.value_or(*known.begin());
  if (known.count(role) == 0) {
    throw ConfigError(table.path() + ": has no row with role " + to_string(role) + ", only " +
                      list);
  }
  std::vector<bool> kept;
  kept.reserve(roles.size());
  for (const Role one : roles) kept.push_back(one == role);
  table.keep(kept);
  return role;
}

void drop_repeated_decisions(CsvTable& table) {
  if (!has_decisions(table)) return;
  const auto sequence = table.texts("sequence");
  const auto second = table.texts("stamp.sec");
  const auto fraction = table.texts("stamp.nanosec");
  std::vector<bool> kept(table.rows(), true);
  for (std::size_t i = 1; i < table.rows(); ++i) {
    kept[i] = sequence[i] != sequence[i - 1] || second[i] != second[i - 1] ||
              fraction[i] != fraction[i - 1];
  }
  table.keep(kept);
}

void read_decisions(const CsvTable& table, QualityTrace& trace) {
  if (!has_decisions(table)) return;
  const auto sequence = counts(table, "sequence");
  const auto active = counts(table, "active");
  const auto age = counts(table, "pause_samples");
  const auto reason = table.texts("reason");
  trace.began_s =
      table.numbers("stamp.sec").front() + table.numbers("stamp.nanosec").front() * 1e-9;
  double heard = 0;
  int age_before = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    RecordedDecision one;
    one.active = active[i] != 0;
    one.reason = reason[i];
    one.pause_samples = static_cast<int>(age[i]);
    one.outlook = outlook_in(table, i);
    one.restarted = i > 0 && sequence[i] <= heard;
    one.at_deadline = is_at_deadline(one, trace.qni[i], age_before);
    if (one.restarted) heard = 0;
    trace.unrecorded += static_cast<std::size_t>(std::max(sequence[i] - heard - 1, 0.0));
    heard = sequence[i];
    age_before = one.pause_samples;
    trace.recorded.push_back(std::move(one));
  }
}

}  // namespace tocsin::tools
