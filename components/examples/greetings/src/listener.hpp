// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "example_idl/topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace example {

/// Logs each greeting.
class Listener final : public tocsin::Component {
 public:
  struct Params {
    template <class Visitor>
    void visit(Visitor&) {}
  };
  Listener(tocsin::Context& context, const Params&) : Component(context) {}
  void tick(tocsin::Time now) override;

 private:
  tocsin::Input<Greetings> greetings_{*this};
};

}  // namespace example
