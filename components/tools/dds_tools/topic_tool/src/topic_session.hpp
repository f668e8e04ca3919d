// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command_line/command.hpp"
#include "idl_support/type_info.hpp"
#include "runtime/middleware/host_bus.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin::topic_tool {

/// Which host a command looks at, and how long.
struct SessionOptions {
  HostChoice host;
  double spin_s = 2;  ///< [s] waited for what does not appear

  /// Adds --domain and the like, and --spin-time.
  void declare_session(CLI::App& verb);
};

/// A verb that looks at a host and calls `body` with `options`.
template <class Options>
CLI::App* add_verb(Verbs& verbs, Options& options, const char* name, const char* text,
                   int (*body)(const Options&)) {
  CLI::App* const verb = verbs.add(name, text, [&options, body] { return body(options); });
  options.declare_session(*verb);
  return verb;
}

/// Adds --timeout.
void declare_timeout(CLI::App& verb, double& timeout_s);

/// A program whose verbs `declare` adds: does what the one that was said says.
template <class Options>
int run_verbs(int argc, char** argv, const char* name, const char* about,
              void (*declare)(Verbs&, Options&)) {
  CLI::App app(about, name);
  Options options;
  Verbs verbs(app);
  declare(verbs, options);
  return verbs.run(argc, argv);
}

/// A host's domain as a command of a person uses it: waits until those who are there were heard.
class TopicSession {
 public:
  explicit TopicSession(const SessionOptions& options);

  /// All ends, once nothing new has come for a while; the nodes of `graph` are there then, too.
  [[nodiscard]] std::vector<GraphEnd> ends() const;
  /// Waits until somebody has announced the topic. Throws EnvironmentError when nobody does.
  [[nodiscard]] RawTopic find(const std::string& ros_topic) const;
  [[nodiscard]] HostGraph& graph() const { return *graph_; }

 private:
  double spin_s_;
  std::unique_ptr<HostGraph> graph_;
};

/// The type of this wire name, of this and other workspaces. Throws ConfigError when it is unknown.
[[nodiscard]] const TypeInfo& known_type(std::string_view on_wire);

/// Samples of a topic that wait for the thread that prints.
class SampleQueue {
 public:
  SampleQueue(HostGraph& graph, const RawTopic& topic);
  /// Waits for one at most `patience`; empty when none came, or Ctrl-C was pressed.
  [[nodiscard]] std::optional<RawSample> take(Duration patience);
  [[nodiscard]] std::size_t dropped() const;

 private:
  static constexpr std::size_t room = 1000;
  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::deque<RawSample> samples_;
  std::size_t dropped_ = 0;
  std::unique_ptr<RawReading> reading_;  // last: destroyed first
};

}  // namespace tocsin::topic_tool
