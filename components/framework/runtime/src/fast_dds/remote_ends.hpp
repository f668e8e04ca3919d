// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/bus.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin {

/// One end of a topic, as it is announced to other participants.
struct AnnouncedEnd {
  std::string topic;
  std::string type;
  std::string layout;  ///< layout_digest; empty: it does not tell, as other vendors
  bool writer = false;
  QosContract qos = {};                                         ///< what it offers or requests
  std::string user_data = "";                                   ///< all of it, with the layout
  double lifespan_s = std::numeric_limits<double>::infinity();  ///< of a writer's samples
};

/// The user data of an endpoint: what the profile asks for, and the layout, as "key=value;" like
/// the type hash of ROS 2. ROS 2 reads all or nothing: a key that is not of letters and digits
/// spoils the hash beside it.
[[nodiscard]] std::string with_layout(const std::string& user_data, const std::string& layout);
/// The same with the hash of ROS 2, see TypeInfo::ros_hash.
[[nodiscard]] std::string with_type_hash(const std::string& user_data, const std::string& hash);
/// What our participants announce: they are of ROS 2, and of this stack.
inline constexpr const char* participant_user_data = "enclave=/;tocsin=1;";
/// The same of one that serves a vehicle at its station; empty: of one that serves none or all.
[[nodiscard]] std::string participant_data_for(const std::string& vehicle);
/// Whether who announces the one is to find who announces the other. At a station of many vehicles
/// those that serve one have nothing to say to those that serve another, and each pair of
/// participants that know each other tells all its ends.
[[nodiscard]] bool find_each_other(const std::string& one, const std::string& other);
/// Two pieces of user data in one.
[[nodiscard]] std::string joined(const std::string& user_data, const std::string& more);
/// The layout in user data; empty when there is none.
[[nodiscard]] std::string layout_in(const std::string& user_data);
/// The hash of the type in user data; empty when there is none that can be one.
[[nodiscard]] std::string type_hash_in(const std::string& user_data);

/// The ends that other participants have announced. Thread-safe.
class RemoteEnds {
 public:
  using Guid = eprosima::fastdds::rtps::GUID_t;
  using Participant = eprosima::fastdds::rtps::GuidPrefix_t;

  /// Whoever wants to know what comes and goes. Called without a lock held.
  using OnEnd = std::function<void(const Guid&, const AnnouncedEnd&, bool there)>;
  using OnParticipant =
      std::function<void(const Participant&, const std::string& name, bool there)>;
  RemoteEnds() = default;
  RemoteEnds(OnEnd on_end, OnParticipant on_participant)
      : on_end_(std::move(on_end)), on_participant_(std::move(on_participant)) {}

  void add(const Participant& participant, const std::string& name,
           const std::string& user_data = "");
  void add(const Guid& guid, const AnnouncedEnd& end);
  /// The participant and all its ends.
  void remove(const Participant& participant);
  void remove(const Guid& guid);

  /// The type of an end opposite to `own` that is not that of `own`, and its participant; empty
  /// when there is none.
  [[nodiscard]] std::string other_type(const AnnouncedEnd& own) const;
  /// The policies by which an end opposite to `own`, of its type, will not match it, and its
  /// participant; empty when there is none. Ends of other partitions are not meant to match.
  [[nodiscard]] std::string misfit(const AnnouncedEnd& own) const;
  /// Whether `guid` has announced another layout than `own`.
  [[nodiscard]] bool has_other_layout(const Guid& guid, const AnnouncedEnd& own) const;
  /// An end and the name of its participant.
  struct Known {
    Guid guid;
    AnnouncedEnd end;
    std::string participant;
  };
  [[nodiscard]] std::vector<Known> all() const;
  /// What each end of the topic of this wire name has announced.
  [[nodiscard]] std::vector<std::string> user_data_of(const std::string& topic) const;
  /// The hash of ROS 2 that an end of this topic and type has announced; empty: none has.
  [[nodiscard]] std::string type_hash(const std::string& topic, const std::string& type) const;
  /// The topics whose wire name begins with `prefix` and that somebody writes.
  [[nodiscard]] std::vector<std::string> written_topics(const std::string& prefix) const;
  /// Whether a participant of ROS 2 is there that is none of ours.
  [[nodiscard]] bool has_ros2() const;
  /// What is known of a writer; empty fields: nothing.
  [[nodiscard]] WriterInfo writer(const Guid& guid) const;

 private:
  using Ends = std::map<Guid, AnnouncedEnd>;
  std::optional<AnnouncedEnd> forget(const Guid& guid);
  [[nodiscard]] const Ends& ends_of(const std::string& topic) const;
  /// Null: it has not announced itself.
  [[nodiscard]] const AnnouncedEnd* find(const Guid& guid) const;
  [[nodiscard]] std::string name_of(const Guid& guid) const;
  [[nodiscard]] std::string owner_of(const Guid& guid) const;
  OnEnd on_end_;
  OnParticipant on_participant_;
  mutable std::mutex mutex_;
  std::map<Participant, std::string> names_;
  std::map<Participant, std::string> participants_data_;
  std::map<std::string, Ends> ends_;    ///< by topic: health asks of each own end each second
  std::map<Guid, std::string> topics_;  ///< of each end
};

}  // namespace tocsin
