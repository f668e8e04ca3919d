// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tocsin {

/// What a thread of DDS is there for.
enum class Duty {
  reception,      ///< begins with a packet and ends when Fast DDS has taken it
  announcements,  ///< the participant's timer, which must go on whatever else happens
};

/// How often a thread of DDS has begun and ended its work: the thread counts, the watchdog reads.
class Activity {
 public:
  Activity(Duty duty, std::string name, std::uint16_t port)
      : duty_(duty), name_(std::move(name)), port_(port) {}
  void begin() { begun_.fetch_add(1, std::memory_order_relaxed); }
  void end() { ended_.fetch_add(1, std::memory_order_relaxed); }

  [[nodiscard]] Duty duty() const { return duty_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::uint64_t begun() const { return begun_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t ended() const { return ended_.load(std::memory_order_relaxed); }

 private:
  const Duty duty_;
  const std::string name_;
  const std::uint16_t port_;
  std::atomic<std::uint64_t> begun_{0};
  std::atomic<std::uint64_t> ended_{0};
};

/// One packet, or announcement, in the hands of a thread.
class ActivityTurn {
 public:
  explicit ActivityTurn(Activity& activity) : activity_(activity) { activity_.begin(); }
  ~ActivityTurn() { activity_.end(); }
  ActivityTurn(const ActivityTurn&) = delete;
  ActivityTurn& operator=(const ActivityTurn&) = delete;

 private:
  Activity& activity_;
};

/// An activity that this process's watchdog looks at as long as somebody holds it. Any thread.
/// `name` is what a person reads; `port`: of the UDP socket that it reads, 0: none.
[[nodiscard]] std::shared_ptr<Activity> watched_activity(Duty duty, std::string name,
                                                         std::uint16_t port = 0);
/// Those that somebody holds. Any thread.
[[nodiscard]] std::vector<std::shared_ptr<const Activity>> watched_activities();

}  // namespace tocsin
