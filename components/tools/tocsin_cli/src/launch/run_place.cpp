// SPDX-License-Identifier: Apache-2.0
#include "run_place.hpp"

#include <cstdlib>
#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/free_space.hpp"

namespace tocsin::cli {
namespace {

using deployment::RunFolder;

/// Throws EnvironmentError where it cannot be made, or nothing fits into it.
RunFolder make_with_room(const std::string& unnamed) {
  RunFolder folder("", unnamed);
  if (free_bytes(folder.path()).value_or(full_below_bytes) >= full_below_bytes) return folder;
  std::error_code ignored;
  std::filesystem::remove(folder.path(), ignored);
  throw EnvironmentError(folder.path().string() + ": its disk is full");
}

}  // namespace

RunPlace run_place() {
  const char* const given = std::getenv("RUNTIME_DIRECTORY");
  const std::string folders = given == nullptr ? "" : given;
  RunPlace place;
  if (!folders.empty()) place.spare = folders.substr(0, folders.find(':')) + "/";
  return place;
}

ChosenRunFolder choose_run_folder(const std::string& wanted, const RunPlace& place) {
  if (!wanted.empty() || place.spare.empty()) return {RunFolder(wanted, place.unnamed), ""};
  try {
    return {make_with_room(place.unnamed), ""};
  } catch (const EnvironmentError& error) {
    RunFolder folder("", place.spare);
    return {std::move(folder), std::string("NO DISK: ") + error.what() +
                                   "; this run keeps its files in " + place.spare +
                                   ", and they end with it"};
  }
}

}  // namespace tocsin::cli
