// SPDX-License-Identifier: Apache-2.0
#include "recorder/bag_recording.hpp"

#include <filesystem>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/free_space.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {
namespace {

/// The first of `bag`, `bag_2`, ... that is not there.
std::string free_folder(const std::string& directory) {
  const std::string first = directory + "/bag";
  std::string folder = first;
  for (int number = 2; std::filesystem::exists(folder); ++number) {
    folder = first + "_" + std::to_string(number);
  }
  return folder;
}

/// What writers of the topic offer by the built-in profile of that name; none for another name.
std::vector<bag::OfferedQos> offered_by_profile(const TopicInfo& topic) {
  static const QosProfiles profiles;
  const auto found = profiles.all().find(topic.qos);
  if (found == profiles.all().end()) return {};
  const QosProfile& profile = found->second;
  bag::OfferedQos offer;
  offer.history = profile.keeps_all() ? bag::OfferedQos::History::keep_all
                                      : bag::OfferedQos::History::keep_last;
  offer.depth = profile.depth;
  offer.reliability = profile.reliable() ? bag::OfferedQos::Reliability::reliable
                                         : bag::OfferedQos::Reliability::best_effort;
  offer.durability = profile.keeps_last() ? bag::OfferedQos::Durability::transient_local
                                          : bag::OfferedQos::Durability::volatile_kind;
  offer.deadline_ns = bag::finite_ns(profile.deadline_s);
  offer.lifespan_ns = bag::finite_ns(profile.lifespan_s);
  offer.liveliness_lease_ns = bag::finite_ns(profile.liveliness_lease_s);
  return {offer};
}

}  // namespace

BagRecording::BagRecording(const std::string& directory, mcap::Compression compression,
                           const KeptFree& kept_free)
    : directory_(directory), kept_free_(kept_free), options_{compression, 0, 0} {
  try {
    begin();
  } catch (const ConfigError&) {
    // A recorder that dies on a full disk must not take the run with it when it comes back.
    if (free_bytes(directory).value_or(full_below_bytes) >= full_below_bytes) throw;
  }
  holds_back_ = !has_room();
}

bool BagRecording::has_room() const {
  const auto bytes = free_bytes(directory_);
  if (!bytes) return writer_ != nullptr;  // not every file system tells
  if (*bytes < full_below_bytes) return false;
  return *bytes >= kept_free_.most_bytes || free_share(directory_).value_or(0) >= kept_free_.share;
}

void BagRecording::begin() {
  writer_ = std::make_unique<bag::BagWriter>(free_folder(directory_), options_);
  for (const bag::Topic& topic : topics_) (void)writer_->add(topic);
}

std::size_t BagRecording::add(const ChosenTopic& topic) {
  bag::Topic made = bag::make_topic("rt/" + std::string(topic.info.name), topic.type->name);
  made.offered_qos = offered_by_profile(topic.info);
  types_.push_back(topic.type);
  topics_.push_back(made);
  if (writer_) (void)writer_->add(made);
  return topics_.size() - 1;
}

void BagRecording::write(std::size_t topic, const Sample& sample) {
  if (!writer_ || holds_back_) {
    ++left_out_;
    return;
  }
  const TypeInfo& type = *types_.at(topic);
  bytes_.resize(type.serialized_size(sample.message.get()));
  const std::size_t size = type.serialize(sample.message.get(), bytes_.data(), bytes_.size());
  (void)writer_->write(topic, {static_cast<std::uint32_t>(sample.sequence), sample.received_wall_ns,
                               sample.sent_wall_ns, bytes_.data(), size, sample.source});
}

void BagRecording::flush() {
  holds_back_ = !has_room();
  if (!writer_) {
    if (holds_back_) return;
    try {
      begin();
    } catch (const ConfigError&) {
      return;  // the next flush tries again
    }
  }
  (void)writer_->flush();
}

std::uint64_t BagRecording::lost() const { return left_out_ + (writer_ ? writer_->lost() : 0); }

}  // namespace tocsin
