// SPDX-License-Identifier: Apache-2.0
#include "../src/field_condition.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "foundation/error.hpp"
#include "ros_idl/nav_msgs.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using Is = FetchRule::Is;
using Odom = nav_msgs::msg::Odometry;
using State = tocsin_msgs::msg::TransmissionState;

FetchRule rule_of(const std::string& field, Is is, double limit, const std::string& value = "") {
  FetchRule rule;
  rule.when = "odom";
  rule.field = field;
  rule.is = is;
  rule.limit = limit;
  rule.value = value;
  rule.name = "uxv.fetch[0]";
  return rule;
}
Odom moving_at(double x_mps) {
  Odom odom;
  odom.twist().twist().linear().x(x_mps);
  return odom;
}
template <class Message>
std::string error_of(const FetchRule& rule) {
  try {
    const FieldCondition sut(type_info<Message>(), rule);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(FieldCondition, ComparesANumber) {
  const FieldCondition above(type_info<Odom>(), rule_of("twist.twist.linear.x", Is::above, 0.5));
  const FieldCondition below(type_info<Odom>(), rule_of("twist.twist.linear.x", Is::below, 0.5));
  const FieldCondition equal(type_info<Odom>(),
                             rule_of("twist.twist.linear.x", Is::equal, 0, "0.5"));
  for (const double x : {0.25, 0.5, 0.75, std::nan("")}) {
    const Odom odom = moving_at(x);
    EXPECT_EQ(above.holds(&odom), x > 0.5) << x;
    EXPECT_EQ(below.holds(&odom), x < 0.5) << x;
    EXPECT_EQ(equal.holds(&odom), x == 0.5) << x;
  }
}

TEST(FieldCondition, ComparesATextAndATruth) {
  const FieldCondition role(type_info<State>(), rule_of("role", Is::equal, 0, "uxv"));
  const FieldCondition active(type_info<State>(), rule_of("active", Is::equal, 0, "false"));
  State state;
  state.role("uxv");
  state.active(true);
  EXPECT_TRUE(role.holds(&state));
  EXPECT_FALSE(active.holds(&state));
  state.role("gcs");
  state.active(false);
  EXPECT_FALSE(role.holds(&state));
  EXPECT_TRUE(active.holds(&state));
}

TEST(FieldCondition, OfAnySampleHoldsAlways) {
  const Odom odom;
  EXPECT_TRUE(FieldCondition(type_info<Odom>(), rule_of("", Is::any, 0)).holds(&odom));
}

TEST(FieldCondition, NamesAFieldThatIsNotThere) {
  EXPECT_THAT(error_of<Odom>(rule_of("twist.twist.linear.y2", Is::above, 1)),
              HasSubstr("uxv.fetch[0].field: odom has no field twist.twist.linear.y2; did you mean "
                        "'twist.twist.linear.x'"));
  EXPECT_THAT(error_of<Odom>(rule_of("twist", Is::above, 1)), HasSubstr("has no field twist"));
  EXPECT_THAT(error_of<Odom>(rule_of("pose.covariance", Is::above, 1)), HasSubstr("has no field"));
}

TEST(FieldCondition, RefusesWhatCannotBeCompared) {
  EXPECT_THAT(error_of<State>(rule_of("role", Is::above, 1)),
              HasSubstr("uxv.fetch[0].field: role is a text"));
  EXPECT_THAT(error_of<Odom>(rule_of("twist.twist.linear.x", Is::equal, 0, "fast")),
              HasSubstr("uxv.fetch[0].equals: 'fast' is no number"));
}

}  // namespace
}  // namespace tocsin
