// SPDX-License-Identifier: Apache-2.0
#include "bag_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <ctime>

#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::bag_tool {
namespace {

const CLI::Range positive(1e-6, 1e9);
const CLI::Range not_negative(0.0, 1e12);

void declare_topics(CLI::App& sub, TopicWishes& wishes) {
  sub.add_option("--topics", wishes.topics, "only these");
  sub.add_option("-e,--regex", wishes.regex, "topics whose names contain a match");
  sub.add_option("-x,--exclude-regex", wishes.exclude_regex, "but not those that contain this");
  sub.add_option("--exclude-topics", wishes.exclude_topics, "but not these");
}

void declare_output(CLI::App& sub, Options& options, bag::BagOptions& bag) {
  sub.add_option("-b,--max-bag-size", bag.max_bytes,
                 "[byte] of a file, then another begins [0: no limit]");
  sub.add_option("-d,--max-bag-duration", bag.max_duration_s, "[s] of a file [0: no limit]")
      ->check(not_negative);
  sub.add_option("--compression-mode", options.compression_mode,
                 "none, or chunk: within the files, so that they stay readable by index [none]");
  sub.add_option("--compression-format", options.compression_format, "[zstd]")
      ->check(CLI::IsMember({"none", "lz4", "zstd"}));
}

void declare_record(CLI::App& app, Options& options) {
  CLI::App* const sub = app.add_subcommand("record", "records topics of a running host into a bag");
  RecordOrder& record = options.record;
  options.host.declare(*sub);
  sub->add_option("topic", record.topics.topics, "names, with or without the slash");
  declare_topics(*sub, record.topics);
  sub->add_flag("-a,--all", record.topics.all, "all topics");
  sub->add_flag("--include-hidden-topics", record.topics.hidden, "those that begin with _, too");
  sub->add_flag("--no-discovery", options.no_discovery, "only topics that are there at the start");
  sub->add_option("-p,--polling-interval", options.polling_interval_ms,
                  "[ms] between looks for new topics [100]")
      ->check(CLI::Range(1, 60'000));
  sub->add_option("--max-cache-size", record.cache_bytes,
                  "[byte] of messages that may wait for the disk [100000000]");
  sub->add_option("-o,--output", options.output, "new folder [rosbag2_<time>]");
  sub->add_option("-s,--storage", "storage; there is one [mcap]")->check(CLI::IsMember({"mcap"}));
  declare_output(*sub, options, record.options);
}

void declare_play(CLI::App& app, Options& options) {
  CLI::App* const sub = app.add_subcommand("play", "writes the messages of a bag again");
  PlayOrder& play = options.play;
  options.host.declare(*sub);
  sub->add_option("bag", play.bag, "folder or MCAP file")->required();
  declare_topics(*sub, play.topics);
  sub->add_option("-r,--rate", play.rate, "2: twice as fast [1]")->check(positive);
  sub->add_flag("-l,--loop", play.loop, "begins again at the end");
  sub->add_option("--start-offset", play.start_offset_s, "[s] left out at the beginning [0]")
      ->check(not_negative);
  sub->add_option("--playback-duration", play.duration_s, "[s] of the recording [all]")
      ->check(not_negative);
  sub->add_option("-d,--delay", play.delay_s, "[s] before the first message [0]")
      ->check(not_negative);
  sub->add_option("-m,--remap", options.remap, "/old:=/new ...");
  sub->add_option_function<std::vector<std::string>>(
         "--clock",
         [&options](const std::vector<std::string>& rates) {
           options.clock = true;
           options.clock_hz = rates.empty() ? "" : rates.front();
         },
         "writes /clock so often [1/s] [40]")
      ->expected(0, 1);
  sub->add_option("--spin-time", options.spin_s, "[s] waited for readers at most [2]")
      ->check(CLI::Range(0.0, 600.0));
}

void declare_part(CLI::App& sub, RewriteOrder& rewrite) {
  declare_topics(sub, rewrite.topics);
  sub.add_option("--start-offset", rewrite.start_offset_s, "[s] left out at the beginning [0]")
      ->check(not_negative);
  sub.add_option("--playback-duration", rewrite.duration_s, "[s] from there [all]")
      ->check(not_negative);
}

void declare_export(CLI::App& app, Options& options) {
  CLI::App* const sub = app.add_subcommand("export", "writes a bag as CSV, a file for each topic");
  sub->add_option("bag", options.rewrite.inputs, "folder or MCAP file")->required()->expected(1);
  sub->add_option("-o,--output", options.output, "new folder")->required();
  declare_part(*sub, options.rewrite);
}

void declare_rewrite(CLI::App& app, Options& options, const char* name, const char* text) {
  CLI::App* const sub = app.add_subcommand(name, text);
  RewriteOrder& rewrite = options.rewrite;
  sub->add_option("bag,-i,--input", rewrite.inputs, "folders or MCAP files")->required();
  sub->add_option("-o,--output", options.output, "new folder")->required();
  declare_part(*sub, rewrite);
  declare_output(*sub, options, rewrite.options);
}

mcap::Compression compression_of(const Options& options) {
  const std::string& mode = options.compression_mode;
  if (mode == "file" || mode == "message") {
    throw ConfigError("--compression-mode: '" + mode +
                      "' packs what only rosbag2 unpacks; chunk packs within the files, and every "
                      "reader of MCAP unpacks that");
  }
  if (!mode.empty() && mode != "none" && mode != "chunk") {
    throw ConfigError("--compression-mode: '" + printable(mode) + "' is neither none nor chunk");
  }
  if (mode == "none") return mcap::Compression::none;
  const std::string usual = mode == "chunk" ? "zstd" : "none";
  const std::string& format = options.compression_format;
  return value_of<mcap::Compression>(format.empty() ? usual : format)
      .value_or(mcap::Compression::none);
}

/// `rosbag2_2026_11_22-12_30_00`, in local time.
std::string timestamped_folder() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 64> text{};
  (void)std::strftime(text.data(), text.size(), "rosbag2_%Y_%m_%d-%H_%M_%S", &local);
  return text.data();
}

double clock_rate(const std::string& text) {
  constexpr double usual_hz = 40;
  if (text.empty()) return usual_hz;
  double hz = 0;
  if (!CLI::detail::lexical_cast(text, hz) || !(hz > 0 && hz <= 10'000)) {
    throw ConfigError("--clock: '" + printable(text) + "' is outside (0, 10000]");
  }
  return hz;
}

void complete_record(Options& options) {
  RecordOrder& record = options.record;
  const TopicWishes& topics = record.topics;
  if (!topics.all && topics.topics.empty() && topics.regex.empty()) {
    throw ConfigError("record: say which topics: names, --regex or --all");
  }
  record.output = options.output.empty() ? timestamped_folder() : options.output;
  record.options.compression = compression_of(options);
  record.discovery = !options.no_discovery;
  record.polling_interval_s = options.polling_interval_ms * 1e-3;
}

}  // namespace

void declare(CLI::App& app, Options& options) {
  app.require_subcommand(1);
  declare_record(app, options);
  declare_play(app, options);
  app.add_subcommand("info", "what is in a bag")
      ->add_option("bag", options.bag, "folder or MCAP file")
      ->required();
  CLI::App* const recover =
      app.add_subcommand("recover", "makes a whole bag of one that was cut or damaged");
  recover->add_option("bag", options.bag, "folder or MCAP file")->required();
  recover->add_option("-o,--output", options.output, "new folder [<bag>_recovered]");
  declare_rewrite(app, options, "filter", "copies some topics, or a part of the time");
  declare_rewrite(app, options, "merge", "makes one bag of several");
  declare_rewrite(app, options, "convert", "copies a bag with other files or compression");
  declare_export(app, options);
}

void complete(const std::string& verb, Options& options) {
  if (verb == "record") complete_record(options);
  if (verb == "play") {
    for (const std::string& text : options.remap) options.play.remap.insert(remapping(text));
    if (options.clock) options.play.clock_hz = clock_rate(options.clock_hz);
  }
  options.rewrite.output = options.output;
  options.rewrite.topics.hidden = true;  // they were recorded on purpose
  options.play.topics.hidden = true;
  options.rewrite.options.compression = compression_of(options);
}

}  // namespace tocsin::bag_tool
