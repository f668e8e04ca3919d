// SPDX-License-Identifier: Apache-2.0
// The program as a user runs it: what it prints, and how it ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "foundation/temporary_folder.hpp"

namespace tocsin::doctor {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// A bringup file with a ground station at `address`.
std::string bringup(const std::string& address) {
  return "qos: qos.yaml\ntraffic: qos.yaml\ndomain: 60\n"
         "hosts:\n  gcs:\n    role: gcs\n    address: " +
         address +
         "\n    peers: [127.0.0.1]\n    containers:\n      - {name: a, components: [recorder]}\n";
}

class DoctorProgram : public ::testing::Test {
 protected:
  DoctorProgram() { folder_.write("qos.yaml", ""); }
  int run(const std::string& arguments) {
    const std::string command =
        "cd " + folder_.path() + " && " DOCTOR_PROGRAM " " + arguments + " >out 2>err";
    const int status = std::system(command.c_str());
    output_ = folder_.read("out");
    error_ = folder_.read("err");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  TemporaryFolder folder_;
  std::string output_;
  std::string error_;
};

TEST_F(DoctorProgram, JudgesThisComputerAndSaysHowManyAreBad) {
  const int code = run("");
  EXPECT_EQ(error_, "");
  EXPECT_THAT(output_, AllOf(HasSubstr("net.core.rmem_max"), HasSubstr("net.core.wmem_max"),
                             HasSubstr("/dev/shm: ")));
  EXPECT_THAT(output_, ContainsRegex("\n5 looked at, [0-9] bad\n$"));
  EXPECT_EQ(code,
            output_.find("\nBAD") == std::string::npos && output_.rfind("BAD", 0) != 0 ? 0 : 1)
      << output_;
}

TEST_F(DoctorProgram, LooksAtTheEmulatedRadioOfAFile) {
  folder_.write("one.yaml", bringup("127.0.0.1"));
  (void)run("one.yaml");
  EXPECT_THAT(output_, Not(HasSubstr("/dev/net/tun")));
  folder_.write("c.yaml", "{}");
  folder_.write("radio.yaml",
                "domain: 60\nradio: {channel: c.yaml, walls: c.yaml}\nhosts:\n"
                "  uxv: {role: uxv, address: 10.77.0.1, programs: [{name: p, command: [x]}]}\n"
                "  gcs: {role: gcs, address: 10.77.0.2, programs: [{name: p, command: [x]}]}\n");
  (void)run("radio.yaml");
  EXPECT_THAT(output_, AllOf(HasSubstr("/dev/net/tun"), HasSubstr("etwork"))) << error_;
}

TEST_F(DoctorProgram, LooksAtTheRealRadioOfAFile) {
  folder_.write("one.yaml", bringup("192.0.2.1"));
  EXPECT_EQ(run("one.yaml"), 1);
  EXPECT_THAT(output_,
              HasSubstr("BAD  gcs: address 192.0.2.1: no interface with carrier has it\n"));
}

TEST_F(DoctorProgram, AFileThatIsNotThereOrWrongIsOneLineAndCodeTwo) {
  EXPECT_EQ(run("nowhere.yaml"), 2);
  EXPECT_THAT(error_, AllOf(HasSubstr("tocsin doctor: "), HasSubstr("nowhere.yaml")));
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  folder_.write("wrong.yaml", bringup("no_address"));
  EXPECT_EQ(run("wrong.yaml"), 2);
  EXPECT_THAT(error_, AllOf(HasSubstr("hosts.gcs.address"), HasSubstr("wrong.yaml:7")));
  EXPECT_EQ(output_, "");
}

}  // namespace
}  // namespace tocsin::doctor
