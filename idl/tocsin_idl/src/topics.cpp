// SPDX-License-Identifier: Apache-2.0
#include "tocsin_idl/topics.hpp"

#include "idl_support/topic_registry.hpp"

namespace tocsin {
namespace {

[[maybe_unused]] const bool registered =
    register_topics(topic::AllLinkTopics{}) && register_topics(topic::AllHostTopics{});

}  // namespace
}  // namespace tocsin
