// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "mcap/reader.hpp"

namespace tocsin::mcap {

/// `summary` and `source` must outlive the stream; damage that it comes by is added to `damage`.
[[nodiscard]] std::unique_ptr<MessageStream> make_message_stream(ByteSource& source,
                                                                 const Summary& summary,
                                                                 Query query, Damage& damage);

}  // namespace tocsin::mcap
