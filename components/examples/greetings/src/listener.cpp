// SPDX-License-Identifier: Apache-2.0
#include "listener.hpp"

#include "runtime/component_entry.hpp"

namespace example {

void Listener::tick(tocsin::Time) {
  while (const auto greeting = greetings_.take()) {
    log().info("heard {}, number {}", greeting->text(), greeting->number());
  }
}

}  // namespace example

TOCSIN_COMPONENT(example::Listener)
