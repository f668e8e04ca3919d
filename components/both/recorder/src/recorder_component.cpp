// SPDX-License-Identifier: Apache-2.0
#include "recorder/recorder_component.hpp"

#include <utility>

#include "foundation/error.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/middleware/idl_libraries.hpp"

namespace tocsin {
namespace {

constexpr Duration try_again_period = std::chrono::seconds(2);
/// Each container writes it, which no bringup file says.
constexpr const char* log_topic = "rosout";

/// Of each topic of the link, where a router gives what did not cross at first.
void add_backfilled(std::vector<ChosenTopic>& chosen) {
  std::vector<ChosenTopic> backfilled;
  for (const ChosenTopic& topic : chosen) {
    if (topic.info.scope != Scope::link) continue;
    const std::string name = std::string(topic.info.name) + "/backfilled";
    backfilled.push_back({make_topic_info(name, "event", Scope::host), topic.type});
  }
  chosen.insert(chosen.end(), backfilled.begin(), backfilled.end());
}

/// Those that libraries of this process state; with wishes beyond them, those of all that are
/// installed.
std::vector<ChosenTopic> chosen_topics(const std::string& name,
                                       const RecorderComponent::Params& params) {
  if (!are_stated(params.topics, known_topics())) load_idl_libraries();
  auto chosen = choose_topics(name, {params.link_topics, params.topics}, known_topics());
  if (params.backfilled) add_backfilled(chosen);
  return chosen;
}

}  // namespace

RecorderComponent::RecorderComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      directory_(params.directory.empty() ? context.run_dir + "/" + to_string(context.role)
                                          : params.directory),
      flush_period_(seconds(params.flush_period_s)),
      topics_(chosen_topics(context.name, params)),
      wanted_(params.recording) {
  if (wanted_) begin(bus().now());
}

void RecorderComponent::begin(Time now) {
  began_ = now;
  began_wall_ns_ = bus().wall_ns(now);
  recording_.emplace(directory_, params_.bag_compression, KeptFree{params_.keep_free});
  for (const ChosenTopic& topic : topics_) {
    auto input = listen_to(topic);
    if (!input) continue;
    tracks_.push_back({recording_->add(topic), std::move(input)});
  }
}

void RecorderComponent::end() {
  tracks_.clear();
  recording_.reset();
  lost_ = 0;
  disk_full_ = false;
}

/// In motion nothing throws: what cannot begin now is tried again.
void RecorderComponent::follow_wish(Time now) {
  if (wanted_ == recording_.has_value()) return;
  if (!wanted_) {
    end();
    log().info("records no more");
    return;
  }
  if (now < next_try_) return wake_at(next_try_);
  try {
    begin(now);
    said_fault_ = false;
    log().info("records to {}", directory_);
  } catch (const ConfigError& error) {
    end();
    if (!std::exchange(said_fault_, true)) log().error("does not record: {}", error.what());
    next_try_ = now + try_again_period;
    wake_at(next_try_);
  }
}

/// A package of the user's may state topics whose QoS profile only its own bringup file has: what a
/// rule for many finds is left out then, what was asked for by its name is an error.
std::unique_ptr<InputPort> RecorderComponent::listen_to(const ChosenTopic& topic) {
  const bool is_log = topic.info.name == std::string(log_topic);
  const Writers writers = topic.named && !is_log ? Writers::needed : Writers::optional;
  try {
    return std::make_unique<InputPort>(*this, Endpoint{topic.info, topic.type, writers});
  } catch (const ConfigError& error) {
    if (topic.named) throw;
    log().warn("not recorded: {}", error.what());
    return nullptr;
  }
}

void RecorderComponent::tick(Time now) {
  take_samples();
  follow_wish(now);
  if (!recording_) return;
  if (now >= next_flush_) flush(now);
  wake_at(next_flush_);
}

void RecorderComponent::take_samples() {
  for (const Track& track : tracks_) {
    while (auto sample = track.input->take_sample()) {
      // What was there before, as the last one of a state, comes into the recording as it begins.
      if (sample->received < began_) sample->received_wall_ns = began_wall_ns_;
      recording_->write(track.number, *sample);
    }
  }
}

void RecorderComponent::flush(Time now) {
  next_flush_ = next_instant(flush_period_, now);
  recording_->flush();
  const std::uint64_t lost_before = std::exchange(lost_, recording_->lost());
  const bool was_full = std::exchange(disk_full_, lost_ > lost_before);
  if (disk_full_ != was_full) {
    if (disk_full_) {
      log().error(
          "messages are being lost: {} cannot be written, or less than {} of its disk is free",
          directory_, params_.keep_free);
    } else {
      log().info("{} can be written again; {} messages were lost since the start", directory_,
                 lost_);
    }
  }
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::RecorderComponent)
