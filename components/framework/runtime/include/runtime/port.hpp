// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "runtime/bus.hpp"
#include "runtime/component.hpp"
#include "runtime/detail/sample_queue.hpp"

namespace tocsin {

/// Whether a sample that comes asks for a tick (event triggered), or waits for the next one (time
/// triggered: of a component that acts at its own rate, and would only look at it before).
enum class WakeMode { event_triggered, time_triggered };

/// The reading end of a topic, without its C++ type: a queue that drops its oldest sample when it
/// is full. Filled by the bus from any thread, emptied by the component's tick.
class InputPort : private Receiver {
 public:
  InputPort(Component& owner, const Endpoint& endpoint, WakeMode wake = WakeMode::event_triggered);
  ~InputPort() override;

  /// Whether there is one to take; costs nothing.
  [[nodiscard]] bool has_sample() const { return has_sample_.load(std::memory_order_relaxed); }
  /// The oldest sample that was not taken yet.
  [[nodiscard]] std::optional<Sample> take_sample();
  [[nodiscard]] std::shared_ptr<const void> take_message();  ///< null when there is none
  [[nodiscard]] PortHealth health() const;                   ///< any thread
  /// Who wrote a sample with this source, see Subscription::writer. The component's thread only.
  [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const;
  /// For the container: unsubscribes and forgets what waits, or subscribes again as a late joiner.
  void listen(bool on);

 private:
  static constexpr std::size_t capacity = 64;
  void receive(const Sample& sample) override { receive_last(Sample(sample)); }
  void receive_last(Sample&& sample) override;
  Component& owner_;
  const Endpoint endpoint_;
  const WakeMode wake_mode_;
  mutable std::mutex mutex_;
  SampleQueue queue_{capacity};
  std::atomic<bool> has_sample_{false};  ///< so that to look into an empty queue takes no lock
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
  explicit Input(Component& owner, WakeMode wake = WakeMode::event_triggered,
                 Writers writers = Writers::needed)
      : InputPort(owner, {Topic::info, &type_info<Message>(), writers}, wake) {}

  /// The oldest message that was not taken yet; null when there is none.
  [[nodiscard]] std::shared_ptr<const Message> take() {
    if (!has_sample()) return nullptr;
    return std::static_pointer_cast<const Message>(take_message());
  }
  /// The newest message; all older ones are dropped. Null when nothing new came.
  [[nodiscard]] std::shared_ptr<const Message> take_latest() {
    std::shared_ptr<const Message> newest;
    while (auto message = take()) newest = std::move(message);
    return newest;
  }
};

/// An input that may well have no writer in a deployment: what people order now and then, what is
/// shown or recorded if there is any. `tocsin check` does not warn of it.
template <class Topic>
class OptionalInput : public Input<Topic> {
 public:
  explicit OptionalInput(Component& owner, WakeMode wake = WakeMode::event_triggered)
      : Input<Topic>(owner, wake, Writers::optional) {}
};

/// Member of a component that writes a topic of tocsin_idl/topics.hpp. Link topics cross by the
/// host's router.
template <class Topic>
class Output {
 public:
  using Message = typename Topic::Message;
  /// `user_data`: see Endpoint; all outputs of a process to one topic must have the same.
  explicit Output(Component& owner, const char* user_data = "")
      : publication_(owner.bus().advertise(
            {Topic::info, &type_info<Message>(), Writers::needed, user_data, owner.node()})) {}

  /// Never blocks on the network. Readers in this process get the very object, unserialised.
  Status write(Message message) {
    return publication_->write(std::make_shared<const Message>(std::move(message)));
  }
  /// The same for an object that exists already, for example one that was taken from an input.
  Status write(const std::shared_ptr<const Message>& message) {
    return publication_->write(message);
  }
  /// False: nobody would get it now, nor later, so that a message may as well not be made.
  [[nodiscard]] bool wanted() const { return publication_->has_readers(); }
  /// Whether somebody reads now: enough for what is written often, though its last sample is kept.
  [[nodiscard]] bool is_read() const { return publication_->is_read(); }

 private:
  std::unique_ptr<Publication> publication_;
};

}  // namespace tocsin
