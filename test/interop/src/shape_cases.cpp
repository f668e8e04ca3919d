// SPDX-License-Identifier: Apache-2.0
#include "shape_cases.hpp"

#include <array>
#include <string>
#include <tuple>
#include <utility>

namespace tocsin::interop {
namespace {

using Codes = std::vector<Code>;

const Codes both_ok{Code::ok, Code::ok};
const Codes misfit{Code::incompatible_qos, Code::incompatible_qos};
const char* const four = " --num-instances 4";
const Codes strangers{Code::reader_not_matched, Code::data_not_received};

ShapeCase pair(const std::string& name, const std::string& publisher, const std::string& subscriber,
               Codes codes = both_ok, Check check = Check::received) {
  return {
      name, {"-P -t Square " + publisher, "-S -t Square " + subscriber}, std::move(codes), check};
}

/// A case whose subscriber prints stamps.
ShapeCase stamped(ShapeCase one, Check check, int limit) {
  one.apps.back() += " --stamps";
  one.check = check;
  one.limit = limit;
  return one;
}

/// Options of two publishers and of their subscriber.
using Three = std::array<std::string, 3>;

ShapeCase three(const std::string& name, const Three& apps, Codes codes, Check check) {
  return {name,
          {"-P -t Square " + apps[0], "-P -t Square " + apps[1], "-S -t Square " + apps[2]},
          std::move(codes),
          check};
}

void add_matching(std::vector<ShapeCase>& all) {
  all.push_back(pair("Domain_0", "", "-b"));
  all.push_back(pair("DataRepresentation_0", "-x 1", "-x 1"));
  all.push_back(pair("Reliability_0", "-b -z 0", "-b", both_ok, Check::in_order));
  all.push_back(pair("Reliability_1", "-b", "-r", misfit));
  all.push_back(pair("Reliability_2", "-r", "-b"));
  all.push_back(pair("Reliability_3", "-r", "-r"));
  all.push_back(pair("Deadline_0", "-f 3000", "-f 5000"));
  all.push_back(pair("Deadline_1", "-f 5000", "-f 5000"));
  all.push_back(pair("Deadline_2", "-f 7000", "-f 5000", misfit));
  all.push_back(pair("Deadline_3", "-f 2000 -w --write-period 3000", "-f 2000",
                     {Code::deadline_missed, Code::deadline_missed}, Check::deadline));
  all.push_back({"Topic_0", {"-P -t Circle", "-S -t Circle"}, both_ok, Check::received});
  all.push_back({"Topic_1", {"-P -t Square", "-S -t Circle"}, strangers, Check::received});
  all.push_back(pair("Partition_0", "-p p1", "-p p1"));
  all.push_back(pair("Partition_1", "-p p1", "-p p2", strangers));
  all.push_back(three("Partition_2", {"-p p1 -c BLUE", "-p x1 -c RED", "-p p*"},
                      {Code::ok, Code::reader_not_matched, Code::receiving_from_one},
                      Check::colors));
  all.push_back(pair("Durability_0", "-D v", "-D v"));
  all.push_back(pair("Durability_1", "-D v", "-D l", misfit));
  all.push_back(pair("Durability_4", "-D l", "-D v"));
  all.push_back(pair("Durability_5", "-D l", "-D l"));
  all.push_back(
      pair("Durability_16", "-z 0 -r -k 0 -D v -w", "-r -k 0 -D v", both_ok, Check::first_gone));
  all.push_back(
      pair("Durability_17", "-z 0 -r -k 0 -D l -w", "-r -k 0 -D l", both_ok, Check::first_kept));
}

void add_history_and_ownership(std::vector<ShapeCase>& all) {
  all.push_back(pair("Reliability_4", "-r -k 0 -z 0", "-r -k 0", both_ok, Check::no_losses));
  all.push_back(pair("Reliability_5", "-r -k 0 -z 0 --num-instances 4", "-r -k 0", both_ok,
                     Check::no_losses));
  for (const auto& [name, instances] : {std::pair("History_0", ""), {"History_1", four}}) {
    all.push_back(stamped(pair(name, std::string("-r -k 5 -z 0 --write-period 50") + instances,
                               "-r -k 5 --read-period 200"),
                          Check::newest_kept, 5));
  }
  all.push_back(pair("Ownership_0", "-s -1", "-s -1"));
  all.push_back(pair("Ownership_1", "-s -1", "-s 1", misfit));
  all.push_back(pair("Ownership_2", "-s 3", "-s -1", misfit));
  const Codes one{Code::ok, Code::ok, Code::receiving_from_one};
  const Codes from_both{Code::ok, Code::ok, Code::receiving_from_both};
  all.push_back(three("Ownership_3",
                      {"-s 3 -r -k 0 -c BLUE -z 20", "-s 4 -r -k 0 -c BLUE -z 30", "-s 1 -r -k 0"},
                      one, Check::sizes));
  all.push_back(three("Ownership_4",
                      {"-s 3 -r -k 0 -c BLUE -z 20", "-s 4 -r -k 0 -c RED -z 30", "-s 1 -r -k 0"},
                      from_both, Check::sizes));
  all.push_back(
      three("Ownership_5",
            {"-s -1 -r -k 0 -c BLUE -z 20", "-s -1 -r -k 0 -c BLUE -z 30", "-s -1 -r -k 0"},
            from_both, Check::sizes));
  all.push_back(three(
      "Ownership_6", {"-s -1 -r -k 0 -c BLUE -z 20", "-s -1 -r -k 0 -c RED -z 30", "-s -1 -r -k 0"},
      from_both, Check::sizes));
  all.push_back(
      three("Cft_0", {"-r -k 0 -c BLUE", "-r -k 0 -c RED", "-r -k 0 -c RED"}, one, Check::colors));
  all.push_back({"Cft_1",
                 {"-P -t Square -r -k 0 -z 0 --size-modulo 50", "-S -t Square -r -k 0 --cft"},
                 both_ok,
                 Check::at_most_20});
}

void add_lifespans(std::vector<ShapeCase>& all) {
  int number = 0;
  for (const std::string reliability : {"-r", "-b"}) {
    for (const auto& [write, lifespan_ms, read] :
         {std::tuple("100", 250, "500"), {"400", 1000, "2000"}}) {
      for (const char* const instances : {"", four}) {
        const std::string writes = reliability + (reliability == "-r" ? " -k 0" : "") +
                                   " -z 0 --write-period " + write + " --lifespan " +
                                   std::to_string(lifespan_ms) + instances;
        all.push_back(stamped(pair("Lifespan_" + std::to_string(number++), writes,
                                   reliability + " -k 0 --read-period " + read),
                              Check::short_lived, lifespan_ms));
      }
    }
  }
}

void add_instances_and_time(std::vector<ShapeCase>& all) {
  const std::string rounds = "--num-iterations 200 --num-instances 4";
  for (const auto& [name, instances] :
       {std::pair("TimeBasedFilter_0", ""), {"TimeBasedFilter_1", four}}) {
    all.push_back(stamped(pair(name, std::string("-r -k 0 -z 0 --write-period 100") + instances,
                               "-r -k 0 --time-filter 1000"),
                          Check::separated, 1000));
  }
  all.push_back(pair("FinalInstanceState_0", rounds + " --final-instance-state u", "", both_ok,
                     Check::no_writers));
  all.push_back(pair("FinalInstanceState_1", rounds + " --final-instance-state d", "", both_ok,
                     Check::disposed));
  all.push_back(pair("FinalInstanceState_2", rounds, "", both_ok, Check::no_writers));
  all.push_back(pair("LargeData_0", "-r -k 0 --additional-payload-size 100000", "-r -k 0", both_ok,
                     Check::ballast));
  add_lifespans(all);
}

}  // namespace

const std::vector<ShapeCase>& shape_cases() {
  static const std::vector<ShapeCase> cases = [] {
    std::vector<ShapeCase> all;
    add_matching(all);
    add_history_and_ownership(all);
    add_instances_and_time(all);
    return all;
  }();
  return cases;
}

Departure departure(const ShapeCase& its, Side publisher) {
  const bool ours = publisher == Side::ours;
  const char* const partition = "Cyclone DDS calls another partition incompatible QoS";
  if (its.name == "Partition_1") {
    return ours ? Departure{{Code::reader_not_matched, Code::incompatible_qos}, partition}
                : Departure{{Code::incompatible_qos, Code::data_not_received}, partition};
  }
  if (its.name == "Partition_2") {
    return ours
               ? Departure{{Code::ok, Code::reader_not_matched, Code::incompatible_qos}, partition}
               : Departure{{Code::ok, Code::incompatible_qos, Code::receiving_from_one}, partition};
  }
  const Codes no_ends{Code::ok, Code::data_not_correct};
  if (ours && its.check == Check::disposed) {
    return {no_ends,
            "Fast DDS 2.9.1 sends a hash of the key alone, which Cyclone DDS cannot turn into a "
            "colour"};
  }
  if (ours && its.check == Check::separated) {
    return {no_ends, "Cyclone DDS 0.10.2 has no time-based filter"};
  }
  return {};
}

}  // namespace tocsin::interop
