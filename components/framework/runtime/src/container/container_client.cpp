// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/container_client.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <random>
#include <set>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

template <class Topic>
Endpoint endpoint() {
  return {Topic::info, &type_info<typename Topic::Message>()};
}

std::optional<ContainerClient::Answer> answer_to(std::uint64_t id,
                                                 const ContainerClient::Known& known) {
  for (const auto& one : known) {
    for (const auto& answer : one.second.answers()) {
      if (answer.id() == id) return answer;
    }
  }
  return std::nullopt;
}

}  // namespace

ContainerClient::ContainerClient(Bus& bus)
    : commands_(bus.advertise(endpoint<topic::ContainerCommand>())),
      states_(bus.subscribe(endpoint<topic::ContainerState>(), *this)) {}

void ContainerClient::receive(const Sample& sample) {
  const auto state = std::static_pointer_cast<const State>(sample.message);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    known_[{state->container(), state->pid()}] = *state;
  }
  heard_.notify_all();
}

ContainerClient::Known ContainerClient::wait(Duration patience,
                                             const std::function<bool(const Known&)>& enough) {
  std::unique_lock<std::mutex> lock(mutex_);
  (void)heard_.wait_for(lock, patience, [&] { return enough(known_); });
  return known_;
}

ContainerClient::Answer ContainerClient::ask(Command command, Duration patience) {
  constexpr Duration repetition = std::chrono::milliseconds(200);
  std::random_device device;
  command.id((std::uint64_t{device()} << 32U | device()) | 1U);
  const auto message = std::make_shared<const Command>(command);
  for (Duration waited{0}; waited < patience; waited += repetition) {
    // Repeated, as the container may not have matched this writer yet; it obeys an id once.
    (void)commands_->write(message);
    const auto answered = [&](const Known& known) {
      return answer_to(command.id(), known).has_value();
    };
    if (const auto answer = answer_to(command.id(), wait(repetition, answered))) return *answer;
  }
  throw EnvironmentError("container " + command.container() + ": no answer to " + command.verb() +
                         " within " + std::to_string(patience / std::chrono::seconds(1)) + " s");
}

std::vector<std::string> container_paths(const ContainerClient::Known& known) {
  std::set<std::string> paths;
  for (const auto& one : known) paths.insert(one.second.host() + "/" + one.second.container());
  return {paths.begin(), paths.end()};
}

std::vector<std::string> instance_paths(const ContainerClient::Known& known) {
  std::set<std::string> paths;
  for (const auto& [process, state] : known) {
    for (const auto& one : state.components()) {
      paths.insert(state.host() + "/" + state.container() + "/" + one.name());
    }
  }
  return {paths.begin(), paths.end()};
}

}  // namespace tocsin
