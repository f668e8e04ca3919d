// SPDX-License-Identifier: Apache-2.0
#include "replacements.hpp"

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::deployment {
namespace {

[[noreturn]] void refuse(const Deployment& deployment, const std::string& what) {
  throw ConfigError(what + " (" + deployment.file + ")");
}

/// Puts the command line's channel in place of the file's.
void replace_channel(const std::string& channel, Deployment& deployment) {
  if (channel.empty()) return;
  if (!deployment.radio) refuse(deployment, "radio: is missing, so there is no channel to replace");
  deployment.radio->channel = std::filesystem::absolute(channel);
  if (!std::filesystem::exists(channel)) refuse(deployment, "channel: no file " + channel);
}

/// Puts the command line's keystore in place of the file's.
void replace_security(const std::string& folder, Deployment& deployment) {
  if (folder.empty()) return;
  deployment.security = std::filesystem::absolute(folder);
  if (!std::filesystem::is_directory(folder)) {
    refuse(deployment, "--security " + printable(folder) + ": is no folder");
  }
}

/// Puts a file of the command line in place of the bringup file's.
void replace_file_of(const char* option, const std::string& path, const Deployment& deployment,
                     std::string& kept) {
  if (path.empty()) return;
  kept = std::filesystem::absolute(path);
  if (!std::filesystem::is_regular_file(path)) {
    refuse(deployment, std::string(option) + " " + printable(path) + ": is no file");
  }
}

}  // namespace

void replace_files(const Overrides& overrides, Deployment& deployment) {
  replace_channel(overrides.channel, deployment);
  replace_security(overrides.security, deployment);
  replace_file_of("--qos", overrides.qos, deployment, deployment.qos);
  replace_file_of("--traffic", overrides.traffic, deployment, deployment.traffic);
}

}  // namespace tocsin::deployment
