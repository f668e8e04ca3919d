// SPDX-License-Identifier: Apache-2.0
#include "operator_server/what_if.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tocsin::foxglove {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string fault_of(const std::string& query) {
  const auto parsed = parse_what_if(query);
  const auto* const fault = std::get_if<std::string>(&parsed);
  return fault == nullptr ? "none" : *fault;
}

TEST(WhatIfTest, NamesHostPolicyAndParameters) {
  const auto question = std::get<WhatIf>(
      parse_what_if("host=gcs&policy=tocp&token=abc&alpha=3.5&good_family=normal"));
  EXPECT_EQ(question.host, Role::gcs);
  EXPECT_EQ(question.policy, "tocp");
  EXPECT_THAT(question.changes, ElementsAre("alpha=3.5", "good_family=normal"));
  EXPECT_THAT(std::get<WhatIf>(parse_what_if("host=uxv")).policy, IsEmpty());
}

TEST(WhatIfTest, HasOneFaultThatNamesThePlace) {
  EXPECT_EQ(fault_of(""), "host '' is not one of: uxv, gcs");
  EXPECT_EQ(fault_of("host=moon"), "host 'moon' is not one of: uxv, gcs");
  EXPECT_EQ(fault_of("host=uxv&policy=a%20b"), "policy 'a%20b' is no name");
  EXPECT_EQ(fault_of("host=uxv&policy=--json"), "policy '--json' is no name");
  EXPECT_EQ(fault_of("host=uxv&alpha=;reboot"), "'alpha=;reboot' is no parameter=value");
  EXPECT_EQ(fault_of("host=uxv&alpha"), "'alpha=' is no parameter=value");
  EXPECT_EQ(fault_of("host=uxv&--table=x"), "'--table=x' is no parameter=value");
  EXPECT_THAT(fault_of("host=uxv&alpha=" + std::string(101, '1')), HasSubstr("alpha=111"));
  std::string many = "host=uxv";
  for (int i = 0; i < 21; ++i) many += "&p" + std::to_string(i) + "=1";
  EXPECT_EQ(fault_of(many), "21 parameters; at most 20");
}

TEST(WhatIfTest, IsACommandWithoutAShell) {
  EXPECT_THAT(what_if_command("/bin/decide", "/run/a.csv", {Role::uxv, "tocp", {"alpha=3"}}),
              ElementsAre("/bin/decide", "/run/a.csv", "--host", "uxv", "--json", "--rows",
                          "--policy", "tocp", "--set", "alpha=3"));
  EXPECT_THAT(what_if_command("d", "f", {Role::gcs, ""}),
              ElementsAre("d", "f", "--host", "gcs", "--json", "--rows"));
}

TEST(WhatIfTest, KeepsTheLastRowsAndNoFolders) {
  const std::string printed =
      R"({"file": "/home/a", "parameters": [], "policy": "tocp", "pauses": 2,
          "rows": [{"time_s": 10.0}, {"time_s": 20.0}, {"time_s": 30.5}]})";
  const auto said = nlohmann::json::parse(last_rows(printed, 10.5));
  EXPECT_EQ(said, nlohmann::json::parse(
                      R"({"policy": "tocp", "pauses": 2,
                          "rows": [{"time_s": 20.0}, {"time_s": 30.5}]})"));
}

TEST(WhatIfTest, ATextThatIsNotTheToolsStays) {
  for (const char* text : {"", "{", "[]", "{\"a\":1}"}) EXPECT_EQ(last_rows(text, 1), text);
  EXPECT_EQ(last_rows(R"({"rows":[]})", 1), R"({"rows":[]})");
}

}  // namespace
}  // namespace tocsin::foxglove
