// SPDX-License-Identifier: Apache-2.0
#include "deployment/run_folder.hpp"

#include <ctime>
#include <system_error>

#include "foundation/error.hpp"
#include "foundation/ownership.hpp"

namespace tocsin::deployment {
namespace {

namespace fs = std::filesystem;

void require(const std::error_code& error, const fs::path& folder) {
  if (error) throw EnvironmentError(folder.string() + ": cannot be made: " + error.message());
}

std::string utc_now() {
  char stamp[32];
  const std::time_t now = std::time(nullptr);
  std::strftime(stamp, sizeof stamp, "%Y%m%dT%H%M%SZ", std::gmtime(&now));
  return stamp;
}

/// A folder that was not there before: mkdir(2) gives it to one of those who ask at a time.
fs::path make_new(const fs::path& wanted) {
  fs::path folder = wanted;
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  require(error, folder.parent_path());
  for (int i = 2; !fs::create_directory(folder, error); ++i) {
    require(error, folder);
    folder = wanted.string() + "_" + std::to_string(i);
  }
  return folder;
}

}  // namespace

RunFolder::RunFolder(const std::string& wanted, const std::string& unnamed) {
  std::error_code error;
  const std::string named = wanted.empty() ? unnamed + utc_now() : wanted;
  path_ = fs::absolute(named, error).lexically_normal();
  require(error, named);
  if (wanted.empty()) {
    path_ = make_new(path_);
  } else {
    fs::create_directories(path_, error);
    require(error, path_);
  }
  if (const auto reason = changeable_by_others(path_)) {
    throw ConfigError("--run-dir " + path_.string() + ": " + *reason +
                      "; what a run keeps there decides what it does after a restart");
  }
  lock_.emplace(path_);
  const bool is_empty = fs::is_empty(path_, error);
  require(error, path_);
  if (!is_empty) {
    throw ConfigError("--run-dir " + path_.string() +
                      ": is not empty; a run folder belongs to one run");
  }
}

}  // namespace tocsin::deployment
