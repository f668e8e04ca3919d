// SPDX-License-Identifier: Apache-2.0
#include "telemetry/text_file.hpp"

#include <fstream>
#include <iterator>

namespace tocsin::telemetry {

std::optional<std::string> read_text(const std::string& path) {
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  // A folder opens, and a sensor that fails gives an error when it is read.
  if (!file.is_open() || file.bad() || text.empty()) return std::nullopt;
  return text;
}

}  // namespace tocsin::telemetry
