// SPDX-License-Identifier: Apache-2.0
// What a policy means, for each of its values that means something of its own.
#include "meanings.hpp"

#include <gtest/gtest.h>

#include "policy_values.hpp"

namespace tocsin::qos_tool {
namespace {

/// A profile, given by what differs from the defaults, and what one of its policies means.
struct Case {
  Values values;
  const char* policy;
  const char* meaning;
};

void expect_meanings(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    EXPECT_EQ(meaning_of(one.policy, profile_of(one.values, "case")), one.meaning) << one.policy;
  }
}

TEST(Meanings, EveryPolicyOfAProfileHasOne) {
  for (const PolicyValue& one : values_of({}))
    EXPECT_NE(meaning_of(one.policy, {}), "") << one.policy;
  EXPECT_EQ(meaning_of("colour", {}), "");
}

TEST(Meanings, OfWhatAWriterOffers) {
  expect_meanings({
      {{}, "reliability", "a lost sample is sent again, until it is acknowledged or superseded"},
      {{{"reliability", "best_effort"}},
       "reliability",
       "a lost sample stays lost; nothing is acknowledged"},
      {{}, "durability", "a reader that comes later waits for the next sample"},
      {{{"durability", "transient_local"}, {"depth", "3"}},
       "durability",
       "a reader that comes later gets the last 3 sample(s) of each writer at once"},
      {{{"durability", "transient_local"}, {"history", "keep_all"}},
       "durability",
       "a reader that comes later gets the last samples of each writer at once"},
      {{}, "deadline_s", "no gap between samples is too long"},
      {{{"deadline_s", "0.5"}},
       "deadline_s",
       "a gap of more than 0.5 s between samples is counted as missed, at both ends"},
      {{}, "ownership", "readers hear all writers"},
      {{{"ownership", "exclusive"}},
       "ownership",
       "readers hear one writer, the strongest that lives"},
      {{}, "partition", "the partition without name, as all who say nothing"},
      {{{"partition", "[a, b*]"}},
       "partition",
       "only ends that share one of these names, or an expression of them, match: a, b*"},
  });
}

TEST(Meanings, OfSignsOfLife) {
  const Values lease{{"liveliness_lease_s", "3"}};
  const auto of_kind = [&lease](const char* kind) {
    Values values = lease;
    values["liveliness"] = kind;
    return values;
  };
  expect_meanings({
      {{}, "liveliness", "nobody is declared dead by this topic"},
      {{}, "liveliness_lease_s", "silence means nothing"},
      {{}, "liveliness_announcement_s", "no signs of life, as there is no lease"},
      {lease, "liveliness", "the writer lives as long as its process speaks"},
      {of_kind("manual_by_participant"), "liveliness",
       "the writer lives as long as some writer of its process writes"},
      {of_kind("manual_by_topic"), "liveliness", "the writer lives as long as it writes itself"},
      {lease, "liveliness_lease_s", "after 3 s of silence readers count the writer as dead"},
      {lease, "liveliness_announcement_s", "a sign of life each 1 s, a third of the lease"},
      {{{"liveliness_lease_s", "3"}, {"liveliness_announcement_s", "0.5"}},
       "liveliness_announcement_s",
       "a sign of life each 0.5 s"},
  });
}

TEST(Meanings, OfWhatIsKept) {
  const Values all{{"history", "keep_all"}, {"max_samples", "20"}};
  expect_meanings({
      {{}, "history", "of each writer the newest samples are kept, see depth"},
      {all, "history",
       "all samples are kept until they are taken; a reliable writer whose 20 places are full "
       "waits for 0.1 s, then refuses"},
      {{{"depth", "5"}},
       "depth",
       "5 sample(s) of a writer wait for a slow reader; a newer one takes the place of the oldest"},
      {all, "depth", "means nothing with keep_all"},
      {{}, "lifespan_s", "a sample is delivered however old it is"},
      {{{"lifespan_s", "1"}}, "lifespan_s", "a sample older than 1 s is not delivered any more"},
      {{{"depth", "5"}}, "max_samples", "each end has room for 6 samples"},
      {{}, "allocated_samples", "memory for 1 of them is taken at start"},
      {{}, "extra_samples", "1 more while samples are being sent"},
      {{}, "memory_policy", "memory of old samples is used again for new ones"},
      {{{"memory_policy", "dynamic"}},
       "memory_policy",
       "each sample gets memory of its size and gives it back"},
      {{{"memory_policy", "preallocated_with_realloc"}},
       "memory_policy",
       "memory of a guessed size is taken at start, and grown"},
  });
}

TEST(Meanings, OfWhenTheEndsTalk) {
  expect_meanings({
      {{}, "max_blocking_time_s", "a write never waits, as keep_last makes room"},
      {{{"history", "keep_all"}},
       "max_blocking_time_s",
       "a write into a full history waits for 0.1 s, then fails"},
      {{}, "initial_heartbeat_delay_s", "the first word to a new reader waits for 0.012 s"},
      {{{"initial_heartbeat_delay_s", "0"}},
       "initial_heartbeat_delay_s",
       "the first word to a new reader does not wait"},
      {{},
       "heartbeat_period_s",
       "a lost last sample is noticed 0.2 s later at the latest; each period costs a packet while "
       "something is unacknowledged"},
      {{}, "nack_response_delay_s", "a repair that a reader asked for does not wait"},
      {{}, "nack_suppression_s", "every repair that is asked for is sent"},
      {{{"nack_suppression_s", "0.01"}},
       "nack_suppression_s",
       "a repair asked for within 0.01 s of the sample is not sent"},
      {{}, "heartbeat_piggyback", "a filling history is told with the data"},
      {{{"heartbeat_piggyback", "false"}},
       "heartbeat_piggyback",
       "a filling history is told with heartbeats only"},
      {{}, "initial_acknack_delay_s", "a reader's first word to a new writer waits for 0.07 s"},
      {{}, "heartbeat_response_delay_s", "a reader answers a heartbeat after 0.005 s, the least"},
      {{{"heartbeat_response_delay_s", "0.02"}},
       "heartbeat_response_delay_s",
       "a reader's answer to a heartbeat waits for 0.02 s"},
  });
}

TEST(Meanings, OfHowSamplesLeaveAndArrive) {
  const Values bound{{"flow_controller", "radio"}, {"priority", "-3"}};
  expect_meanings({
      {{}, "publish_mode", "write() sends by itself, before it returns"},
      {bound, "publish_mode", "a thread of the middleware sends, write() returns at once"},
      {{}, "flow_controller", "no bound on bytes per second"},
      {bound, "flow_controller", "its bytes per second are bound, see flow_controllers"},
      {{}, "priority", "means nothing without a flow controller"},
      {bound, "priority", "-3 of -10 (first) to 10 (last)"},
      {{}, "bandwidth_reservation_percent", "no share of the flow controller is kept for it"},
      {{{"bandwidth_reservation_percent", "30"}},
       "bandwidth_reservation_percent",
       "30 % of the flow controller is kept for it"},
      {{}, "ownership_strength", "means nothing with shared ownership"},
      {{{"ownership", "exclusive"}, {"ownership_strength", "4"}},
       "ownership_strength",
       "a writer of more than 4 takes over"},
      {{}, "requested_reliability", "our readers ask for what the writers offer"},
      {{{"requested_reliability", "best_effort"}},
       "requested_reliability",
       "our readers ask for no repair, and so hear best-effort writers, too"},
      {{}, "max_rate_hz", "a writer sends all that it is given"},
      {{{"max_rate_hz", "5"}},
       "max_rate_hz",
       "a writer drops and counts what is more than 5 a second"},
      {{}, "minimum_separation_s", "a reader gets all that arrives"},
      {{{"minimum_separation_s", "0.5"}},
       "minimum_separation_s",
       "a reader drops what follows within 0.5 s"},
      {{}, "user_data", "nothing is announced beside the topic's layout"},
      {{{"user_data", "x=1;"}}, "user_data", "is announced with each end, beside the layout"},
  });
}

}  // namespace
}  // namespace tocsin::qos_tool
