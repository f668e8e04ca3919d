// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <fastdds/dds/core/condition/WaitSet.hpp>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "measure.hpp"

namespace tocsin::bench {

/// What the rival sends.
enum class RawType {
  octets,   ///< a sequence of octets, coded by one memcpy
  message,  ///< the components' message, coded as the code of Fast DDS-Gen does
};

/// A participant on a link: where it is, and whom it looks for. IPv4.
struct RawLink {
  std::string address;
  std::string peer;
};

/// The rival: Fast DDS as its manual shows it, reliable, depth 4, buffers that are reused, large
/// socket buffers.
class RawParticipant {
 public:
  explicit RawParticipant(int domain, RawType type = RawType::octets);
  /// On a link: components' messages, best effort, in RTPS messages of at most 1400 bytes.
  RawParticipant(int domain, const RawLink& link);
  ~RawParticipant();
  RawParticipant(const RawParticipant&) = delete;
  RawParticipant& operator=(const RawParticipant&) = delete;

  /// One of its type with so many octets.
  [[nodiscard]] std::shared_ptr<void> sample(std::size_t octets) const;
  [[nodiscard]] eprosima::fastdds::dds::DataWriter* writer(const std::string& topic);
  eprosima::fastdds::dds::DataReader* reader(
      const std::string& topic, eprosima::fastdds::dds::DataReaderListener* listener = nullptr);

 private:
  eprosima::fastdds::dds::Topic* topic(const std::string& name);
  RawType type_;
  bool reliable_ = true;
  eprosima::fastdds::dds::DomainParticipant* participant_;
};

/// Takes all that waits; `sample` holds the last.
int take_all(eprosima::fastdds::dds::DataReader& reader, void* sample);

/// Calls `on_sample` inside the middleware's thread: what a listener is.
class RawListener : public eprosima::fastdds::dds::DataReaderListener {
 public:
  RawListener(const RawParticipant& participant, std::function<void(void* sample)> on_sample)
      : on_sample_(std::move(on_sample)), sample_(participant.sample(0)) {}
  void on_data_available(eprosima::fastdds::dds::DataReader* reader) override;

 private:
  std::function<void(void*)> on_sample_;
  std::shared_ptr<void> sample_;
};

/// Waits for samples of one reader on the caller's thread.
class RawWaiter {
 public:
  explicit RawWaiter(eprosima::fastdds::dds::DataReader& reader);
  /// The number of samples taken; 0 when none came within 100 ms.
  int wait(void* sample);

 private:
  eprosima::fastdds::dds::DataReader& reader_;
  eprosima::fastdds::dds::WaitSet waits_;
};

/// Answers pings on a thread of its own, read by a wait-set.
class RawEcho {
 public:
  explicit RawEcho(RawParticipant& participant, bool silent = false);
  ~RawEcho();
  void run();

 private:
  bool silent_;
  std::shared_ptr<void> sample_;
  eprosima::fastdds::dds::DataReader* reader_;
  eprosima::fastdds::dds::DataWriter* writer_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// Writes pings and waits for the pongs on the caller's thread.
class RawPing {
 public:
  RawPing(RawParticipant& participant, std::size_t octets);
  [[nodiscard]] bool run(int count, Series& series);

 private:
  std::shared_ptr<void> ping_;
  std::shared_ptr<void> pong_;
  eprosima::fastdds::dds::DataWriter* writer_;
  eprosima::fastdds::dds::DataReader* reader_;
  RawWaiter waiter_;
};

}  // namespace tocsin::bench
