// SPDX-License-Identifier: Apache-2.0
#include "rtps_filter/rtps_filter.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "fragments.hpp"
#include "participants.hpp"
#include "sources.hpp"
#include "structure.hpp"

namespace tocsin::rtps_filter {

struct RtpsFilter::State {
  explicit State(Limits its_limits) : limits(std::move(its_limits)) {}
  const Limits limits;
  Participants participants{limits};
  Sources sources{limits};
  Fragments best_effort{Fragments::Rule::hide_all};  ///< fragments of SPDP and of authentication
  Fragments reliable{Fragments::Rule::hide_last};    ///< of SEDP and of liveliness
};

std::vector<std::uint8_t> changed(const std::uint8_t* bytes, std::size_t size,
                                  const Inspection& inspection) {
  constexpr std::uint8_t pid_pad = 0;
  std::vector<std::uint8_t> copy(bytes, bytes + size);
  for (const std::size_t at : inspection.strip) std::fill_n(copy.data() + at, 2, pid_pad);
  for (const std::size_t at : inspection.hide) copy[at] = kind::pad;
  for (const auto& step : inspection.step) {
    std::copy_n(step.bytes.begin(), step.size, copy.data() + step.at);
  }
  return copy;
}

namespace {

/// Holds a packet of sound structure against what is known of its sender.
template <class State>
class Admission {
 public:
  Admission(State& state, const Header& header, Source from, Time now)
      : state_(state), header_(header), from_(from), now_(now) {}

  Inspection admit(const std::uint8_t* bytes, std::size_t size) {
    Seals seals;
    Submessages submessages(bytes, size);
    Place place{bytes};
    while (const auto submessage = submessages.next()) {
      seals.pass(submessage->kind);
      if (submessage->kind == kind::info_dst) place.destination = submessage->content.here();
      const bool sealed = state_.limits.secured && seals.sealed();
      const Context context{header_, state_.limits, bytes, sealed};
      const bool fragment = submessage->kind == kind::data_frag && !sealed;
      inspection_.drop =
          fragment ? admit_fragment(*submessage, place) : admit_one(*submessage, context, place);
      if (inspection_.drop) break;
    }
    return std::move(inspection_);
  }

 private:
  Wrong admit_one(const Submessage& submessage, const Context& context, const Place& place) {
    if (submessage.kind == kind::data) return admit_data(submessage, context);
    if (submessage.kind == kind::heartbeat) return admit_heartbeat(submessage, context, place);
    if (submessage.kind == kind::gap) {
      const Gap gap = std::get<Gap>(read_gap(submessage));
      return state_.participants.gap(header_.prefix, gap, addressee(gap.reader, place), now_);
    }
    return std::nullopt;
  }

  static Addressee addressee(std::uint32_t reader, const Place& place) {
    Addressee to{{}, reader};
    if (place.destination != nullptr) {
      std::copy_n(place.destination, to.participant.size(), to.participant.begin());
    }
    return to;
  }

  Wrong admit_heartbeat(const Submessage& submessage, const Context& context, const Place& place) {
    if (context.sealed) return std::nullopt;  // cannot be changed, and comes from who may
    const Heartbeat heartbeat = std::get<Heartbeat>(read_heartbeat(submessage));
    const Addressee to = addressee(heartbeat.reader, place);
    const auto read = state_.participants.heartbeat(header_.prefix, heartbeat, to, now_);
    if (const auto* const wrong = std::get_if<DropReason>(&read)) return *wrong;
    const auto [first, jumps] = std::get<Participants::Told>(read);
    inspection_.jumps = inspection_.jumps || jumps;
    if (first == heartbeat.first) return std::nullopt;
    const auto content = static_cast<std::size_t>(submessage.content.here() - context.packet);
    replace(content + heartbeat_numbers_at,
            numbers_of(first, first - 1, submessage.content.little()));
    return std::nullopt;
  }

  Wrong admit_data(const Submessage& submessage, const Context& context) {
    const Data data = std::get<Data>(read_data(submessage));
    const Purpose purpose = purpose_of(data.reader, data.writer);
    if (purpose != Purpose::participants && purpose != Purpose::endpoints) return std::nullopt;
    const auto what = std::get<Announcement>(read_announcement(data, context));
    if (const Wrong wrong = state_.sources.announcement(from_, now_)) return wrong;
    inspection_.strip.insert(inspection_.strip.end(), what.strip.begin(), what.strip.end());
    if (purpose == Purpose::endpoints) return state_.participants.endpoint(header_.prefix, what);
    return admit_participant(submessage, what, context);
  }

  Wrong admit_participant(const Submessage& submessage, const Announcement& what,
                          const Context& context) {
    if (context.sealed) return std::nullopt;  // comes from who may, of whom Fast DDS knows the key
    if (!what.leaves && state_.limits.finds && !state_.limits.finds(what.user_data)) {
      hide(submessage, context.packet);
      return std::nullopt;
    }
    auto read = state_.participants.announced(header_.prefix, what, from_, now_);
    if (const auto* const wrong = std::get_if<DropReason>(&read)) return *wrong;
    auto& verdict = std::get<Participants::Verdict>(read);
    std::move(verdict.before.begin(), verdict.before.end(), std::back_inserter(inspection_.before));
    if (verdict.hide) hide(submessage, context.packet);
    if (what.leaves) return std::nullopt;
    if (verdict.number != what.number) {
      replace(number_place(submessage, context.packet),
              number_bytes(verdict.number, submessage.content.little()));
    }
    if (what.lease_at && state_.limits.longest_lease > Duration{}) {
      replace(what.lease_at->at, lease_bytes(what.lease, what.lease_at->little));
    }
    if (state_.limits.departure_wait > Duration{}) {
      state_.participants.shown(header_.prefix, {submessage, what, context, inspection_});
    }
    return std::nullopt;
  }

