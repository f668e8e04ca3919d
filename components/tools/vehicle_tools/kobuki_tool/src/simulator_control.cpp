// SPDX-License-Identifier: Apache-2.0
#include "simulator_control.hpp"

#include <poll.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace tocsin::kobuki {

std::optional<double> SimulatorControl::state(const std::string& key) {
  const auto answer = ask("get");
  if (!answer) return std::nullopt;
  const auto json = nlohmann::json::parse(*answer, nullptr, false);
  if (!json.is_object() || !json.contains(key) || !json[key].is_number()) return std::nullopt;
  return json[key].get<double>();
}

ControlClient::ControlClient(std::string path)
    : path_(std::move(path)),
      socket_("/tmp/tocsin-kobuki-" + std::to_string(::getpid()) + ".sock") {}

std::optional<std::string> ControlClient::ask(const std::string& line) {
  if (socket_.send(path_, line)) return std::nullopt;
  pollfd asked{socket_.descriptor(), POLLIN, 0};
  if (::poll(&asked, 1, 1000) <= 0) return std::nullopt;
  const auto answer = socket_.receive();
  return answer ? std::optional(answer->text) : std::nullopt;
}

}  // namespace tocsin::kobuki
