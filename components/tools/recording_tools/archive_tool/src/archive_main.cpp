// SPDX-License-Identifier: Apache-2.0
// tocsin archive sync | list | get | link: recordings in a folder or a bucket, and an index of
// them that people ask.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "archiving.hpp"
#include "command_line/command.hpp"
#include "command_line/said_time.hpp"
#include "command_line/stop_signal.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/replace_file.hpp"
#include "foundation/ros_names.hpp"

namespace tocsin::archive {
namespace {

namespace fs = std::filesystem;

struct Options {
  Places places;
  std::vector<std::string> folders{"runs"};
  double follow_s = 0;
  std::string vehicle;
  std::string topic;
  std::string from = "-604800";
  std::string to = "0";
  std::string object;
  std::string output;
};

void declare_places(CLI::App& app, Options& options) {
  app.add_option(
      "--index", options.places.index,
      "postgresql://USER@HOST/DATABASE, or a file of SQLite [index.sqlite of --archive]");
  app.add_option("--archive", options.places.store,
                 "folder, or s3://BUCKET/PREFIX with AWS_ENDPOINT_URL, AWS_REGION, "
                 "AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY in the environment [archive]");
}

void declare_query(CLI::App& app, Options& options) {
  app.add_option("--vehicle", options.vehicle, "of this one alone");
  app.add_option("--from", options.from,
                 "[s] since 1970, or 0 and below: so long before now [-604800, a week]");
  app.add_option("--to", options.to, "[s] the same [0]");
}

void declare(CLI::App& app, Options& options) {
  app.require_subcommand(1);
  CLI::App* const sync =
      app.add_subcommand("sync", "brings recordings that are closed into the archive");
  sync->add_option("folders", options.folders, "folders of runs or bags [runs]");
  sync->add_option("--follow", options.follow_s, "[s] again and again, so often; else once")
      ->check(CLI::Range(0.1, 86400.0));
  CLI::App* const list = app.add_subcommand("list", "what is in the archive");
  list->add_option("--topic", options.topic, "with messages of this topic");
  CLI::App* const link = app.add_subcommand(
      "link", "the link's readings by place, as tocsin map link reads them (CSV)");
  link->add_option("-o,--output", options.output, "file [standard output]");
  CLI::App* const get = app.add_subcommand("get", "a recording of the archive");
  get->add_option("object", options.object, "as list names it")->required();
  get->add_option("-o,--output", options.output, "new file [its last name]");
  for (CLI::App* const sub : {sync, list, link, get}) declare_places(*sub, options);
  for (CLI::App* const sub : {list, link}) declare_query(*sub, options);
}

std::int64_t wall_ns() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

IndexQuery query_of(const Options& options) {
  const std::int64_t now_ns = wall_ns();
  IndexQuery query;
  query.vehicle = options.vehicle;
  query.topic =
      options.topic.empty() || options.topic.front() == '/' ? options.topic : "/" + options.topic;
  query.from_ns = time_of("--from", options.from, now_ns);
  query.to_ns = time_of("--to", options.to, now_ns);
  if (query.from_ns > query.to_ns) throw ConfigError("--from: is not before --to");
  return query;
}

RecordingIndex open_index(const Options& options, bool may_make) {
  const std::string where = index_of(options.places);
  if (!is_postgresql(where)) {
    if (!may_make && !fs::exists(where)) throw EnvironmentError(where + ": there is no index");
    const fs::path folder = fs::path(where).parent_path();
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
  }
  return RecordingIndex(open_database(where));
}

/// One round; an engine that is out is a problem like others.
Round round_of(const Options& options, ObjectStore& store) {
  try {
    RecordingIndex index = open_index(options, true);
    return archive(options.folders, store, index);
  } catch (const EnvironmentError& error) {
    return {0, 0, {error.what()}};
  }
}

void tell(const Round& round, const std::vector<std::string>& before) {
  if (round.added > 0) std::printf("%zu recordings added\n", round.added);
  std::fflush(stdout);
  for (const std::string& problem : round.problems) {
    if (std::find(before.begin(), before.end(), problem) != before.end()) continue;
    std::fprintf(stderr, "tocsin archive: %s\n", error_line(problem).c_str());
  }
}

int sync(const Options& options) {
  const auto store = open_store(options.places.store, s3_access_of_environment());
  (void)index_of(options.places);
  catch_stop_signals();
  std::vector<std::string> problems;
  for (;;) {
    const Round round = round_of(options, *store);
    tell(round, problems);
    problems = round.problems;
    if (options.follow_s <= 0) {
      if (round.added == 0 && problems.empty())
        std::printf("nothing new; %zu were there\n", round.known);
      return problems.empty() ? 0 : 1;
    }
    sleep_until_stopped(std::chrono::steady_clock::now() + seconds(options.follow_s));
    if (is_stopped()) return problems.empty() ? 0 : 1;
  }
}

/// 2026-11-29 16:45:00, UTC.
std::string utc(std::int64_t ns) {
  return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::gmtime(std::time_t{ns / 1'000'000'000}));
}

int list(const Options& options) {
  const IndexQuery query = query_of(options);
  const auto files = open_index(options, false).files(query);
  if (files.empty()) std::printf("Nothing of that is in the archive\n");
  for (const IndexedFile& one : files) {
    fmt::print("{}  {} UTC  {:7.1f} s  {:8.2f} MB  {:8} messages  {:5} missing\n", one.object,
               utc(one.from_ns), static_cast<double>(one.to_ns - one.from_ns) / 1e9,
               static_cast<double>(one.bytes) / 1e6, one.messages, one.gaps);
  }
  return 0;
}

int link(const Options& options) {
  const IndexQuery query = query_of(options);
  std::string text = "time_s,x_m,y_m,signal_dbm,loss_percent,qni,battery_percent\n";
  for (const Reading& one : open_index(options, false).readings(query)) {
    text += fmt::format("{:.3f}", static_cast<double>(one.time_ns) / 1e9);
    for (const double value :
         {one.x_m, one.y_m, one.signal_dbm, one.loss_percent, one.qni, one.battery_percent}) {
      text += std::isnan(value) ? "," : fmt::format(",{:.6g}", value);
    }
    text += "\n";
  }
  if (options.output.empty()) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return 0;
    throw EnvironmentError("standard output cannot be written");
  }
  const std::error_code failed = replace_file(options.output, text, Sync::no);
  if (failed) throw EnvironmentError(options.output + ": " + failed.message());
  return 0;
}

int get(const Options& options) {
  const auto store = open_store(options.places.store, s3_access_of_environment());
  const fs::path to =
      options.output.empty() ? fs::path(options.object).filename() : fs::path(options.output);
  if (fs::exists(to)) throw ConfigError(to.string() + ": is there already");
  store->get(options.object, to);
  std::printf("%s\n", printable(to.string()).c_str());
  return 0;
}

}  // namespace
}  // namespace tocsin::archive

int main(int argc, char** argv) {
  tocsin::archive::Options options;
  CLI::App app("Recordings in a folder or a bucket, and an index of them that people ask by SQL.");
  app.name("tocsin archive");
  tocsin::archive::declare(app, options);
  return tocsin::run_command(app, argc, argv, [&] {
    if (app.got_subcommand("sync")) return tocsin::archive::sync(options);
    if (app.got_subcommand("list")) return tocsin::archive::list(options);
    if (app.got_subcommand("link")) return tocsin::archive::link(options);
    return tocsin::archive::get(options);
  });
}
