// SPDX-License-Identifier: Apache-2.0
#include "engine/settings.hpp"

#include <link.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "command_line/programs.hpp"
#include "foundation/error.hpp"
#include "radio_channel/channel_files.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/middleware/component_library.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ConfigError(path + ": cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// FNV-1a over words of eight bytes.
void add_to_hash(const std::string& bytes, std::uint64_t& hash) {
  for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word = 0;
    bytes.copy(reinterpret_cast<char*>(&word), sizeof word, at);
    hash = (hash ^ word) * 1099511628211ULL;
  }
  hash = (hash ^ bytes.size()) * 1099511628211ULL;
}

bool is_of_the_system(const std::string& file) {
  for (const char* folder : {"/lib/", "/lib64/", "/usr/lib/", "/usr/local/lib/"}) {
    if (file.rfind(folder, 0) == 0) return true;
  }
  return false;
}

int add_object(dl_phdr_info* info, std::size_t, void* files) {
  const std::string name = info->dlpi_name;
  if (!fs::is_regular_file(name) || is_of_the_system(name)) return 0;
  static_cast<std::set<fs::path>*>(files)->insert(fs::canonical(name));
  return 0;
}

/// The program and every library that it has loaded, those of the components that the runs use
/// included; without the system's.
std::set<fs::path> binaries() {
  std::set<fs::path> files{own_program()};
  ::dl_iterate_phdr(add_object, &files);
  return files;
}

/// A text as a YAML block.
std::string block(const std::string& text, const std::string& indent) {
  std::istringstream lines(text);
  std::string result = "|\n";
  for (std::string line; std::getline(lines, line);) result += indent + line + "\n";
  return result;
}

void check_components(const deployment::Deployment& deployment) {
  for (const deployment::Host& host : deployment.hosts) {
    for (const deployment::Container& container : host.containers) {
      for (const deployment::ComponentInstance& one : container.components) {
        load_component(one.component).check(one.name, *one.parameters, deployment.sources);
      }
    }
  }
}

}  // namespace

std::string build_version() {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const fs::path& file : binaries()) add_to_hash(text_of(file), hash);
  char text[60];
  std::snprintf(text, sizeof text, "%s+%016llx", TOCSIN_VERSION,
                static_cast<unsigned long long>(hash));
  return text;
}

std::string settings_text(const Experiment& experiment, const std::vector<Run>& plan) {
  std::set<std::string> files;
  for (const Run& run : plan) {
    for (const std::string& file : radio::channel_sources(run.channel.file)) files.insert(file);
    files.insert(run.mission.file);
  }
  if (!experiment.fitted.empty()) files.insert(experiment.timing.fitted);
  std::string text = "# What these results rest on; the same settings give the same bytes.\n";
  text += "build: " + build_version() + "\n";
  text += "runs: " + std::to_string(plan.size()) + "\n";
  text += "experiment: " + block(text_of(experiment.file), "  ");
  text += "files:\n";
  for (const std::string& file : files) text += "  " + file + ": " + block(text_of(file), "    ");
  text += "seeds:  # of each mission and channel, run by run\n";
  std::set<std::string> told;
  for (const Run& run : plan) {
    const std::string key =
        run.mission.name + "." + run.channel.name + "." + std::to_string(run.index);
    if (told.insert(key).second) text += "  " + key + ": " + std::to_string(run.seed) + "\n";
  }
  return text;
}

void check_plan(const std::vector<Run>& plan, const Timing& timing, const std::string& share) {
  (void)load_component("experiment");
  std::set<std::string> checked;
  for (const Run& run : plan) {
    const std::string what = run.mission.name + ", " + run.channel.name + ", " + run.payload.name +
                             ", " + run.policy.name;
    if (!checked.insert(what).second) continue;
    try {
      check_components(deployment_of(run, timing, share, "/tmp"));
    } catch (const ConfigError& error) {
      throw ConfigError("run of (" + what + "): " + error.what());
    }
  }
}

}  // namespace tocsin::experiment
