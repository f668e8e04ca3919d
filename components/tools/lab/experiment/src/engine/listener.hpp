// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "runtime/component.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::experiment {

/// Stands in for the recorder of a simulated run: reads the same topics in the same process, so
/// that the radio carries the same packets, but keeps nothing and touches no disk.
class Listener final : public Component {
 public:
  struct Params {
    template <class Visitor>
    void visit(Visitor&) {}
  };
  Listener(Context& context, const Params& params);
  void tick(Time) override {}

 private:
  /// A reader that wakes nobody.
  class NullReceiver final : public Receiver {
   public:
    void receive(const Sample&) override {}
  };
  template <class... Topics>
  void listen_to(topic::List<Topics...>);

  NullReceiver receiver_;
  std::vector<std::unique_ptr<Subscription>> heard_;
};

}  // namespace tocsin::experiment