  template <std::size_t size>
  void replace(std::size_t at, const std::array<std::uint8_t, size>& bytes) {
    Inspection::Step step{at, size, {}};
    std::copy(bytes.begin(), bytes.end(), step.bytes.begin());
    inspection_.step.push_back(step);
  }

  void hide(const Submessage& submessage, const std::uint8_t* packet) {
    constexpr std::size_t submessage_header = 4;
    const auto content = static_cast<std::size_t>(submessage.content.here() - packet);
    inspection_.hide.push_back(content - submessage_header);
  }

  /// Looks at a sample of discovery once all of it is there, which nobody behind must have before.
  Wrong admit_fragment(const Submessage& submessage, const Place& place) {
    const Data data = std::get<Data>(read_data_frag(submessage, state_.limits.sample_bytes));
    const Purpose purpose = purpose_of(data.reader, data.writer);
    if (purpose == Purpose::user_data) {
      return state_.participants.fragment(header_.prefix, data, now_);
    }
    const bool reliable = purpose == Purpose::endpoints || purpose == Purpose::liveliness;
    FragmentFate fate;
    if (inspection_.before.empty()) {  // else one at a time; it is sent again
      fate = reliable ? add_reliable(submessage, data, place)
                      : state_.best_effort.add(submessage, data, place);
    }
    if (fate.hide) hide(submessage, place.packet);
    if (!fate.whole) return std::nullopt;
    if (const Wrong wrong = admit_whole(*fate.whole)) return wrong;
    if (reliable) state_.reliable.close();
    inspection_.before.push_back(reliable ? as_fragments(*fate.whole, data.fragments)
                                          : *fate.whole);
    return std::nullopt;
  }

  /// Of participants that Fast DDS does not know it takes nothing, either.
  FragmentFate add_reliable(const Submessage& submessage, const Data& data, const Place& place) {
    const auto is_known = [this](const Prefix& who) { return state_.participants.knows(who); };
    if (!is_known(header_.prefix)) return {};
    if (state_.reliable.full()) state_.reliable.keep(is_known);
    return state_.reliable.add(submessage, data, place);
  }

  Wrong admit_whole(std::vector<std::uint8_t>& whole) {
    const Survey found = survey(whole.data(), whole.size(), header_, state_.limits);
    if (found.wrong) return found.wrong;
    Inspection inspection =
        Admission(state_, header_, from_, now_).admit(whole.data(), whole.size());
    whole = changed(whole.data(), whole.size(), inspection);
    std::move(inspection.before.begin(), inspection.before.end(),
              std::back_inserter(inspection_.before));
    return inspection.drop;
  }

  State& state_;
  const Header& header_;
  const Source from_;
  const Time now_;
  Inspection inspection_;
};

Inspection dropped(DropReason reason) {
  Inspection inspection;
  inspection.drop = reason;
  return inspection;
}

}  // namespace

RtpsFilter::RtpsFilter(Limits limits) : state_(std::make_unique<State>(std::move(limits))) {}
RtpsFilter::~RtpsFilter() = default;
RtpsFilter::RtpsFilter(RtpsFilter&&) noexcept = default;
RtpsFilter& RtpsFilter::operator=(RtpsFilter&&) noexcept = default;

Inspection RtpsFilter::inspect(const std::uint8_t* bytes, std::size_t size, Source from, Time now,
                               Sender sender) {
  const Limits& limits = state_->limits;
  if (sender == Sender::other) return dropped(DropReason::other_user);
  if (limits.hears && !limits.hears(from.address)) return dropped(DropReason::unknown_source);
  if (const Wrong wrong = state_->sources.packet(from, size, now)) return dropped(*wrong);
  const auto header = read_header(bytes, size);
  if (!header) return dropped(DropReason::not_rtps);
  const Survey found = survey(bytes, size, *header, limits);
  if (found.wrong) return dropped(*found.wrong);
  if (sender == Sender::gone && !says_goodbye(bytes, size, {*header, limits, bytes, false})) {
    return dropped(DropReason::closed_socket);
  }
  if (const Wrong wrong = state_->participants.heard(header->prefix, from, now))
    return dropped(*wrong);
  if (state_->participants.waits() && !says_goodbye(bytes, size, {*header, limits, bytes, false})) {
    state_->participants.stays(header->prefix, now);
  }
  Inspection inspection;
  if (found.needs_memory) {
    inspection = Admission<State>(*state_, *header, from, now).admit(bytes, size);
  }
  return inspection;
}

void RtpsFilter::authenticate(const std::array<std::uint8_t, 12>& prefix) {
  state_->participants.authenticate(prefix);
}

void RtpsFilter::supersede(const std::array<std::uint8_t, 12>& prefix, Time now) {
  state_->participants.supersede(prefix, now);
}

void RtpsFilter::forget(const std::array<std::uint8_t, 12>& prefix) {
  state_->participants.forget(prefix);
}

std::vector<std::vector<std::uint8_t>> RtpsFilter::take_due() {
  return state_->participants.take_due();
}

void RtpsFilter::took(Duration cpu, Time now) { state_->participants.took(cpu, now); }

std::size_t RtpsFilter::participants() const { return state_->participants.size(); }

}  // namespace tocsin::rtps_filter
