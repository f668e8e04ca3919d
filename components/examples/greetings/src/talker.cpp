// SPDX-License-Identifier: Apache-2.0
#include "talker.hpp"

#include <utility>

#include "runtime/component_entry.hpp"

namespace example {

Talker::Talker(tocsin::Context& context, const Params& params)
    : Component(context), params_(params) {
  wake_every(tocsin::seconds(params.period_s));
}

void Talker::tick(tocsin::Time) {
  Greetings::Message greeting;
  greeting.text(params_.text);
  greeting.number(++said_);
  if (greetings_.write(std::move(greeting)) == tocsin::Status::failed) {
    log().warn("a greeting was lost");
  }
}

}  // namespace example

TOCSIN_COMPONENT(example::Talker)
