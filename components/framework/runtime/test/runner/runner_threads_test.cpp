// SPDX-License-Identifier: Apache-2.0
#include "runner/runner_threads.hpp"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

/// Tells on which thread its first tick runs.
class Teller : public Component {
 public:
  explicit Teller(Context& context, bool throws = false) : Component(context), throws_(throws) {}
  void tick(Time) override {
    if (!told_) thread_.set_value(std::this_thread::get_id());
    told_ = true;
    if (throws_) throw std::runtime_error("broken");
  }
  std::thread::id thread() { return thread_.get_future().get(); }

 private:
  std::promise<std::thread::id> thread_;
  bool told_ = false;
  bool throws_;
};

class RunnerThreadsTest : public ::testing::Test {
 protected:
  SimBus bus_;
  Context context_{bus_, "teller", Role::uxv};
  TickAccount account_;
  TickAccount other_account_;
};

TEST_F(RunnerThreadsTest, EachComponentHasAThreadOfItsOwn) {
  Teller one(context_);
  Teller other(context_);
  RunnerThreads sut(bus_, {});
  sut.add(one, account_);
  sut.add(other, other_account_);
  EXPECT_NE(one.thread(), other.thread());
}

TEST_F(RunnerThreadsTest, ARemovedComponentMayBeAddedAgain) {
  Teller one(context_);
  RunnerThreads sut(bus_, {});
  sut.add(one, account_);
  (void)one.thread();
  EXPECT_TRUE(sut.remove(one));
  sut.add(one, account_);
  EXPECT_TRUE(sut.remove(one));
}

TEST_F(RunnerThreadsTest, TellsItsOwnerOfAComponentThatThrew) {
  std::promise<void> failed;
  Teller broken(context_, true);
  RunnerThreads sut(bus_, [&] { failed.set_value(); });
  sut.add(broken, account_);
  failed.get_future().wait();
  EXPECT_TRUE(account_.failed());
}

}  // namespace
}  // namespace tocsin
