// SPDX-License-Identifier: Apache-2.0
#include <linux/nl80211.h>
#include <netlink/attr.h>
#include <netlink/genl/genl.h>
#include <netlink/msg.h>

#include <array>
#include <cstdint>

#include "nl80211.hpp"

namespace tocsin::network {
namespace {

template <std::size_t max>
using Attributes = std::array<nlattr*, max + 1>;
template <std::size_t max>
using Policy = std::array<nla_policy, max + 1>;

nla_policy of_type(std::uint16_t type) {
  nla_policy policy{};
  policy.type = type;
  return policy;
}

/// The attributes of a message when it is the wanted command and whole.
std::optional<Attributes<NL80211_ATTR_MAX>> attributes_of(nl_msg* message, std::uint8_t command) {
  nlmsghdr* header = nlmsg_hdr(message);
  if (!genlmsg_valid_hdr(header, 0)) return std::nullopt;
  auto* generic = static_cast<genlmsghdr*>(nlmsg_data(header));
  if (generic->cmd != command) return std::nullopt;
  Attributes<NL80211_ATTR_MAX> found{};
  const int error = nla_parse(found.data(), NL80211_ATTR_MAX, genlmsg_attrdata(generic, 0),
                              genlmsg_attrlen(generic, 0), nullptr);
  if (error < 0) return std::nullopt;
  return found;
}

/// Parses what is nested in `attribute`; empty when absent or when a value is shorter than its
/// type.
template <std::size_t max>
std::optional<Attributes<max>> nested(nlattr* attribute, const Policy<max>& policy) {
  if (!attribute) return std::nullopt;
  Attributes<max> found{};
  if (nla_parse_nested(found.data(), static_cast<int>(max), attribute, policy.data()) < 0)
    return std::nullopt;
  return found;
}

std::optional<double> dbm(const nlattr* attribute) {
  if (!attribute) return std::nullopt;
  return static_cast<double>(static_cast<std::int8_t>(nla_get_u8(attribute)));
}

std::optional<std::uint64_t> u32(const nlattr* attribute) {
  if (!attribute) return std::nullopt;
  return nla_get_u32(attribute);
}

std::optional<double> u64(const nlattr* attribute) {
  if (!attribute) return std::nullopt;
  return static_cast<double>(nla_get_u64(attribute));
}

std::optional<double> scaled(std::optional<std::uint64_t> value, double unit) {
  if (!value) return std::nullopt;
  return static_cast<double>(*value) * unit;
}

const Policy<NL80211_STA_INFO_MAX>& station_policy() {
  static const auto policy = [] {
    Policy<NL80211_STA_INFO_MAX> p{};
    for (const int i : {NL80211_STA_INFO_SIGNAL, NL80211_STA_INFO_SIGNAL_AVG})
      p[static_cast<std::size_t>(i)] = of_type(NLA_U8);
    for (const int i :
         {NL80211_STA_INFO_TX_PACKETS, NL80211_STA_INFO_TX_RETRIES, NL80211_STA_INFO_TX_FAILED,
          NL80211_STA_INFO_BEACON_LOSS, NL80211_STA_INFO_EXPECTED_THROUGHPUT})
      p[static_cast<std::size_t>(i)] = of_type(NLA_U32);
    p[NL80211_STA_INFO_TX_BITRATE] = of_type(NLA_NESTED);
    return p;
  }();
  return policy;
}

const Policy<NL80211_RATE_INFO_MAX>& rate_policy() {
  static const auto policy = [] {
    Policy<NL80211_RATE_INFO_MAX> p{};
    p[NL80211_RATE_INFO_BITRATE] = of_type(NLA_U16);
    p[NL80211_RATE_INFO_BITRATE32] = of_type(NLA_U32);
    return p;
  }();
  return policy;
}

const Policy<NL80211_SURVEY_INFO_MAX>& survey_policy() {
  static const auto policy = [] {
    Policy<NL80211_SURVEY_INFO_MAX> p{};
    p[NL80211_SURVEY_INFO_NOISE] = of_type(NLA_U8);
    p[NL80211_SURVEY_INFO_IN_USE] = of_type(NLA_FLAG);
    p[NL80211_SURVEY_INFO_TIME] = of_type(NLA_U64);
    p[NL80211_SURVEY_INFO_TIME_BUSY] = of_type(NLA_U64);
    return p;
  }();
  return policy;
}

/// The old 16-bit attribute is absent when the rate does not fit in it.
std::optional<double> bitrate_mbps(nlattr* attribute) {
  constexpr double unit_mbps = 0.1;  // nl80211.h: 100 kbit/s
  const auto rate = nested<NL80211_RATE_INFO_MAX>(attribute, rate_policy());
  if (!rate) return std::nullopt;
  if (const auto wide = u32((*rate)[NL80211_RATE_INFO_BITRATE32])) return scaled(wide, unit_mbps);
  const nlattr* narrow = (*rate)[NL80211_RATE_INFO_BITRATE];
  if (!narrow) return std::nullopt;
  return nla_get_u16(narrow) * unit_mbps;
}

WirelessReading to_reading(const Attributes<NL80211_STA_INFO_MAX>& info) {
  WirelessReading reading;
  reading.source = WirelessSource::nl80211;
  reading.associated = true;
  reading.signal_dbm = dbm(info[NL80211_STA_INFO_SIGNAL]);
  reading.signal_avg_dbm = dbm(info[NL80211_STA_INFO_SIGNAL_AVG]);
  if (reading.signal_dbm) reading.quality = link_quality(*reading.signal_dbm);
  reading.tx_packets = u32(info[NL80211_STA_INFO_TX_PACKETS]);
  reading.tx_retries = u32(info[NL80211_STA_INFO_TX_RETRIES]);
  reading.tx_failed = u32(info[NL80211_STA_INFO_TX_FAILED]);
  reading.beacon_loss = u32(info[NL80211_STA_INFO_BEACON_LOSS]);
  reading.tx_bitrate_mbps = bitrate_mbps(info[NL80211_STA_INFO_TX_BITRATE]);
  reading.expected_throughput_mbps =
      scaled(u32(info[NL80211_STA_INFO_EXPECTED_THROUGHPUT]), 1e-3);  // nl80211.h: kbit/s
  return reading;
}

}  // namespace

std::optional<WirelessReading> parse_station(nl_msg* message) {
  const auto attributes = attributes_of(message, NL80211_CMD_NEW_STATION);
  if (!attributes) return std::nullopt;
  const auto info =
      nested<NL80211_STA_INFO_MAX>((*attributes)[NL80211_ATTR_STA_INFO], station_policy());
  if (!info) return std::nullopt;
  return to_reading(*info);
}

std::optional<Survey> parse_survey(nl_msg* message) {
  const auto attributes = attributes_of(message, NL80211_CMD_NEW_SURVEY_RESULTS);
  if (!attributes) return std::nullopt;
  const auto info =
      nested<NL80211_SURVEY_INFO_MAX>((*attributes)[NL80211_ATTR_SURVEY_INFO], survey_policy());
  if (!info) return std::nullopt;
  Survey survey;
  survey.in_use = (*info)[NL80211_SURVEY_INFO_IN_USE] != nullptr;
  survey.noise_dbm = dbm((*info)[NL80211_SURVEY_INFO_NOISE]);
  survey.time_ms = u64((*info)[NL80211_SURVEY_INFO_TIME]);
  survey.busy_ms = u64((*info)[NL80211_SURVEY_INFO_TIME_BUSY]);
  return survey;
}

void add_survey(const Survey& survey, WirelessReading& reading) {
  if (!survey.in_use) return;
  reading.noise_dbm = survey.noise_dbm;
  reading.channel_time_ms = survey.time_ms;
  reading.channel_busy_ms = survey.busy_ms;
}

}  // namespace tocsin::network
