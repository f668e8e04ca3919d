// SPDX-License-Identifier: Apache-2.0
#include "qos_options.hpp"

#include <CLI/CLI.hpp>

#include "command_line/command.hpp"
#include "qos_verbs.hpp"

namespace tocsin::qos_tool {
namespace {

using Body = int (*)(const Options&);

CLI::App* bare_verb(Verbs& verbs, Options& options, const char* name, const char* text, Body body) {
  return verbs.add(name, text, [&options, body] { return body(options); });
}

CLI::App* verb(Verbs& verbs, Options& options, const char* name, const char* text, Body body) {
  CLI::App* const sub = bare_verb(verbs, options, name, text, body);
  sub->add_option("--file", options.file, "QoS file [the shipped qos.yaml]");
  return sub;
}

void need(CLI::App& sub, const char* name, std::string& value, const char* text) {
  sub.add_option(name, value, text)->required();
}

void may_be_json(CLI::App& sub, Options& options) {
  sub.add_flag("--json", options.json, "for scripts");
}

void declare_pages(Verbs& verbs, Options& options) {
  may_be_json(
      *verb(verbs, options, "list", "profiles with the topics that use them", qos_verb::list),
      options);
  CLI::App* const show = verb(verbs, options, "show", "one profile", qos_verb::show);
  need(*show, "PROFILE", options.one, "see list");
  show->add_flag("--all", options.all, "defaults, too");
  may_be_json(*show, options);
  need(*verb(verbs, options, "explain", "what each policy of a profile means, in plain words",
             qos_verb::explain),
       "PROFILE", options.one, "see list");
  CLI::App* const diff =
      verb(verbs, options, "diff", "by which policies two profiles differ", qos_verb::diff);
  need(*diff, "A", options.one, "a profile");
  need(*diff, "B", options.other, "another one");
  may_be_json(*diff, options);
}

void of_running_system(CLI::App& sub, Options& options) {
  options.host.declare(sub);
  sub.add_option("--spin-time", options.spin_s, "[s] waited for what does not appear [2]")
      ->check(CLI::Range(0.1, 600.0));
}

void declare_match(Verbs& verbs, Options& options) {
  CLI::App* const match =
      verb(verbs, options, "match", "whether a writer and a reader match", qos_verb::match);
  need(*match, "WRITER", options.one, "a profile, or /topic: its writers in the running system");
  match->add_option("READER", options.other,
                    "a profile, or /topic: its readers in the running system [as WRITER]");
  match->add_flag("--all", options.all, "policies that fit, too");
  may_be_json(*match, options);
  of_running_system(*match, options);
}

void declare_lint(Verbs& verbs, Options& options) {
  CLI::App* const lint =
      verb(verbs, options, "lint", "known traps, each with its reason", qos_verb::lint_files);
  lint->add_option("--traffic", options.traffic, "traffic file [the shipped traffic.yaml]");
  lint->add_flag("--direct", options.direct,
                 "as if link topics were on the radio themselves, without link_router");
  lint->add_option("--stream", options.streams, "a profile of pictures and the like")
      ->expected(1)
      ->take_all();
  lint->add_option("--outage", options.outage_s, "[s] the radio is away so long now and then [10]")
      ->check(CLI::Range(0.0, 3600.0));
  lint->add_flag("--synchronised-clocks", options.clocks_are_synchronised,
                 "the clocks of all computers are kept together (PTP, chrony)");
  may_be_json(*lint, options);
}

void declare_export(Verbs& verbs, Options& options) {
  CLI::App* const out = verb(verbs, options, "export", "profiles as XML of another vendor",
                             qos_verb::export_profiles);
  out->add_option("PROFILE", options.profiles, "[all]");
  out->add_option("--to", options.vendor, "fastdds (Fast DDS 2), fastdds3 or cyclone [fastdds]")
      ->check(CLI::IsMember({"fastdds", "fastdds3", "cyclone"}));
}

void declare_tune(Verbs& verbs, Options& options) {
  CLI::App* const tune = bare_verb(verbs, options, "tune",
                                   "tries settings in simulation and ranks them", qos_verb::tune);
  need(*tune, "FILE", options.tune.file,
       "what to try; a bare name is also looked for among the shipped experiments");
  tune->add_option("--out", options.tune.out, "folder of the results [tuning/FILE]");
  tune->add_option("--jobs", options.tune.jobs, "simulated runs at a time [all cores]")
      ->check(CLI::Range(1, 256));
}

void declare_set(Verbs& verbs, Options& options) {
  CLI::App* const set =
      bare_verb(verbs, options, "set", "changes policies of a topic that is in use", qos_verb::set);
  need(*set, "TOPIC", options.one, "its name, with or without the slash");
  set->add_option("SETTING", options.settings, "policy=value")->required();
  may_be_json(*set, options);
  of_running_system(*set, options);
}

}  // namespace

void declare(Verbs& verbs, Options& options) {
  declare_pages(verbs, options);
  declare_match(verbs, options);
  declare_lint(verbs, options);
  declare_export(verbs, options);
  declare_set(verbs, options);
  declare_tune(verbs, options);
}

}  // namespace tocsin::qos_tool
