// SPDX-License-Identifier: Apache-2.0
#include "shapes/shape_options.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "command_line/option_checks.hpp"
#include "foundation/error.hpp"

namespace tocsin::shapes {
namespace {

constexpr double s_in_ms = 0.001;

/// As the words stand, before they mean something.
struct Words {
  bool publish = false;
  bool subscribe = false;
  bool best_effort = false;
  bool reliable = false;
  int depth = -1;
  int deadline_ms = 0;
  int strength = -1;
  std::string partition;
  std::string durability = "v";
  int representation = 1;
  std::string verbosity;
  int write_period_ms = 33;
  int read_period_ms = 100;
  int time_filter_ms = 0;
  int lifespan_ms = 0;
  std::string final_state;
  std::string access_scope;
  bool coherent = false;
  bool ordered = false;
  int coherent_samples = 0;
  bool without_instances = false;
  int announcement_ms = 0;
  int fragment_bytes = 0;
};

void declare_qos(CLI::App& app, Words& words) {
  app.add_flag("-b", words.best_effort, "best effort");
  app.add_flag("-r", words.reliable, "reliable [this]");
  app.add_option("-k", words.depth, "history depth; 0: keep all [1]")->check(CLI::Range(0, 10'000));
  app.add_option("-f", words.deadline_ms, "[ms] deadline; 0: none [0]")->check(at_least_zero());
  app.add_option("-s", words.strength, "exclusive ownership of this strength; -1: shared [-1]")
      ->check(CLI::Range(-1, 1'000'000));
  app.add_option("-p", words.partition, "partition");
  app.add_option("-D", words.durability,
                 "v: volatile, l: transient local, t: transient, "
                 "p: persistent [v]")
      ->check(CLI::IsMember({"v", "l", "t", "p"}));
  app.add_option("-x", words.representation, "1: XCDR1, 2: XCDR2 [1]")->check(CLI::Range(1, 2));
  app.add_option("--time-filter", words.time_filter_ms, "[ms] of a subscriber; 0: none [0]")
      ->check(at_least_zero());
  app.add_option("--lifespan", words.lifespan_ms, "[ms] of samples; 0: for ever [0]")
      ->check(at_least_zero());
  app.add_option("--access-scope", words.access_scope, "of the presentation: i, t or g")
      ->check(CLI::IsMember({"i", "t", "g"}));
  app.add_flag("--coherent", words.coherent, "coherent access");
  app.add_flag("--ordered", words.ordered, "ordered access");
  app.add_option("--coherent-sample-count", words.coherent_samples, "in a coherent set")
      ->check(CLI::Range(2, 10'000));
  app.add_option("--datafrag-size", words.fragment_bytes, "[byte] of a fragment")
      ->check(CLI::Range(0, 65'535));
  app.add_option("--periodic-announcement", words.announcement_ms, "[ms] of the participant")
      ->check(at_least_zero());
}

void declare_rest(CLI::App& app, ShapeOptions& options, Words& words) {
  app.add_flag("-P", words.publish, "publish");
  app.add_flag("-S", words.subscribe, "subscribe");
  app.add_option("-d", options.domain, "domain [0]")->check(CLI::Range(0, 231));
  app.add_option("-t", options.topic, "topic")->required();
  app.add_option("-c", options.color, "colour to publish, or to subscribe to");
  app.add_flag("-w", options.print_written, "print what is published");
  app.add_option("-v", words.verbosity, "e: errors, d: debug [e]")
      ->check(CLI::IsMember({"e", "d"}));
  app.add_option("-z", options.shapesize, "size; 0: grows with each sample [20]")
      ->check(at_least_zero());
  app.add_option("--size-modulo", options.size_modulo, "a growing size starts again after this")
      ->check(above_zero());
  app.add_flag("--stamps", options.stamps, "print when a sample was stamped and read");
  app.add_flag("-R", options.reads, "read() instead of take()");
  app.add_option("--write-period", words.write_period_ms, "[ms] [33]")->check(at_least_zero());
  app.add_option("--read-period", words.read_period_ms, "[ms] [100]")->check(at_least_zero());
  app.add_option("--num-iterations", options.iterations, "then ends [never]")->check(above_zero());
  app.add_option("--num-instances", options.instances, "colours: BLUE, BLUE1, ... [1]")
      ->check(CLI::Range(1, 10'000));
  app.add_option("--num-topics", options.topics, "topics: Square, Square1, ... [1]")
      ->check(CLI::Range(1, 1'000));
  app.add_option("--final-instance-state", words.final_state,
                 "u: unregister, d: dispose at the end")
      ->check(CLI::IsMember({"u", "d"}));
  app.add_option("--additional-payload-size", options.payload_bytes, "[byte] of ballast")
      ->check(above_zero());
  app.add_flag("--take-read", words.without_instances, "all instances at once");
  app.add_option("--cft", options.filter, "filter of a subscriber: \"shapesize <= 20\"");
}

/// What Fast DDS 2.9.1 does not have.
std::string unsupported(const Words& words) {
  if (words.coherent) return "Presentation Coherent Access";
  if (words.ordered) return "Presentation Ordered Access";
  if (words.representation == 2) return "Data Representation XCDR2";
  if (words.durability == "t") return "Durability TRANSIENT";
  if (words.durability == "p") return "Durability PERSISTENT";
  return "";
}

QosProfile profile_of(const Words& words) {
  QosProfile qos;
  if (words.best_effort && !words.reliable) qos.reliability = Reliability::best_effort;
  if (words.durability == "l") qos.durability = Durability::transient_local;
  if (words.depth == 0) qos.history = History::keep_all;
  if (words.depth > 0) qos.depth = words.depth;
  if (words.deadline_ms > 0) qos.deadline_s = words.deadline_ms * s_in_ms;
  if (words.lifespan_ms > 0) qos.lifespan_s = words.lifespan_ms * s_in_ms;
  if (words.strength >= 0) {
    qos.ownership = Ownership::exclusive;
    qos.ownership_strength = words.strength;
  }
  if (!words.partition.empty()) qos.partition = {words.partition};
  if (words.subscribe) qos.minimum_separation_s = words.time_filter_ms * s_in_ms;
  return qos;
}

void settle(ShapeOptions& options, const Words& words) {
  if (words.publish == words.subscribe) {
    throw ConfigError("please specify one of: publish [-P] or subscribe [-S]");
  }
  if (words.subscribe && !options.color.empty() && !options.filter.empty()) {
    throw ConfigError("cannot specify both --cft and -c for a subscriber");
  }
  options.publish = words.publish;
  if (options.publish && options.color.empty()) options.color = "BLUE";
  options.qos = profile_of(words);
  options.write_period_s = words.write_period_ms * s_in_ms;
  options.read_period_s = words.read_period_ms * s_in_ms;
  if (words.final_state == "u") options.final_state = FinalState::unregister;
  if (words.final_state == "d") options.final_state = FinalState::dispose;
  options.unsupported = unsupported(words);
}

}  // namespace

std::optional<ShapeOptions> parse_options(int argc, const char* const* argv) {
  ShapeOptions options;
  Words words;
  CLI::App app("shape_main of the OMG's DDS interoperability suite, on our runtime.",
               "tocsin shapes");
  app.option_defaults()->take_last();  // as getopt
  declare_rest(app, options, words);
  declare_qos(app, words);
  try {
    app.parse(argc, const_cast<char**>(argv));
  } catch (const CLI::CallForHelp&) {
    std::printf("%s", app.help().c_str());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw ConfigError(error.what());
  }
  settle(options, words);
  return options;
}

}  // namespace tocsin::shapes
