// SPDX-License-Identifier: Apache-2.0
#include "plot.hpp"

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "foundation/error.hpp"

namespace tocsin::tools {
namespace {

void check_folder(const std::string& prefix) {
  const auto folder = std::filesystem::path(prefix).parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder)) return;
  throw ConfigError("--plot: folder " + folder.string() + " does not exist");
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "\"";
}

void draw(const std::string& script, const std::string& prefix) {
  check_folder(prefix);
  std::signal(SIGPIPE, SIG_IGN);  // a missing gnuplot is told by its exit code
  std::FILE* pipe = ::popen("gnuplot - >/dev/null 2>&1", "w");
  if (pipe == nullptr) throw EnvironmentError("gnuplot cannot be started");
  std::string all = "set encoding utf8\n";
  for (const char* kind : {"png", "svg"}) {
    const bool png = std::string(kind) == "png";
    all += png ? "set terminal pngcairo noenhanced size 1200,700\n"
               : "set terminal svg noenhanced size 1200,700\n";
    all += "set output " + quoted(prefix + "." + kind) + "\n" + script + "\nunset output\nreset\n";
  }
  const bool sent = std::fwrite(all.data(), 1, all.size(), pipe) == all.size();
  if (::pclose(pipe) != 0 || !sent) {
    throw EnvironmentError("gnuplot failed; is gnuplot-nox installed and " + prefix +
                           ".png writable?");
  }
}

}  // namespace tocsin::tools
