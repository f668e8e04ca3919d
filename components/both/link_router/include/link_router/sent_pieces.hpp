// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "link_router/delivery_log.hpp"

namespace tocsin::router {

/// The pieces of at most `largest` bytes in which a sample is sent, each with a fate of its own;
/// itself when it goes whole.
[[nodiscard]] std::vector<SentSamplePtr> cut(const SentSamplePtr& sent, std::size_t largest);
/// The fate of a piece is decided. Whether that of its whole is now, too: `missing`, `received`,
/// `late` and `repaired` of the whole say which.
[[nodiscard]] bool conclude_piece(SentSample& piece);
/// A piece that was given up has been received all the same. Whether its whole was given up and has
/// now been received.
[[nodiscard]] bool revoke_loss(SentSample& piece);

}  // namespace tocsin::router
