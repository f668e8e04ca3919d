// SPDX-License-Identifier: Apache-2.0
// Makes the topics known by their names, for example to the recorder.
#include "example_idl/topics.hpp"

#include "idl_support/topic_registry.hpp"

namespace {
[[maybe_unused]] const bool registered = tocsin::register_topics(example::AllTopics{});
}
