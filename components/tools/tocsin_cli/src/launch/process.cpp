// SPDX-License-Identifier: Apache-2.0
#include "process.hpp"

#include <signal.h>
#include <sys/wait.h>

#include <array>
#include <cstring>

#include "network.hpp"

namespace tocsin::cli {

Process::Process(ProcessSpec spec, const deployment::RestartPolicy& policy, Journal& journal)
    : spec_(std::move(spec)), rule_(policy), journal_(journal) {}

void Process::start(std::optional<int> network, const std::vector<int>& inherited, Time now) {
  using Streams = ChildSetup::Streams;
  child_ =
      start_child({spec_.command, spec_.terminal ? Streams::errors_piped : Streams::piped, SIGKILL,
                   network, inherited, spec_.host ? Capabilities{} : radio_capabilities});
  rule_.on_start(now);
  start_at_ = never;
}

void Process::pass_on(const std::string& line) {
  if (!line.empty()) last_line_ = line;
  journal_.process_line(spec_.name, line);
}

void Process::read_output() {
  std::array<char, 4096> buffer;
  while (child_.output) {
    const auto count = ::read(child_.output.get(), buffer.data(), buffer.size());
    if (count < 0) return;  // nothing more for now
    if (count == 0) child_.output.reset();
    const std::string_view bytes(buffer.data(), static_cast<std::size_t>(count));
    for (const std::string& line : splitter_.feed(bytes)) pass_on(line);
  }
}

std::optional<Ending> Process::reap() {
  int status = 0;
  if (!running() || ::waitpid(child_.pid, &status, WNOHANG) != child_.pid) return std::nullopt;
  ::kill(-child_.pid, SIGKILL);
  read_output();
  const std::string rest = splitter_.rest();
  if (!rest.empty()) pass_on(rest);
  child_ = Child{};
  if (WIFSIGNALED(status)) return Ending{true, WTERMSIG(status)};
  return Ending{false, WEXITSTATUS(status)};
}

RestartDecision Process::judge(const Ending& ending, Time now) {
  const RestartDecision decision = rule_.on_exit(ending, now);
  if (decision.kind == RestartDecision::Kind::restart) start_at_ = now + decision.delay;
  return decision;
}

void Process::signal(int number) const {
  if (running()) ::kill(-child_.pid, number);
}

std::string describe(const Ending& ending) {
  if (!ending.by_signal) return "exit code " + std::to_string(ending.code);
  return "signal " + std::to_string(ending.code) + " (" + ::strsignal(ending.code) + ")";
}

}  // namespace tocsin::cli
