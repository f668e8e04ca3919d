// SPDX-License-Identifier: Apache-2.0
#include "run_tool.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <optional>

#include "foundation/child_process.hpp"
#include "foundation/error.hpp"

namespace tocsin::foxglove {
namespace {

using End = ToolOutcome::End;

/// Takes what there is; false: there will be no more.
bool take(int output, std::string& printed) {
  std::array<char, 16384> part{};
  while (true) {
    const ssize_t got = ::read(output, part.data(), part.size());
    if (got <= 0) return got < 0 && (errno == EAGAIN || errno == EINTR);
    printed.append(part.data(), static_cast<std::size_t>(got));
  }
}

/// Why it is ended before its time; none: it has ended itself.
std::optional<End> read_all(int output, const ToolLimits& limits,
                            const std::atomic<bool>& cancelled, std::string& printed) {
  constexpr int look_ms = 100;  // at `cancelled`
  const auto end = std::chrono::steady_clock::now() + limits.time;
  while (take(output, printed)) {
    if (cancelled) return End::cancelled;
    if (printed.size() > limits.bytes) return End::too_much;
    if (std::chrono::steady_clock::now() > end) return End::too_long;
    pollfd wait{output, POLLIN, 0};
    ::poll(&wait, 1, look_ms);
  }
  return std::nullopt;
}

}  // namespace

ToolOutcome run_tool(const std::vector<std::string>& command, const ToolLimits& limits,
                     const std::atomic<bool>& cancelled) {
  ToolOutcome outcome;
  try {
    const Child child = start_child({command, ChildSetup::Streams::piped, SIGKILL});
    const auto ended = read_all(child.output.get(), limits, cancelled, outcome.printed);
    if (ended) ::kill(-child.pid, SIGKILL);
    const int code = wait_for_child(child.pid);
    outcome.end = ended.value_or(code == 0 ? End::success : End::failure);
  } catch (const EnvironmentError& error) {
    outcome.printed = error.what();
  }
  return outcome;
}

}  // namespace tocsin::foxglove
