// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "rtps_model/message.hpp"

namespace tocsin::rtps {

/// Bytes that a flow controller may send in its period (Fast DDS: RTPSMessageGroup's limitation).
/// A message counts once, to however many readers it goes.
struct ByteBudget {
  std::size_t limit = 0;                       ///< 0: none
  std::size_t sent = 0;                        ///< in this period
  std::size_t pending = wire::message_header;  ///< of the message that is being packed
  /// Whether so many bytes of a sample more are too many.
  [[nodiscard]] bool is_exceeded_by(std::size_t bytes) const;
};

/// Packs the submessages of one end into messages of at most 1400 bytes. What is left is sent when
/// the group ends.
class MessageGroup {
 public:
  /// Both outlive the group; null: no budget.
  explicit MessageGroup(Sender& sender, ByteBudget* budget = nullptr);
  ~MessageGroup() { flush(); }
  MessageGroup(const MessageGroup&) = delete;
  MessageGroup& operator=(const MessageGroup&) = delete;

  /// Who gets what is added from now on. Other receivers than before begin a new message.
  void address(const std::vector<EndId>& receivers);
  /// A sample or a piece of it; false, and nothing added, when the budget has no room for it.
  [[nodiscard]] bool add_data(const SamplePtr& sample, Fragment fragment);
  void add(const Submessage& submessage);
  void flush();

 private:
  void set_length(std::size_t length);
  Sender& sender_;
  ByteBudget* budget_;
  std::vector<EndId> receivers_;
  std::shared_ptr<Message> message_;  ///< null: nothing was added since the last one
  std::size_t length_;                ///< of the RTPS message so far, without statistics
};

}  // namespace tocsin::rtps
