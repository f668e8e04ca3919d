// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin {

/// What a recorder has written so far, from its folder (`RUN/uxv`), as a CSV text: the fields of a
/// topic. Empty when there is no message of it.
[[nodiscard]] std::string recorded_fields(const std::string& folder, const std::string& topic);

/// The same with a row for each message of any topic: times, topic, writer, sequence, bytes.
[[nodiscard]] std::string recorded_messages(const std::string& folder);

}  // namespace tocsin
