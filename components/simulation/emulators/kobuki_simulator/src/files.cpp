// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"

namespace tocsin::kobuki {

std::string load_text(const std::string& path) {
  std::ifstream in(path);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw ConfigError(path + ": cannot be read");
  return text;
}

std::optional<BaseMemory> load_memory(const std::string& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  BaseMemory m;
  in >> m.pose.x_m >> m.pose.y_m >> m.pose.heading_rad >> m.left_ticks >> m.right_ticks >>
      m.gyro_rad >> m.clock_s >> m.charge;
  if (!in) throw ConfigError(path + ": is not a state of the simulator; remove it");
  return m;
}

bool save_memory(const std::string& path, const BaseMemory& m) {
  std::ostringstream out;
  out.precision(17);
  out << m.pose.x_m << ' ' << m.pose.y_m << ' ' << m.pose.heading_rad << ' ' << m.left_ticks << ' '
      << m.right_ticks << ' ' << m.gyro_rad << ' ' << m.clock_s << ' ' << m.charge << '\n';
  return !replace_file(path, out.str(), Sync::no);
}

}  // namespace tocsin::kobuki
