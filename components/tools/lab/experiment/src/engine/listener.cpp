// SPDX-License-Identifier: Apache-2.0
#include "engine/listener.hpp"

#include "runtime/component_entry.hpp"

namespace tocsin::experiment {

Listener::Listener(Context& context, const Params&) : Component(context) {
  listen_to(topic::AllLinkTopics{});
}

template <class... Topics>
void Listener::listen_to(topic::List<Topics...>) {
  (heard_.push_back(
       bus().subscribe({Topics::info, &type_info<typename Topics::Message>()}, receiver_)),
   ...);
}

}  // namespace tocsin::experiment

TOCSIN_COMPONENT(tocsin::experiment::Listener)
