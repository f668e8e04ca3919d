// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "runtime/bus.hpp"
#include "runtime/component.hpp"
#include "runtime/middleware/sample_queue.hpp"

namespace tocsin {

/// The reading end of a topic, without its C++ type: a queue that drops its oldest sample when it
/// is full. Filled by the bus from any thread, emptied by the component's tick.
class InputPort : private Receiver {
 public:
  InputPort(Component& owner, const Endpoint& endpoint);
  ~InputPort() override;
  InputPort(const InputPort&) = delete;
  InputPort& operator=(const InputPort&) = delete;

  /// The oldest sample that was not taken yet.
  [[nodiscard]] std::optional<Sample> take_sample();
  /// Any thread.
  [[nodiscard]] PortHealth health() const;
  /// For the container: unsubscribes and forgets what waits, or subscribes again as a late joiner.
  void listen(bool on);

 private:
  static constexpr std::size_t capacity = 64;
  void receive(const Sample& sample) override;
  Component& owner_;
  const Endpoint endpoint_;
  mutable std::mutex mutex_;
  SampleQueue queue_{capacity};
  std::uint64_t received_ = 0;
  std::uint64_t dropped_ = 0;
  Time last_{};
  std::unique_ptr<Subscription> subscription_;
};

/// Member of a component that reads a topic of tocsin_idl/topics.hpp:
///
///     tocsin::Input<tocsin::topic::Odom> odom_{*this};
template <class Topic>
class Input : public InputPort {
 public:
  using Message = typename Topic::Message;
  explicit Input(Component& owner)
      : InputPort(owner, {Topic::info, &type_info<typename Topic::Message>()}) {}

  /// The oldest message that was not taken yet; null when there is none.
  [[nodiscard]] std::shared_ptr<const Message> take() {
    const std::optional<Sample> sample = take_sample();
    return sample ? std::static_pointer_cast<const Message>(sample->message) : nullptr;
  }
  /// The newest message; all older ones are dropped. Null when nothing new came.
  [[nodiscard]] std::shared_ptr<const Message> take_latest() {
    std::shared_ptr<const Message> newest;
    while (auto message = take()) newest = std::move(message);
    return newest;
  }
};

/// Member of a component that writes a topic of tocsin_idl/topics.hpp. Link topics pass the gate.
template <class Topic>
class Output {
 public:
  using Message = typename Topic::Message;
  explicit Output(Component& owner)
      : publication_(owner.bus().advertise({Topic::info, &type_info<typename Topic::Message>()})) {}

  /// Never blocks on the network. Readers in this process get the very object, unserialised.
  Status write(Message message) {
    return publication_->write(std::make_shared<const Message>(std::move(message)));
  }
  /// The same for an object that exists already, for example one that was taken from an input.
  Status write(const std::shared_ptr<const Message>& message) {
    return publication_->write(message);
  }

 private:
  std::unique_ptr<Publication> publication_;
};

}  // namespace tocsin
