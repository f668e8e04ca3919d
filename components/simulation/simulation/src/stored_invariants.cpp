// SPDX-License-Identifier: Apache-2.0
// What holds for stored topics.
#include <filesystem>
#include <set>
#include <utility>

#include "core.hpp"
#include "sample_log/sample_log.hpp"
#include "simulation/invariants.hpp"

namespace tocsin::simulation {
namespace {

/// Writer and sequence of all that logs in a folder still have.
std::set<std::pair<std::uint64_t, std::uint64_t>> waiting_in(const std::string& run_dir) {
  std::set<std::pair<std::uint64_t, std::uint64_t>> waiting;
  for (const Role role : roles) {
    const std::string folder = run_dir + "/" + to_string(role) + "/store";
    if (!std::filesystem::is_directory(folder)) continue;
    sample_log::FolderFiles files(folder);
    const sample_log::SampleLog log(files, {}, Instant{start_time, Core::wall_ns(start_time)});
    for (const auto& id : log.waiting()) waiting.emplace(id.source, id.sequence);
  }
  return waiting;
}

}  // namespace

Invariants::StoredEnd& Invariants::stored(const TopicEnd& end) {
  StoredEnd& found = stored_[&end];
  if (found.name.empty()) found.name = end.host + "/" + end.process + " " + end.topic + " ";
  return found;
}

void Invariants::on_logged(const LoggedSample& logged) {
  if (!logged.from.stored) return;  // it crosses when it is asked for
  StoredEnd& end = stored(logged.from);
  if (!end.given.contains(logged.written)) end.missing[logged.written] = logged.source;
}

void Invariants::on_given(const GivenSample& given) {
  if (!given.from.stored) return;
  StoredEnd& end = stored(given.from);
  end.missing.erase(given.written);
  const bool is_new = end.given.insert(given.written);
  const std::string what = end.name + std::to_string(given.written);
  if (given.as == GivenAs::live) {
    return expect(is_new || given.from.durable, given.time, "a stored sample was given twice, live",
                  what);
  }
  expect(is_new, given.time, "a stored sample was given twice", what);
  expect(given.written > end.last_backfilled, given.time, "backfilled out of order", what);
  end.last_backfilled = given.written;
}

void Invariants::on_logs(const std::string& run_dir, const Outcome& outcome) {
  const auto waiting = waiting_in(run_dir);
  for (const auto& entry : stored_) {
    for (const auto& [written, source] : entry.second.missing) {
      expect(waiting.count({source, written}) != 0, start_time + outcome.simulated,
             "a stored sample is lost", entry.second.name + std::to_string(written));
    }
  }
}

}  // namespace tocsin::simulation
