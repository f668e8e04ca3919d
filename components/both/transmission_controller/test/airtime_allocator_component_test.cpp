// SPDX-License-Identifier: Apache-2.0
#include "airtime_allocator/airtime_allocator_component.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

/// The topics as they stand on the site.
struct FirstUse : topic::AirtimeUse {
  static constexpr TopicInfo info{"uxv1/airtime_use", "telemetry", Scope::host};
};
struct SecondUse : topic::AirtimeUse {
  static constexpr TopicInfo info{"uxv2/airtime_use", "telemetry", Scope::host};
};
struct FirstShare : topic::AirtimeShare {
  static constexpr TopicInfo info{"uxv1/airtime_share", "telemetry", Scope::host};
};
struct SecondShare : topic::AirtimeShare {
  static constexpr TopicInfo info{"uxv2/airtime_share", "telemetry", Scope::host};
};
struct SecondDriver : topic::DriverState {
  static constexpr TopicInfo info{"uxv2/teleop/driver", "state", Scope::host};
};

AirtimeAllocatorComponent::Params of(const std::vector<std::string>& vehicles) {
  AirtimeAllocatorComponent::Params params;
  params.vehicles = vehicles;
  params.allocator.air = 0.6;
  return params;
}

class AirtimeAllocatorComponentTest : public ::testing::Test {
 protected:
  AirtimeAllocatorComponentTest() { bus_.add(sut_); }
  static topic::AirtimeUse::Message use(float used, float share) {
    topic::AirtimeUse::Message message;
    message.used(used);
    message.share(share);
    return message;
  }
  SimBus bus_;
  Context context_{bus_, "airtime_allocator", Role::gcs};
  AirtimeAllocatorComponent sut_{context_, of({"uxv1", "uxv2"})};
  SimReader<FirstShare> first_{bus_};
  SimReader<SecondShare> second_{bus_};
};

TEST_F(AirtimeAllocatorComponentTest, TellsEachVehicleItsShareOnceASecond) {
  bus_.run_for(seconds(1));
  (void)first_.take();
  (void)second_.take();
  bus_.publish<FirstUse>(use(0.1F, 0.3F));
  bus_.publish<SecondUse>(use(0.3F, 0.3F));
  bus_.run_for(seconds(1));
  const auto first = first_.take();
  const auto second = second_.take();
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_FLOAT_EQ(first[0].share(), 0.15F);
  EXPECT_FLOAT_EQ(second[0].share(), 0.45F);
  EXPECT_FLOAT_EQ(second[0].fallback(), 0.3F);
}

TEST_F(AirtimeAllocatorComponentTest, WhoIsDrivenByHandHasFourTimesAsMuch) {
  bus_.publish<FirstUse>(use(0.5F, 0.3F));
  bus_.publish<SecondUse>(use(0.5F, 0.3F));
  SecondDriver::Message driver;
  driver.driver("anna");
  bus_.publish<SecondDriver>(driver);
  bus_.run_for(seconds(2));
  EXPECT_FLOAT_EQ(first_.take().back().share(), 0.12F);
  EXPECT_FLOAT_EQ(second_.take().back().share(), 0.48F);
}

TEST_F(AirtimeAllocatorComponentTest, RefusesNamesThatAreNoneOrThereTwice) {
  Context other(bus_, "other", Role::gcs);
  EXPECT_THROW(AirtimeAllocatorComponent(other, of({"uxv 1"})), ConfigError);
  EXPECT_THROW(AirtimeAllocatorComponent(other, of({"uxv1", "uxv1"})), ConfigError);
}

}  // namespace
}  // namespace tocsin
