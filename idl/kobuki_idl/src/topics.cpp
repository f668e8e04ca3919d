// SPDX-License-Identifier: Apache-2.0
#include "kobuki_idl/topics.hpp"

#include "idl_support/topic_registry.hpp"

namespace tocsin {
namespace {

[[maybe_unused]] const bool registered = register_topics(topic::AllKobukiTopics{});

}  // namespace
}  // namespace tocsin
