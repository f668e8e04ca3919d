// SPDX-License-Identifier: Apache-2.0
#include "plot.hpp"

#include <filesystem>

#include "foundation/error.hpp"
#include "report/draw.hpp"

namespace tocsin::tools {
namespace {

void check_folder(const std::string& prefix) {
  const auto folder = std::filesystem::path(prefix).parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder)) return;
  throw ConfigError("--plot: folder " + folder.string() + " does not exist");
}

}  // namespace

void draw(const nlohmann::json& picture, const std::string& prefix) {
  check_folder(prefix);
  report::draw(picture.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), prefix);
}

}  // namespace tocsin::tools
