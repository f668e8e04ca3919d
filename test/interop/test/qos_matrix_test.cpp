// SPDX-License-Identifier: Apache-2.0
// What is offered against what is requested, between our runtime and Cyclone DDS in both
// directions, compared with the table of the DDS specification (formal/15-04-10, section 2.2.3).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <list>
#include <map>
#include <ros_idl/std_msgs.hpp>
#include <sstream>

#include "cyclone.hpp"
#include "qos_cases.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "std_msgs.h"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int domain = 27;

dds_duration_t duration_of(double s) {
  return std::isinf(s) ? DDS_INFINITY : static_cast<dds_duration_t>(s * 1e9);
}

dds_liveliness_kind_t liveliness_of(const QosContract& contract) {
  if (contract.liveliness == Liveliness::automatic) return DDS_LIVELINESS_AUTOMATIC;
  return contract.liveliness == Liveliness::manual_by_topic ? DDS_LIVELINESS_MANUAL_BY_TOPIC
                                                            : DDS_LIVELINESS_MANUAL_BY_PARTICIPANT;
}

CycloneParticipant::Qos qos_of(const QosContract& contract) {
  auto qos = CycloneParticipant::qos();
  dds_qset_reliability(qos.get(),
                       contract.reliable() ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_durability(
      qos.get(), contract.keeps_last() ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_deadline(qos.get(), duration_of(contract.deadline_s));
  dds_qset_liveliness(qos.get(), liveliness_of(contract), duration_of(contract.liveliness_lease_s));
  dds_qset_ownership(qos.get(),
                     contract.exclusive() ? DDS_OWNERSHIP_EXCLUSIVE : DDS_OWNERSHIP_SHARED);
  return qos;
}

CycloneParticipant::Qos partition_of(const QosContract& contract) {
  auto qos = CycloneParticipant::qos();
  std::vector<const char*> names;
  for (const std::string& one : contract.partition) names.push_back(one.c_str());
  if (!names.empty()) {
    dds_qset_partition(qos.get(), static_cast<std::uint32_t>(names.size()), names.data());
  }
  return qos;
}

struct Nobody : Receiver {
  void receive(const Sample&) override {}
};

/// One case in both directions, a topic each.
class Pairs {
 public:
  Pairs(Bus& bus, const CycloneParticipant& cyclone, const Case& its, int number)
      : case_(its), number_(std::to_string(number)) {
    const TypeInfo& type = type_info<std_msgs::msg::String>();
    const auto topic = [&](const std::string& name) {
      return cyclone.topic(std_msgs_msg_String_desc, "rt/" + name, type.name);
    };
    const dds_entity_t subscriber = checked(
        dds_create_subscriber(cyclone.entity(), partition_of(its.requested).get(), nullptr));
    const dds_entity_t publisher =
        checked(dds_create_publisher(cyclone.entity(), partition_of(its.offered).get(), nullptr));
    reader_ = checked(
        dds_create_reader(subscriber, topic(written_), qos_of(its.requested).get(), nullptr));
    writer_ =
        checked(dds_create_writer(publisher, topic(read_), qos_of(its.offered).get(), nullptr));
    publication_ = bus.advertise({{written_.c_str(), offered_.c_str(), Scope::host}, &type});
    subscription_ =
        bus.subscribe({{read_.c_str(), requested_.c_str(), Scope::host}, &type}, nobody_);
  }
  [[nodiscard]] std::string profiles() const { return profiles(case_, number_); }
  static std::string profiles(const Case& its, const std::string& number) {
    return profile("offered_" + number, its.offered) +
           profile("requested_" + number, its.requested);
  }
  /// Whether Cyclone DDS has decided about both.
  [[nodiscard]] bool decided() const {
    dds_requested_incompatible_qos_status_t requested{};
    dds_offered_incompatible_qos_status_t offered{};
    (void)dds_get_requested_incompatible_qos_status(reader_, &requested);
    (void)dds_get_offered_incompatible_qos_status(writer_, &offered);
    refused_ = refused_ + requested.total_count_change + offered.total_count_change;
    return static_cast<int>(cyclone_reads()) + static_cast<int>(cyclone_is_read()) +
               static_cast<int>(refused_) >=
           2;
  }
  [[nodiscard]] bool cyclone_reads() const {
    dds_subscription_matched_status_t status{};
    (void)dds_get_subscription_matched_status(reader_, &status);
    return status.current_count > 0;
  }
  [[nodiscard]] bool cyclone_is_read() const {
    dds_publication_matched_status_t status{};
    (void)dds_get_publication_matched_status(writer_, &status);
    return status.current_count > 0;
  }
  [[nodiscard]] const Case& its_case() const { return case_; }
  [[nodiscard]] const std::string& written() const { return written_; }
  [[nodiscard]] const std::string& read() const { return read_; }

 private:
  const Case case_;
  const std::string number_;
  const std::string written_ = "written_" + number_;
  const std::string read_ = "read_" + number_;
  const std::string offered_ = "offered_" + number_;
  const std::string requested_ = "requested_" + number_;
  mutable std::uint32_t refused_ = 0;
  dds_entity_t reader_ = 0;
  dds_entity_t writer_ = 0;
  Nobody nobody_;
  std::unique_ptr<Publication> publication_;
  std::unique_ptr<Subscription> subscription_;
};

std::unique_ptr<Bus> make_bus(const std::vector<Case>& cases) {
  const std::string path = ::testing::TempDir() + "matrix_qos.yaml";
  {
    std::ofstream file(path);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      file << Pairs::profiles(cases[i], std::to_string(i));
    }
  }
  BusOptions options;
  options.name = "matrix";
  options.qos_file = path;
  options.host_domain = domain;
  return make_fast_dds_bus(options);
}

std::map<std::string, EndpointHealth> health_of(Bus& bus) {
  std::map<std::string, EndpointHealth> by_topic;
  for (EndpointHealth& one : bus.host_control().health()) by_topic[one.topic] = std::move(one);
  return by_topic;
}

std::string described(const Case& its) {
  std::string text = profile("offered", its.offered) + profile("requested", its.requested);
  return its.policy + "\n" + text +
         (fits(its.offered, its.requested) ? "should match" : "should not");
}

/// What stands in the README: of each policy how many pairs were tried, and how many match.
std::string table(const std::vector<Case>& cases) {
  std::map<std::string, std::pair<int, int>> rows;
  for (const Case& one : cases) {
    ++rows[one.policy].first;
    rows[one.policy].second += fits(one.offered, one.requested) ? 1 : 0;
  }
  std::ostringstream text;
  text
      << "| policy | pairs in each direction | match by the specification |\n| --- | --- | --- |\n";
  for (const auto& [policy, counts] : rows) {
    text << "| " << policy << " | " << counts.first << " | " << counts.second << " |\n";
  }
  return text.str();
}

/// Where one of the makers has decided otherwise than the specification, so far.
std::vector<std::string> differences(Bus& bus, const std::list<Pairs>& all) {
  std::vector<std::string> found;
  const auto health = health_of(bus);
  for (const Pairs& one : all) {
    const bool expected = fits(one.its_case().offered, one.its_case().requested);
    const auto expect = [&](bool matched, const char* where) {
      if (matched != expected) {
        found.push_back(std::string(where) + ": " + described(one.its_case()));
      }
    };
    expect(one.cyclone_reads(), "reader of Cyclone DDS");
    expect(one.cyclone_is_read(), "writer of Cyclone DDS");
    expect(health.at(one.written()).matched > 0, "our writer");
    expect(health.at(one.read()).matched > 0, "our reader");
  }
  return found;
}

TEST(QosMatrix, OfferedAgainstRequestedIsDecidedByBothMakersAsTheSpecificationSays) {
  const std::vector<Case> cases = all_cases();
  const auto bus = make_bus(cases);
  const CycloneParticipant cyclone(domain);
  std::list<Pairs> all;
  for (const Case& one : cases) all.emplace_back(*bus, cyclone, one, static_cast<int>(all.size()));
  (void)eventually([&] {
    const bool decided =
        std::all_of(all.begin(), all.end(), [](const Pairs& one) { return one.decided(); });
    return decided && differences(*bus, all).empty();
  });
  EXPECT_THAT(differences(*bus, all), IsEmpty());
}

/// POSIX fnmatch, which the specification names, knows sets of characters; Cyclone DDS 0.10.2 does
/// not. The README says so.
TEST(QosMatrix, CycloneDdsTakesNoSetsOfCharactersInPartitions) {
  Case set{"partition", {}, {}};
  set.offered.partition = {"a"};
  set.requested.partition = {"[ab]"};
  ASSERT_TRUE(fits(set.offered, set.requested));
  const auto bus = make_bus({set});
  const CycloneParticipant cyclone(domain);
  const Pairs sut(*bus, cyclone, set, 0);
  ASSERT_TRUE(eventually([&] { return sut.decided(); }));
  EXPECT_FALSE(sut.cyclone_reads());
  EXPECT_FALSE(sut.cyclone_is_read());
  EXPECT_TRUE(eventually([&] { return health_of(*bus).at(sut.written()).matched == 1; }));
}

/// By the specification two expressions do not meet. Fast DDS 2.9.1 compares them as names first;
/// the README says so.
TEST(QosMatrix, FastDdsLetsTheSameExpressionMeetItselfAndCycloneDdsDoesNot) {
  Case same{"partition", {}, {}};
  same.offered.partition = same.requested.partition = {"a*"};
  ASSERT_FALSE(fits(same.offered, same.requested));
  const auto bus = make_bus({same});
  const CycloneParticipant cyclone(domain);
  const Pairs sut(*bus, cyclone, same, 0);
  ASSERT_TRUE(eventually([&] { return sut.decided(); }));
  EXPECT_FALSE(sut.cyclone_reads());
  EXPECT_FALSE(sut.cyclone_is_read());
  EXPECT_TRUE(eventually([&] { return health_of(*bus).at(sut.written()).matched == 1; }));
}

TEST(QosMatrix, ThePageOfFiguresSaysWhatIsTried) {
  std::ifstream file(std::string(TOCSIN_SOURCE_DIR) + "/../bench/figures/interop.md");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr(table(all_cases())));
}

}  // namespace
}  // namespace tocsin::interop
