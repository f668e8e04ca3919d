// SPDX-License-Identifier: Apache-2.0
#include "stop_site.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <stdexcept>
#include <thread>
#include <vector>

#include "keystore/keystore.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;

std::array<int, 2> open_pipe() {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_NONBLOCK) != 0) throw std::runtime_error("no pipe");
  return pipe;
}

std::string bringup(const TemporaryFolder& folder) {
  return folder.write("site.yaml",
                      "extends: mission.yaml\nstop_when_exits: ~\n"
                      "restart: {max_backoff_s: 0.2, limit: 1000}\n"
                      "hosts:\n  uxv: {containers: [{payload: ~}]}\n"
                      "  gcs: {containers: [{view: ~}, {page: ~}, {mission: ~}]}\n");
}

std::string make_keystore(const TemporaryFolder& folder) {
  std::string keys = folder.path("keys");
  keystore::create(keys, std::time(nullptr));
  for (const char* const name : {"uxv", "gcs"}) {
    keystore::add(keys, {name, {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
  }
  return keys;
}

}  // namespace

std::function<void(Bus&)> turn_on_the_spot() {
  topic::CmdVel::Message message;
  message.angular().z(1);
  return repeat<topic::CmdVel>(message, milliseconds(20));
}

StationPerson::StationPerson(pid_t station)
    : pipe_(open_pipe()), peer_(station, on_host(site_domain + 1), asks()) {}

StationPerson::~StationPerson() {
  for (const int end : pipe_) ::close(end);
}

void StationPerson::wants(bool stop) const {
  const char word = stop ? '1' : '0';
  if (::write(pipe_[1], &word, 1) != 1) throw std::runtime_error("the person has gone");
}

std::function<void(Bus&)> StationPerson::asks() const {
  return [from = pipe_[0]](Bus& bus) {
    const auto writer = bus.advertise(
        {topic::EmergencyStopRequest::info, &type_info<topic::EmergencyStopRequest::Message>()});
    topic::EmergencyStopRequest::Message wanted;
    for (int turn = 0;; ++turn) {
      char word = 0;
      const bool typed = ::read(from, &word, 1) == 1;
      if (typed) wanted.data(word == '1');
      if (typed || turn % 100 == 0) {
        (void)writer->write(std::make_shared<const topic::EmergencyStopRequest::Message>(wanted));
      }
      std::this_thread::sleep_for(milliseconds(1));
    }
  };
}

StopSite::StopSite(const StopSiteOptions& options) {
  std::vector<std::string> arguments{bringup(folder_), "--seed", "1"};
  if (options.secured) {
    arguments.insert(arguments.end(), {"--security", make_keystore(folder_)});
  }
  stack_ = std::make_unique<Stack>(arguments, options.disk_mib);
  wheels_ = stack_->scratch() + "/wheels";
  if (!Stack::eventually(std::chrono::seconds(40),
                         [&] { return stack_->pid("gcs/recorder") != 0; })) {
    throw std::runtime_error(stack_->output());
  }
  watch_.emplace(stack_->running("uxv/recorder"), on_host(site_domain), watch_wheels(wheels_));
  rogue_.emplace(stack_->running("uxv/recorder"), on_host(site_domain), turn_on_the_spot());
  // One that has begun long enough ago to be in its host's network.
  person_.emplace(stack_->running("gcs/link"));
  const bool is_obeyed = Stack::eventually(std::chrono::seconds(40), [&] {
    return stack_->read("log/gcs.link.log").find("emergency stop off") != std::string::npos;
  });
  if (!is_obeyed) throw std::runtime_error("nobody obeys the person\n" + stack_->output());
  if (!moves(std::chrono::seconds(40)))
    throw std::runtime_error("does not move\n" + stack_->output());
  if (!options.loses) return;
  stack_->control("radio.sock", "set mode bernoulli");
  stack_->control("radio.sock", "set loss 0.3");
}

std::optional<double> StopSite::press() const {
  const double pressed = wall_s();
  person_->wants(true);
  const bool rests = Stack::eventually(std::chrono::seconds(10), [&] {
    return last_seen(wheels_) > std::max(pressed, last_moved(wheels_)) + 1;
  });
  if (!rests) return std::nullopt;
  return std::max(0.0, last_moved(wheels_) - pressed);
}

bool StopSite::release() const {
  person_->wants(false);
  return moves(std::chrono::seconds(20));
}

bool StopSite::moves(std::chrono::seconds limit) const {
  const double now = wall_s();
  return Stack::eventually(limit, [&] { return last_moved(wheels_) > now; });
}

}  // namespace tocsin
