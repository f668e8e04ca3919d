// SPDX-License-Identifier: Apache-2.0
#include "link_router/sent_pieces.hpp"

#include <memory>

namespace tocsin::router {
namespace {

void add_to_whole(const SentSample& piece) {
  SentSample& whole = *piece.whole;
  ++whole.received_pieces;
  whole.late = whole.late || piece.late;
  whole.repaired = whole.repaired || piece.repaired;
  if (whole.received_pieces < piece.piece.count) return;
  whole.received = true;
  whole.missing.clear();
}

}  // namespace

std::vector<SentSamplePtr> cut(const SentSamplePtr& sent, std::size_t largest) {
  const std::size_t bytes = sent->sample.bytes;
  const std::uint8_t count = count_pieces(bytes, largest);
  if (count == 1) return {sent};
  sent->open_pieces = count;
  sent->lost_pieces = 0;
  sent->received_pieces = 0;
  sent->arrives = false;
  std::vector<SentSamplePtr> pieces;
  WireCost burst;
  for (std::uint8_t i = 0; i < count; ++i) {
    const auto one = std::make_shared<SentSample>(*sent);
    one->whole = sent;
    one->piece = {i, count};
    one->cost = wire_cost(bytes, one->piece);
    burst = {burst.packets + one->cost.packets, burst.bytes + one->cost.bytes};
    one->burst_cost = burst;
    pieces.push_back(one);
  }
  return pieces;
}

bool conclude_piece(SentSample& piece) {
  SentSample& whole = *piece.whole;
  if (!piece.missing.empty()) {
    piece.fate = SentSample::Fate::lost;
    ++whole.lost_pieces;
  } else if (piece.received) {
    piece.fate = SentSample::Fate::delivered;
    add_to_whole(piece);
  } else {
    piece.fate = SentSample::Fate::unwanted;
  }
  if (--whole.open_pieces > 0) return false;
  if (whole.lost_pieces == 0) whole.missing.clear();
  return true;
}

bool revoke_loss(SentSample& piece) {
  SentSample& whole = *piece.whole;
  piece.fate = SentSample::Fate::delivered;
  --whole.lost_pieces;
  add_to_whole(piece);
  return whole.received && whole.fate == SentSample::Fate::lost;
}

}  // namespace tocsin::router
