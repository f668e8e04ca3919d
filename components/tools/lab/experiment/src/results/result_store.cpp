// SPDX-License-Identifier: Apache-2.0
#include "results/result_store.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/replace_file.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

constexpr const char* draft_ending = ".new";  // of replace_file

std::optional<std::string> read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

constexpr const char* build_key = "build: ";
constexpr const char* earlier_key = "earlier_builds: ";

/// A settings text without its lines of builds; and what those say.
struct Builds {
  std::string rest;
  std::string build;
  std::string earlier;  ///< separated by ", "
};

Builds builds_of(const std::string& settings) {
  const auto value = [](const std::string& line) { return line.substr(line.find(' ') + 1); };
  Builds result;
  std::istringstream lines(settings);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(build_key, 0) == 0) {
      result.build = value(line);
    } else if (line.rfind(earlier_key, 0) == 0) {
      result.earlier = value(line).substr(1);
      result.earlier.pop_back();
    } else {
      result.rest += line + "\n";
    }
  }
  return result;
}

/// The settings of this build, and a line that names those before it.
std::string with_earlier(const std::string& settings, const Builds& before) {
  std::string text = settings;
  const std::string more = before.earlier.empty() ? "" : ", " + before.earlier;
  const std::size_t line = text.find(build_key);
  text.insert(text.find('\n', line) + 1, earlier_key + ("[" + before.build + more) + "]\n");
  return text;
}

std::string head() {
  std::string text = "number,set,mission,channel,payload,policy,index,seed,failure,seconds";
  for (const char* metric : words_of(Metric{})) text += std::string(",") + metric;
  return text + "\n";
}

std::string row(const Run& run, const RunResult& result) {
  std::ostringstream text;
  text << run.number << ',' << run.set << ',' << run.mission.name << ',' << run.channel.name << ','
       << run.payload.name << ',' << run.policy.name << ',' << run.index << ',' << run.seed << ','
       << csv_cell(result.failure) << ',' << result.simulated_s;
  for (std::size_t i = 0; i < metric_count; ++i) {
    text << ',';
    if (i < result.measures.values.size() && !std::isnan(result.measures.values[i])) {
      text << result.measures.values[i];
    }
  }
  text << '\n';
  return text.str();
}

}  // namespace

void write_whole(const std::string& path, const std::string& text) {
  // A run that a loss of power took is played again.
  if (const auto error = replace_file(path, text, Sync::no)) throw std::system_error(error, path);
}

ResultStore::ResultStore(std::string folder, std::string kind)
    : folder_(std::move(folder)), kind_(std::move(kind)) {}

std::string ResultStore::path(const Run& run) const {
  return folder_ + "/" + kind_ + "/" + run.id() + ".csv";
}

std::string ResultStore::table_path() const {
  return folder_ + (kind_ == "series" ? "/runs.csv" : "/" + kind_ + ".csv");
}

/// What settings.yaml becomes when an experiment goes on.
std::string ResultStore::merged(const std::string& old, const std::string& settings,
                                bool other_build) const {
  const Builds before = builds_of(old);
  const Builds now = builds_of(settings);
  if (before.rest != now.rest) {
    throw ConfigError(folder_ +
                      ": holds an experiment with other settings (file, channels, missions or "
                      "fitted parameters); give another --out, or remove it");
  }
  if (before.build == now.build) return old;
  if (other_build) return with_earlier(settings, before);
  throw ConfigError(folder_ +
                    ": was begun by another build of the programs, with which the same "
                    "seed may give other results; --other-build goes on all the same, --out begins "
                    "elsewhere");
}

void ResultStore::open(const std::string& settings, bool other_build) const {
  std::error_code error;
  fs::create_directories(folder_ + "/" + kind_, error);
  if (error) throw EnvironmentError(folder_ + ": cannot be made: " + error.message());
  const std::string file = folder_ + "/settings.yaml";
  const auto old = read_file(file);
  if (old) remove_drafts();
  const std::string fresh = old ? merged(*old, settings, other_build) : settings;
  if (old == fresh) return;
  try {
    write_whole(file, fresh);
  } catch (const std::system_error& failed) {
    throw EnvironmentError(std::string("cannot be written: ") + failed.what());
  }
}

void ResultStore::remove_drafts() const {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ + "/" + kind_, error)) {
    if (entry.path().extension() == draft_ending) fs::remove(entry.path(), error);
  }
}

std::optional<RunResult> ResultStore::read(const Run& run) const {
  const auto text = read_file(path(run));
  return text ? parse_result(*text) : std::nullopt;
}

void ResultStore::write(const Run& run, const RunResult& result) const {
  write_whole(path(run), to_text(result));
}

void ResultStore::write_table(const std::vector<Run>& plan) const {
  std::string text = head();
  for (const Run& run : plan) {
    if (const auto result = read(run)) text += row(run, *result);
  }
  write_whole(table_path(), text);
}

}  // namespace tocsin::experiment
