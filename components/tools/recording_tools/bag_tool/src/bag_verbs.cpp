// SPDX-License-Identifier: Apache-2.0
#include "bag_verbs.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <thread>

#include "bag/recover_bag.hpp"
#include "command_line/stop_signal.hpp"
#include "export.hpp"
#include "foundation/printable.hpp"
#include "info_text.hpp"
#include "runtime/middleware/idl_libraries.hpp"

namespace tocsin::bag_tool {
namespace {

unsigned long long number(std::uint64_t value) { return value; }

int record(const Options& options) {
  load_idl_libraries();
  const auto graph = make_host_graph(host_bus_options(options.host, "tocsin_bag_record"));
  catch_stop_signals();
  Recording recording(*graph, options.record);
  std::printf("Recording into %s; Ctrl-C ends it\n", printable(options.record.output).c_str());
  std::fflush(stdout);
  recording.run();
  std::printf("Recorded %llu messages of %zu topics into %s\n",
              number(recording.messages() - recording.lost()), recording.topics(),
              printable(options.record.output).c_str());
  return recording.lost() == 0 ? 0 : 1;
}

int play(const Options& options) {
  (void)bag::BagReader(options.play.bag);  // a bag that cannot be read needs no running system
  const auto graph = make_host_graph(host_bus_options(options.host, "tocsin_bag_play"));
  catch_stop_signals();
  Player player(*graph, options.play);
  (void)settled_ends(*graph, seconds(options.spin_s), is_stopped);
  std::printf("Playing %s\n", printable(options.play.bag).c_str());
  std::fflush(stdout);
  const std::uint64_t written = player.run();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // the last one has to leave
  std::printf("Played %llu messages\n", number(written));
  if (player.refused() == 0) return 0;
  std::fprintf(stderr, "the middleware refused %llu messages\n", number(player.refused()));
  return 1;
}

int info(const Options& options) {
  std::printf("%s", info_text(bag::BagReader(options.bag)).c_str());
  return 0;
}

int recover(const Options& options) {
  // A slash behind the name of a folder is no part of it.
  const std::string bag = (std::filesystem::path(options.bag) / "").parent_path();
  const std::string output = options.output.empty() ? bag + "_recovered" : options.output;
  std::uint64_t lost = 0;
  for (const auto& [name, recovered] : bag::recover_bag(options.bag, output)) {
    const std::string damage = damage_text(recovered.damage);
    std::printf("%s: %llu messages%s%s\n", printable(name).c_str(), number(recovered.messages),
                damage.empty() ? "" : "; it ", damage.c_str());
    lost += recovered.lost;
  }
  std::printf("Recovered into %s\n", printable(output).c_str());
  if (lost > 0) std::fprintf(stderr, "the disk is full: %llu messages are lost\n", number(lost));
  return lost == 0 ? 0 : 1;
}

int copy(const Options& options) {
  const Rewritten result = rewrite(options.rewrite);
  for (const std::string& line : result.damage) std::printf("%s\n", line.c_str());
  std::printf("Wrote %llu messages into %s\n", number(result.messages),
              printable(options.rewrite.output).c_str());
  if (result.lost > 0) {
    std::fprintf(stderr, "the disk is full: %llu messages are lost\n", number(result.lost));
  }
  return result.lost == 0 ? 0 : 1;
}

int export_bag(const Options& options) {
  load_idl_libraries();
  const Exported result = export_csv(options.rewrite);
  std::printf("Wrote %llu messages into %s\n", number(result.messages),
              printable(options.rewrite.output).c_str());
  for (const std::string& topic : result.unknown) {
    std::printf(
        "%s: only in messages.csv, no installed library has its type, or bytes of it are "
        "damaged\n",
        printable(topic).c_str());
  }
  for (const std::string& problem : result.problems) {
    std::fprintf(stderr, "%s\n", problem.c_str());
  }
  if (result.lost > 0)
    std::fprintf(stderr, "the disk is full: %llu rows are lost\n", number(result.lost));
  return result.lost == 0 && result.problems.empty() ? 0 : 1;
}

}  // namespace

int run_verb(const std::string& verb, Options options) {
  complete(verb, options);
  using Verb = int (*)(const Options&);
  static const std::map<std::string, Verb> verbs{
      {"record", record}, {"play", play},  {"info", info},    {"recover", recover},
      {"filter", copy},   {"merge", copy}, {"convert", copy}, {"export", export_bag}};
  return verbs.at(verb)(options);
}

}  // namespace tocsin::bag_tool
