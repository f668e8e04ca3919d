// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/command_topics.hpp"

#include "base_commands.hpp"

namespace tocsin {
namespace {

/// 1 when there is no register to set.
int set(kobuki::KobukiDriver& driver, const std::optional<kobuki::OutputRegister>& outputs) {
  if (!outputs) return 1;
  driver.set_outputs(*outputs);
  return 0;
}

}  // namespace

CommandTopics::CommandTopics(Component& owner)
    : led1_(owner),
      led2_(owner),
      sound_(owner),
      digital_(owner),
      supply_(owner),
      reset_(owner),
      motor_(owner),
      gains_(owner) {}

int CommandTopics::apply_outputs(kobuki::KobukiDriver& driver) {
  int refused = 0;
  while (const auto led = led1_.take()) {
    refused += set(driver, kobuki::with_led(driver.outputs(), 1, led->value()));
  }
  while (const auto led = led2_.take()) {
    refused += set(driver, kobuki::with_led(driver.outputs(), 2, led->value()));
  }
  while (const auto wanted = digital_.take()) {
    driver.set_outputs(kobuki::with_outputs(driver.outputs(), *wanted));
  }
  while (const auto wanted = supply_.take()) {
    refused += set(driver, kobuki::with_supply(driver.outputs(), *wanted));
  }
  return refused;
}

bool CommandTopics::anything_came() const {
  return led1_.has_sample() || led2_.has_sample() || sound_.has_sample() || digital_.has_sample() ||
         supply_.has_sample() || reset_.has_sample() || motor_.has_sample() || gains_.has_sample();
}

int CommandTopics::apply(kobuki::KobukiDriver& driver) {
  if (!anything_came()) return 0;
  int refused = apply_outputs(driver);
  while (const auto sound = sound_.take()) {
    const auto tune = kobuki::tune_of(*sound);
    if (!tune || !driver.send_once(*tune)) ++refused;
  }
  while (const auto motor = motor_.take()) {
    if (motor->state() > 1) {
      ++refused;
    } else {
      driver.set_motor_power(motor->state() == 1);
    }
  }
  while (const auto wanted = gains_.take()) {
    const auto gains = kobuki::gains_of(*wanted);
    if (!gains || !driver.set_gains(*gains)) ++refused;
  }
  while (reset_.take()) driver.reset_odometry();
  return refused;
}

}  // namespace tocsin
