// SPDX-License-Identifier: Apache-2.0
// `tocsin service` and `tocsin param` as a user runs them, on real DDS, beside a node that serves a
// lamp and has two parameters.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/middleware/ros_parameters.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/service_port.hpp"
#include "ticked_neighbour.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;
namespace service = parameter_service;

constexpr int domain = 126;

struct SetLamp {
  using Request = std_srvs::srv::SetBool_Request;
  using Response = std_srvs::srv::SetBool_Response;
  static constexpr const char* name = "~/set";
};

/// Serves by hand what a container serves for its components.
class Lamp : public Component {
 public:
  explicit Lamp(Context& context) : Component(context) {}
  void tick(Time) override {
    while (auto call = set_.take()) {
      std_srvs::srv::SetBool_Response response;
      response.success(true);
      response.message(call->request->data() ? "on" : "off");
      set_.reply(call->id, response);
    }
    answer_parameters();
  }

 private:
  std::vector<ParameterFacts> facts() const {
    return {{"brightness", brightness_, "[1] of it", Range{0, 1}, {}, true},
            {"name", std::string("lamp"), "of it"}};
  }
  RosValue value_of(const std::string& name) const {
    const auto all = facts();
    const auto* const found = find_parameter(all, name);
    return found != nullptr ? ros_value(found->value) : RosValue();
  }
  void answer_parameters() {
    while (auto call = list_.take()) {
      service::ListParameters::Response response;
      response.result(list_parameters(facts(), *call->request));
      list_.reply(call->id, response);
    }
    while (auto call = get_.take()) {
      service::GetParameters::Response response;
      for (const auto& one : call->request->names()) response.values().push_back(value_of(one));
      get_.reply(call->id, response);
    }
    while (auto call = describe_.take()) {
      service::DescribeParameters::Response response;
      for (const auto& one : facts()) response.descriptors().push_back(describe(one));
      describe_.reply(call->id, response);
    }
    while (auto call = change_.take()) {
      service::SetParameters::Response response;
      for (const auto& one : call->request->parameters()) {
        rcl_interfaces::msg::SetParametersResult result;
        result.successful(one.name() == "brightness");
        if (result.successful()) brightness_ = one.value().double_value();
        if (!result.successful()) result.reason("is fixed");
        response.results().push_back(result);
      }
      change_.reply(call->id, response);
    }
  }
  double brightness_ = 0.5;
  Server<SetLamp> set_{*this};
  Server<service::ListParameters> list_{*this};
  Server<service::GetParameters> get_{*this};
  Server<service::DescribeParameters> describe_{*this};
  Server<service::SetParameters> change_{*this};
};

Ended call(const char* program, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program);
  arguments.insert(arguments.end(), {"--domain", std::to_string(domain)});
  return run_to_end(arguments);
}

class ServiceProgram : public ::testing::Test {
 protected:
  static Ended param(const std::vector<std::string>& arguments) {
    return call(PARAM_PROGRAM, arguments);
  }
  TickedNeighbour<Lamp> neighbour_{domain, "lamp"};
};

TEST_F(ServiceProgram, ListsServicesWithTheirTypes) {
  EXPECT_THAT(call(SERVICE_PROGRAM, {"list", "-t"}).output,
              HasSubstr("/lamp/set [std_srvs/srv/SetBool]\n"));
  EXPECT_EQ(call(SERVICE_PROGRAM, {"list", "-c"}).output, "5\n");
  EXPECT_EQ(call(SERVICE_PROGRAM, {"type", "/lamp/set"}).output, "std_srvs/srv/SetBool\n");
  EXPECT_EQ(call(SERVICE_PROGRAM, {"find", "std_srvs/srv/SetBool"}).output, "/lamp/set\n");
}

TEST_F(ServiceProgram, SaysInOneLineThatNobodyServesOrKnowsWhatIsAsked) {
  const Ended none =
      call(SERVICE_PROGRAM, {"call", "/nothing", "std_srvs/srv/Trigger", "--timeout", "0.3"});
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.output, HasSubstr("service /nothing: nobody serves it\n"));
  const Ended misspelt =
      call(SERVICE_PROGRAM, {"call", "/lamp/ste", "std_srvs/srv/SetBool", "--timeout", "0.3"});
  EXPECT_EQ(misspelt.code, 1);
  EXPECT_THAT(misspelt.output, HasSubstr("nobody serves it; did you mean '/lamp/set'?\n"));
  EXPECT_THAT(call(SERVICE_PROGRAM, {"type", "/lamp/sett"}).output,
              HasSubstr("is not there; did you mean '/lamp/set'?\n"));
  EXPECT_THAT(call(PARAM_PROGRAM, {"list", "/lmap", "--timeout", "0.3"}).output,
              HasSubstr("nobody serves it; did you mean '/lamp'?\n"));
  const Ended unknown = call(SERVICE_PROGRAM, {"call", "/lamp/set", "no_srvs/srv/Thing"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.output, HasSubstr("'no_srvs/srv/Thing_Request' is not known here"));
}

TEST_F(ServiceProgram, ReadsParameters) {
  EXPECT_EQ(param({"list"}).output, "/lamp:\n  brightness\n  name\n");
  EXPECT_EQ(param({"get", "/lamp", "brightness"}).output, "Double value is: 0.5\n");
  EXPECT_EQ(param({"get", "lamp", "name", "--hide-type"}).output, "lamp\n");
  const Ended unset = param({"get", "/lamp", "none"});
  EXPECT_EQ(unset.code, 1);
  EXPECT_EQ(unset.output, "Parameter not set.\n");
}

TEST_F(ServiceProgram, SetsAndLoadsParameters) {
  EXPECT_EQ(param({"set", "/lamp", "brightness", "0.75"}).output, "Set parameter successful\n");
  EXPECT_EQ(param({"get", "/lamp", "brightness"}).output, "Double value is: 0.75\n");
  const Ended refused = param({"set", "/lamp", "name", "other"});
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.output, HasSubstr("Setting parameter failed: is fixed\n"));
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/lamp.yaml";
  std::ofstream(file) << "/lamp:\n  ros__parameters: {brightness: 0.25, name: x}\n";
  const Ended loaded = param({"load", "/lamp", file});
  EXPECT_EQ(loaded.code, 1);
  EXPECT_EQ(loaded.output,
            "Set parameter brightness successful\nSet parameter name failed: is fixed\n");
  EXPECT_EQ(param({"get", "/lamp", "brightness"}).output, "Double value is: 0.25\n");
}

}  // namespace
}  // namespace tocsin::topic_tool
