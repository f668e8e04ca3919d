// SPDX-License-Identifier: Apache-2.0
#include "rtps_filter/rtps_filter.hpp"

#include <utility>

#include "participants.hpp"
#include "sources.hpp"
#include "structure.hpp"

namespace tocsin::rtps_filter {

struct RtpsFilter::State {
  explicit State(Limits its_limits) : limits(std::move(its_limits)) {}
  const Limits limits;
  Participants participants{limits};
  Sources sources{limits};
};

namespace {

/// Holds a packet of sound structure against what is known of its sender.
template <class State>
class Admission {
 public:
  Admission(State& state, const Header& header, Source from, Time now)
      : state_(state), header_(header), from_(from), now_(now) {}

  Inspection admit(const std::uint8_t* bytes, std::size_t size) {
    Inspection inspection;
    Seals seals;
    Submessages submessages(bytes, size);
    while (const auto submessage = submessages.next()) {
      seals.pass(submessage->kind);
      const bool sealed = state_.limits.secured && seals.sealed();
      inspection.drop =
          admit(*submessage, {header_, state_.limits, bytes, sealed}, inspection.strip);
      if (inspection.drop) break;
    }
    return inspection;
  }

 private:
  Wrong admit(const Submessage& submessage, const Context& context,
              std::vector<std::size_t>& strip) {
    if (submessage.kind == kind::data) return admit_data(submessage, context, strip);
    if (submessage.kind == kind::heartbeat) {
      const auto read = read_heartbeat(submessage);
      return state_.participants.heartbeat(header_.prefix, std::get<Heartbeat>(read), now_);
    }
    if (submessage.kind == kind::gap) {
      return state_.participants.gap(header_.prefix, std::get<Gap>(read_gap(submessage)), now_);
    }
    return std::nullopt;
  }

  Wrong admit_data(const Submessage& submessage, const Context& context,
                   std::vector<std::size_t>& strip) {
    const Data data = std::get<Data>(read_data(submessage));
    const Purpose purpose = purpose_of(data.reader, data.writer);
    if (purpose != Purpose::participants && purpose != Purpose::endpoints) return std::nullopt;
    const auto what = std::get<Announcement>(read_announcement(data, context));
    if (const Wrong wrong = state_.sources.announcement(from_, now_)) return wrong;
    strip.insert(strip.end(), what.strip.begin(), what.strip.end());
    if (purpose == Purpose::endpoints) return state_.participants.endpoint(header_.prefix, what);
    return state_.participants.announced(header_.prefix, what, from_, now_);
  }

  State& state_;
  const Header& header_;
  const Source from_;
  const Time now_;
};

}  // namespace

RtpsFilter::RtpsFilter(Limits limits) : state_(std::make_unique<State>(std::move(limits))) {}
RtpsFilter::~RtpsFilter() = default;
RtpsFilter::RtpsFilter(RtpsFilter&&) noexcept = default;
RtpsFilter& RtpsFilter::operator=(RtpsFilter&&) noexcept = default;

Inspection RtpsFilter::inspect(const std::uint8_t* bytes, std::size_t size, Source from, Time now) {
  const Limits& limits = state_->limits;
  if (limits.hears && !limits.hears(from.address)) return {DropReason::unknown_source, {}};
  if (const Wrong wrong = state_->sources.packet(from, size, now)) return {wrong, {}};
  const auto header = read_header(bytes, size);
  if (!header) return {DropReason::not_rtps, {}};
  const Survey found = survey(bytes, size, *header, limits);
  if (found.wrong) return {found.wrong, {}};
  if (const Wrong wrong = state_->participants.heard(header->prefix, from, now)) return {wrong, {}};
  if (!found.needs_memory) return {};
  return Admission<State>(*state_, *header, from, now).admit(bytes, size);
}

std::size_t RtpsFilter::participants() const { return state_->participants.size(); }

}  // namespace tocsin::rtps_filter
