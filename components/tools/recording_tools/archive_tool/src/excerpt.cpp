// SPDX-License-Identifier: Apache-2.0
#include "excerpt.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/role.hpp"
#include "idl_support/decode.hpp"
#include "mcap/reader.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::archive {
namespace {

/// A place is one of a reading when it was told at most so long before.
constexpr std::int64_t place_age_ns = 2'000'000'000;

template <class Topic>
std::shared_ptr<const typename Topic::Message> decoded(const mcap::Message& message) {
  const std::vector<std::uint8_t> bytes(message.data, message.data + message.size);
  return std::static_pointer_cast<const typename Topic::Message>(
      decode(type_info<typename Topic::Message>(), bytes));
}

/// Joins what is told of the link with what is told of the vehicle.
class Readings {
 public:
  void take(const std::string& topic, const mcap::Message& message) {
    const auto sent_ns = static_cast<std::int64_t>(message.publish_time_ns);
    if (topic == "/location") {
      if (const auto location = decoded<topic::Location>(message)) {
        place_ = {sent_ns, location->pose().pose().position().x(),
                  location->pose().pose().position().y()};
      }
    } else if (topic == "/battery_state") {
      const auto battery = decoded<topic::BatteryState>(message);
      if (battery) battery_percent_ = 100 * static_cast<double>(battery->percentage());
    } else if (topic == "/transmission_state") {
      const auto state = decoded<topic::TransmissionState>(message);
      if (state && role_of(state->role()) == Role::uxv) qni_ = static_cast<double>(state->qni());
    } else if (topic == "/network_quality") {
      if (const auto quality = decoded<topic::NetworkQuality>(message)) add(*quality, sent_ns);
    }
  }
  [[nodiscard]] std::vector<Reading> take_all() {
    std::stable_sort(readings_.begin(), readings_.end(), [](const auto& one, const auto& other) {
      return one.time_ns < other.time_ns;
    });
    const auto same = [](const auto& one, const auto& other) {
      return one.time_ns == other.time_ns;
    };
    readings_.erase(std::unique(readings_.begin(), readings_.end(), same), readings_.end());
    return std::move(readings_);
  }

 private:
  struct Place {
    std::int64_t told_ns = std::numeric_limits<std::int64_t>::min() / 2;
    double x_m = not_known;
    double y_m = not_known;
  };
  void add(const topic::NetworkQuality::Message& quality, std::int64_t sent_ns) {
    Reading reading;
    reading.time_ns = sent_ns;
    if (sent_ns - place_.told_ns <= place_age_ns) {
      reading.x_m = place_.x_m;
      reading.y_m = place_.y_m;
    }
    reading.signal_dbm = static_cast<double>(quality.signal_dbm());
    reading.loss_percent = static_cast<double>(quality.per_percent());
    reading.qni = qni_;
    reading.battery_percent = battery_percent_;
    readings_.push_back(reading);
  }
  Place place_;
  double battery_percent_ = not_known;
  double qni_ = not_known;
  std::vector<Reading> readings_;
};

/// Counts the messages of a file.
class Counts {
 public:
  explicit Counts(const mcap::Summary& summary) : summary_(summary) {}
  /// Returns the topic.
  const std::string& take(const mcap::Message& message) {
    const mcap::Channel& channel = summary_.channels.at(message.channel_id);
    const auto [found, is_new] = topics_.try_emplace(channel.topic);
    TopicExcerpt& topic = found->second;
    const auto at_ns = static_cast<std::int64_t>(message.log_time_ns);
    if (is_new) {
      const auto schema = summary_.schemas.find(channel.schema_id);
      topic.topic = channel.topic;
      topic.type = schema == summary_.schemas.end() ? "" : schema->second.name;
      topic.from_ns = topic.to_ns = at_ns;
    }
    ++topic.messages;
    topic.from_ns = std::min(topic.from_ns, at_ns);
    topic.to_ns = std::max(topic.to_ns, at_ns);
    std::uint32_t& last = last_[message.channel_id];
    if (last != 0 && message.sequence > last) topic.gaps += message.sequence - last - 1;
    last = message.sequence;
    return channel.topic;
  }
  void add_to(Excerpt& excerpt) {
    for (auto& [name, topic] : topics_) {
      const bool is_first = excerpt.topics.empty();
      excerpt.from_ns = is_first ? topic.from_ns : std::min(excerpt.from_ns, topic.from_ns);
      excerpt.to_ns = is_first ? topic.to_ns : std::max(excerpt.to_ns, topic.to_ns);
      excerpt.topics.push_back(std::move(topic));
    }
  }

 private:
  const mcap::Summary& summary_;
  std::map<std::string, TopicExcerpt> topics_;
  std::map<std::uint16_t, std::uint32_t> last_;  ///< sequence number, by channel
};

}  // namespace

Excerpt excerpt_of(const std::string& path) {
  mcap::Reader reader(path);
  Counts counts(reader.summary());
  Readings readings;
  const auto messages = reader.messages();
  std::uint64_t count = 0;
  while (const auto message = messages->next()) {
    readings.take(counts.take(*message), *message);
    ++count;
  }
  const mcap::Damage& damage = reader.damage();
  const bool lacks_some = count != reader.summary().statistics.message_count;
  if (damage.no_summary || damage.cut_at || damage.chunks > 0 || lacks_some) {
    throw ConfigError(path + ": is damaged; tocsin bag recover saves what is whole");
  }
  Excerpt excerpt;
  counts.add_to(excerpt);
  excerpt.readings = readings.take_all();
  return excerpt;
}

}  // namespace tocsin::archive
