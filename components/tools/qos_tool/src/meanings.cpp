// SPDX-License-Identifier: Apache-2.0
#include "meanings.hpp"

#include <fmt/core.h>

#include <cmath>
#include <map>

#include "foundation/joined.hpp"
#include "runtime/middleware/qos_matching.hpp"

namespace tocsin::qos_tool {
namespace {

using P = QosProfile;
using Meaning = std::string (*)(const P& profile);
using Meanings = std::map<std::string, Meaning>;

std::string reliability(const P& p) {
  return p.reliable() ? "a lost sample is sent again, until it is acknowledged or superseded"
                      : "a lost sample stays lost; nothing is acknowledged";
}

std::string liveliness(const P& p) {
  if (std::isinf(p.liveliness_lease_s)) return "nobody is declared dead by this topic";
  switch (p.liveliness) {
    case Liveliness::automatic:
      return "the writer lives as long as its process speaks";
    case Liveliness::manual_by_participant:
      return "the writer lives as long as some writer of its process writes";
    case Liveliness::manual_by_topic:
      return "the writer lives as long as it writes itself";
  }
  return "";
}

std::string history(const P& p) {
  if (!p.keeps_all()) return "of each writer the newest samples are kept, see depth";
  return fmt::format(
      "all samples are kept until they are taken; a reliable writer whose {} places "
      "are full waits for {}, then refuses",
      p.room(), duration_text(p.max_blocking_time_s));
}

std::string durability(const P& p) {
  if (!p.keeps_last()) return "a reader that comes later waits for the next sample";
  return fmt::format("a reader that comes later gets the last {} of each writer at once",
                     p.keeps_all() ? "samples" : fmt::format("{} sample(s)", p.depth));
}

std::string partition(const P& p) {
  if (p.partition.empty()) return "the partition without name, as all who say nothing";
  return "only ends that share one of these names, or an expression of them, match: " +
         joined(p.partition);
}

const Meanings& contract() {
  static const Meanings meanings{
      {"reliability", reliability},
      {"durability", durability},
      {"deadline_s",
       [](const P& p) {
         return std::isinf(p.deadline_s)
                    ? std::string("no gap between samples is too long")
                    : fmt::format(
                          "a gap of more than {} between samples is counted as missed, at "
                          "both ends",
                          duration_text(p.deadline_s));
       }},
      {"liveliness", liveliness},
      {"liveliness_lease_s",
       [](const P& p) {
         return std::isinf(p.liveliness_lease_s)
                    ? std::string("silence means nothing")
                    : fmt::format("after {} of silence readers count the writer as dead",
                                  duration_text(p.liveliness_lease_s));
       }},
      {"ownership",
       [](const P& p) {
         return std::string(p.exclusive() ? "readers hear one writer, the strongest that lives"
                                          : "readers hear all writers");
       }},
      {"partition", partition}};
  return meanings;
}

const Meanings& keeping() {
  static const Meanings meanings{
      {"history", history},
      {"depth",
       [](const P& p) {
         return p.keeps_all() ? std::string("means nothing with keep_all")
                              : fmt::format(
                                    "{} sample(s) of a writer wait for a slow reader; a "
                                    "newer one takes the place of the oldest",
                                    p.depth);
       }},
      {"lifespan_s",
       [](const P& p) {
         return std::isinf(p.lifespan_s)
                    ? std::string("a sample is delivered however old it is")
                    : fmt::format("a sample older than {} is not delivered any more",
                                  duration_text(p.lifespan_s));
       }},
      {"max_samples",
       [](const P& p) { return fmt::format("each end has room for {} samples", p.room()); }},
      {"allocated_samples",
       [](const P& p) {
         return fmt::format("memory for {} of them is taken at start", p.allocated_samples);
       }},
      {"extra_samples",
       [](const P& p) {
         return fmt::format("{} more while samples are being sent", p.extra_samples);
       }},
      {"memory_policy", [](const P& p) {
         switch (p.memory_policy) {
           case MemoryPolicy::dynamic:
             return std::string("each sample gets memory of its size and gives it back");
           case MemoryPolicy::dynamic_reusable:
             return std::string("memory of old samples is used again for new ones");
           default:
             return std::string("memory of a guessed size is taken at start, and grown");
         }
       }}};
  return meanings;
}

std::string waits(double s, const char* what) {
  return s > 0 ? fmt::format("{} waits for {}", what, duration_text(s))
               : fmt::format("{} does not wait", what);
}

const Meanings& timing() {
  static const Meanings meanings{
      {"max_blocking_time_s",
       [](const P& p) {
         return p.keeps_all() ? fmt::format("a write into a full history waits for {}, then fails",
                                            duration_text(p.max_blocking_time_s))
                              : std::string("a write never waits, as keep_last makes room");
       }},
      {"initial_heartbeat_delay_s",
       [](const P& p) {
         return waits(p.initial_heartbeat_delay_s, "the first word to a new reader");
       }},
      {"heartbeat_period_s", [](const P& p) {
         return fmt::format(
             "a lost last sample is noticed {} later at the latest; each period costs "
             "a packet while something is unacknowledged",
             duration_text(p.heartbeat_period_s));
       }}};
  return meanings;
}

const Meanings& answers() {
  static const Meanings meanings{
      {"nack_response_delay_s",
       [](const P& p) {
         return waits(p.nack_response_delay_s, "a repair that a reader asked for");
       }},
      {"nack_suppression_s",
       [](const P& p) {
         return p.nack_suppression_s > 0
                    ? fmt::format("a repair asked for within {} of the sample is not sent",
                                  duration_text(p.nack_suppression_s))
                    : std::string("every repair that is asked for is sent");
       }},
      {"heartbeat_piggyback",
       [](const P& p) {
         return std::string(p.heartbeat_piggyback
                                ? "a filling history is told with the data"
                                : "a filling history is told with heartbeats only");
       }},
      {"initial_acknack_delay_s",
       [](const P& p) {
         return waits(p.initial_acknack_delay_s, "a reader's first word to a new writer");
       }},
      {"heartbeat_response_delay_s",
       [](const P& p) {
         return p.heartbeat_response_delay_s > 0.005
                    ? waits(p.heartbeat_response_delay_s, "a reader's answer to a heartbeat")
                    : std::string("a reader answers a heartbeat after 0.005 s, the least");
       }},
      {"liveliness_announcement_s", [](const P& p) {
         if (std::isfinite(p.liveliness_announcement_s)) {
           return fmt::format("a sign of life each {}", duration_text(p.liveliness_announcement_s));
         }
         return std::isinf(p.liveliness_lease_s)
                    ? std::string("no signs of life, as there is no lease")
                    : fmt::format("a sign of life each {}, a third of the lease",
                                  duration_text(p.liveliness_lease_s / 3));
       }}};
  return meanings;
}

std::string publish_mode(const P& p) {
  const bool asynchronous =
      p.publish_mode == PublishMode::asynchronous ||
      (p.publish_mode == PublishMode::automatic && !p.flow_controller.empty());
  return asynchronous ? "a thread of the middleware sends, write() returns at once"
                      : "write() sends by itself, before it returns";
}

const Meanings& delivery() {
  static const Meanings meanings{
      {"publish_mode", publish_mode},
      {"flow_controller",
       [](const P& p) {
         return p.flow_controller.empty() ? std::string("no bound on bytes per second")
                                          : "its bytes per second are bound, see flow_controllers";
       }},
      {"priority",
       [](const P& p) {
         return p.flow_controller.empty()
                    ? std::string("means nothing without a flow controller")
                    : fmt::format("{} of -10 (first) to 10 (last)", p.priority);
       }},
      {"bandwidth_reservation_percent", [](const P& p) {
         return p.bandwidth_reservation_percent == 0
                    ? std::string("no share of the flow controller is kept for it")
                    : fmt::format("{} % of the flow controller is kept for it",
                                  p.bandwidth_reservation_percent);
       }}};
  return meanings;
}

const Meanings& reception() {
  static const Meanings meanings{
      {"ownership_strength",
       [](const P& p) {
         return p.exclusive()
                    ? fmt::format("a writer of more than {} takes over", p.ownership_strength)
                    : std::string("means nothing with shared ownership");
       }},
      {"requested_reliability",
       [](const P& p) {
         return std::string(
             p.requested_reliability == RequestedReliability::best_effort
                 ? "our readers ask for no repair, and so hear best-effort writers, too"
                 : "our readers ask for what the writers offer");
       }},
      {"max_rate_hz",
       [](const P& p) {
         return std::isinf(p.max_rate_hz)
                    ? std::string("a writer sends all that it is given")
                    : fmt::format("a writer drops and counts what is more than {:g} a second",
                                  p.max_rate_hz);
       }},
      {"minimum_separation_s",
       [](const P& p) {
         return p.minimum_separation_s > 0 ? fmt::format("a reader drops what follows within {}",
                                                         duration_text(p.minimum_separation_s))
                                           : std::string("a reader gets all that arrives");
       }},
      {"user_data", [](const P& p) {
         return std::string(p.user_data.empty() ? "nothing is announced beside the topic's layout"
                                                : "is announced with each end, beside the layout");
       }}};
  return meanings;
}

}  // namespace

std::string meaning_of(const std::string& policy, const QosProfile& profile) {
  for (const Meanings* const some :
       {&contract(), &keeping(), &timing(), &answers(), &delivery(), &reception()}) {
    const auto found = some->find(policy);
    if (found != some->end()) return found->second(profile);
  }
  return "";
}

}  // namespace tocsin::qos_tool
