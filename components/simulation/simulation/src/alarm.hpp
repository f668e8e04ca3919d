// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>

#include "core.hpp"

namespace tocsin::simulation {

/// Wakes a model that says when it has work next.
class Alarm {
 public:
  using Next = std::function<Time()>;
  using Work = std::function<void()>;
  /// `work` is done at the time that `next` tells; both live as long as the core's events.
  Alarm(Core& core, Next next, Work work)
      : core_(core), next_(std::move(next)), work_(std::move(work)) {}
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

  /// After every call to the model.
  void update() {
    const Time next = next_();
    if (next >= asked_) return;
    asked_ = next;
    core_.events.at(next, [this, next] { ring(next); });
  }

 private:
  /// One that was asked for later, or earlier than the model now needs, does nothing.
  void ring(Time time) {
    if (time != asked_) return;
    asked_ = never;
    if (next_() <= core_.now) work_();
    update();
  }
  Core& core_;
  Next next_;
  Work work_;
  Time asked_ = never;
};

}  // namespace tocsin::simulation
