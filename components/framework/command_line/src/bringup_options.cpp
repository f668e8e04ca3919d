// SPDX-License-Identifier: Apache-2.0
#include "command_line/bringup_options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "command_line/option_checks.hpp"
#include "command_line/programs.hpp"

namespace tocsin {

namespace fs = std::filesystem;

void BringupOptions::declare(CLI::App& app) {
  app.add_option("FILE", file, "bringup file; a bare name is also looked for in the share")
      ->required();
  app.add_option("--set", overrides.set, "parameter of a component: name.key=value")
      ->expected(1)
      ->take_all();
  app.add_option("--without", overrides.without,
                 "host/process, or host/process/component, that is left out")
      ->expected(1)
      ->take_all();
  app.add_option("--host", overrides.host,
                 "this host of the file alone, over a real link: the others run elsewhere");
  app.add_option("--seed", overrides.seed, "value of ${seed}; decides everything random")
      ->check(is_seed());
  app.add_option("--channel", overrides.channel,
                 "channel file of the radio, in place of the file's");
  app.add_option("--security", overrides.security,
                 "keystore of the link, in place of the file's; see tocsin keystore");
  app.add_option("--qos", overrides.qos, "QoS profiles, in place of the file's");
  app.add_option("--traffic", overrides.traffic, "traffic classes, in place of the file's");
  app.add_option("--domain", domain, "first of three DDS domain ids, in place of the file's")
      ->check(CLI::Range(0, 229));
}

void BringupOptions::locate() {
  overrides.share = share_folder(own_program()).string();
  if (domain) overrides.domain = domain;
  const fs::path shared = fs::path(overrides.share) / "bringup" / file;
  const bool bare = file.find('/') == std::string::npos;
  if (bare && !fs::exists(file) && fs::exists(shared)) file = shared.string();
}

std::vector<std::string> BringupOptions::arguments() const {
  std::vector<std::string> words{file, "--seed", std::to_string(overrides.seed)};
  const auto add = [&](const char* option, const std::string& value) {
    words.emplace_back(option);
    words.push_back(value);
  };
  for (const std::string& setting : overrides.set) add("--set", setting);
  for (const std::string& process : overrides.without) add("--without", process);
  if (!overrides.host.empty()) add("--host", overrides.host);
  if (!overrides.channel.empty()) add("--channel", overrides.channel);
  if (!overrides.security.empty()) add("--security", overrides.security);
  if (!overrides.qos.empty()) add("--qos", overrides.qos);
  if (!overrides.traffic.empty()) add("--traffic", overrides.traffic);
  if (domain) add("--domain", std::to_string(*domain));
  return words;
}

}  // namespace tocsin
