// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>

#include "idl_support/topic_info.hpp"
#include "measure.hpp"
#include "ros_idl/sensor_msgs.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace tocsin::bench {

using Blob = sensor_msgs::msg::CompressedImage;

struct PingTopic {
  using Message = Blob;
  static constexpr TopicInfo info{"ping", "bench", Scope::host};
};
struct PongTopic {
  using Message = Blob;
  static constexpr TopicInfo info{"pong", "bench", Scope::host};
};

/// When the ends of a topic talk to each other: as raw Fast DDS does by itself (a heartbeat is
/// answered within 5 ms), or as Tocsin's profiles do (at once, for quick repair on a radio).
enum class Timing { raw, tocsin };

/// A bus on a domain of its own, on loopback, with one profile `bench`: reliable, depth 4.
[[nodiscard]] std::unique_ptr<Bus> make_bench_bus(const std::string& name, int domain,
                                                  Timing timing = Timing::tocsin);
[[nodiscard]] std::shared_ptr<const Blob> blob(std::size_t bytes);

/// Writes a ping, waits for the pong, writes the next. Told from outside how often.
class Ping : public Component {
 public:
  Ping(Context& context, std::size_t bytes) : Component(context), message_(blob(bytes)) {}
  void tick(Time now) override;
  /// Any thread: do so many round trips, into `series`. Returns when they are done; false when one
  /// took longer than two seconds.
  [[nodiscard]] bool run(int count, Series& series);

 private:
  void send();
  void finish();
  Input<PongTopic> pong_{*this};
  Output<PingTopic> ping_{*this};
  std::shared_ptr<const Blob> message_;
  std::int64_t sent_ns_ = 0;
  Series* series_ = nullptr;
  std::mutex mutex_;
  std::condition_variable finished_;
  std::atomic<int> wanted_{0};
  std::atomic<bool> start_{false};
};

/// Answers each ping; a silent one only takes it.
class Pong : public Component {
 public:
  Pong(Context& context, bool silent = false) : Component(context), silent_(silent) {}
  void tick(Time now) override;

 private:
  Input<PingTopic> ping_{*this};
  Output<PongTopic> pong_{*this};
  bool silent_;
};

}  // namespace tocsin::bench
