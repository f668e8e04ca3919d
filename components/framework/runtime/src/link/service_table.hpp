// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "fast_dds/remote_ends.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/middleware/host_services.hpp"

namespace tocsin {

/// Who serves and calls what on a host, from what discovery tells, and what has happened there.
/// Any thread; `on_event` is called without a lock held.
class ServiceTable {
 public:
  using Guid = eprosima::fastdds::rtps::GUID_t;
  ServiceTable(const std::string& ros_namespace, std::function<void()> on_event);

  /// An end of whatever topic was announced, or is gone.
  void on_end(const Guid& guid, const AnnouncedEnd& end, bool there);
  /// Requests and replies that come when 1024 events wait are lost.
  void push(HostServiceEvent event);
  [[nodiscard]] std::optional<HostServiceEvent> pop();

 private:
  enum class Side { server, client };
  struct End {
    HostService what;
    Side side;
  };
  [[nodiscard]] std::optional<End> end_in(const AnnouncedEnd& end) const;
  void tell(const End& end, bool there);

  const std::string prefix_;  ///< "/" or "/namespace/"
  const std::function<void()> on_event_;
  std::mutex mutex_;
  std::map<Guid, End> ends_;
  std::deque<HostServiceEvent> events_;
};

}  // namespace tocsin
