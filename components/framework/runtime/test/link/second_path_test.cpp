// SPDX-License-Identifier: Apache-2.0
// Two paths over the link: real Fast DDS on two veth pairs in network namespaces of the test's own.
#include <arpa/inet.h>
#include <sys/socket.h>

#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "link/namespace_pair.hpp"

namespace tocsin {
namespace {

constexpr std::size_t announcement_bytes = 200;

class SecondPathTest : public NamespacePair {
 protected:
  void SetUp() override {
    NamespacePair::SetUp();
    if (IsSkipped()) return;
    ASSERT_TRUE(plug("10.9.0") && give_carrier());
    ASSERT_TRUE(plug("10.8.0", "2"));
  }
  static BusOptions with_second(BusOptions options, const std::string& address,
                                const std::string& peer) {
    options.second_address = address;
    options.second_peers = {peer};
    return options;
  }
  static BusOptions left() {
    return with_second(options_of("10.9.0.1", "10.9.0.2"), "10.8.0.1", "10.8.0.2");
  }
  static BusOptions right() {
    return with_second(options_of("10.9.0.2", "10.9.0.1"), "10.8.0.2", "10.8.0.1");
  }
  /// A router on each side, and a writer on the left.
  struct Site {
    Site(const SecondPathTest& test, const BusOptions& own)
        : near(own),
          far(test.right_router(right())),
          process(make_fast_dds_bus(own)),
          writer(process->advertise(low_topic)) {}
    /// Whether what is written on the left comes to the right within some seconds.
    bool crosses() {
      const std::size_t before = far->crossed().size();
      return eventually([&] {
        (void)writer->write(text("x"));
        return far->crossed().size() > before;
      });
    }
    bool stays_away() {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      const std::size_t before = far->crossed().size();
      for (int i = 0; i < 50; ++i) {
        (void)writer->write(text("x"));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      return far->crossed().size() == before;
    }
    Relay near;
    const std::unique_ptr<Relay> far;
    const std::unique_ptr<Bus> process;
    const std::unique_ptr<Publication> writer;
  };
};

TEST_F(SecondPathTest, EachSampleTakesThePathThatItIsSentByAndNoOther) {
  Site site(*this, left());
  ASSERT_TRUE(site.crosses());
  site.near.take_path(1);
  EXPECT_TRUE(site.stays_away()) << "the second interface has no carrier";
  ASSERT_TRUE(give_carrier("2"));
  EXPECT_TRUE(site.crosses()) << "it may come later";
  EXPECT_GT(site.near.packets().second_bytes, announcement_bytes);
}

TEST_F(SecondPathTest, AWriterOnEachPathIsTheSameFlow) {
  Site site(*this, left());
  ASSERT_TRUE(eventually([&] { return site.far->peer_flows().size() >= 2; }));
  auto flows = site.far->peer_flows();
  ASSERT_EQ(flows.size(), 2U);
  EXPECT_NE(flows[0].path, flows[1].path);
  flows[1].path = flows[0].path;
  EXPECT_EQ(flows[0], flows[1]);
}

TEST_F(SecondPathTest, WhenTheFirstInterfaceGoesTheSecondCarriesSamplesDiscoveryAndTheStop) {
  ASSERT_TRUE(give_carrier("2"));
  Site site(*this, left());
  ASSERT_TRUE(site.crosses());
  ASSERT_TRUE(run("link del left"));
  EXPECT_TRUE(site.stays_away());
  site.near.take_path(1);
  EXPECT_TRUE(site.crosses());
  StopValue value;
  value.host = "left";
  value.number = 77;
  site.near.say_stop(value);
  EXPECT_TRUE(eventually([&] { return site.far->stop_number() == 77; }));
  const Endpoint high{{"low", "state", Scope::link}, &type_info<std_msgs::msg::String>()};
  const std::size_t flows = site.far->peer_flows().size();
  const auto another_process = make_fast_dds_bus(left());
  const auto another = another_process->advertise(high);
  EXPECT_TRUE(eventually([&] { return site.far->peer_flows().size() > flows; })) << "by discovery";
  ASSERT_TRUE(plug("10.9.0") && give_carrier());
  site.near.take_path(0);
  EXPECT_TRUE(site.crosses()) << "the first is back";
}

TEST_F(SecondPathTest, TheSecondInterfaceIsEnoughToFindEachOtherAndTheFirstMayComeLater) {
  ASSERT_TRUE(run("link del left"));
  ASSERT_TRUE(give_carrier("2"));
  Site site(*this, left());
  site.near.take_path(1);
  ASSERT_TRUE(site.crosses());
  site.near.take_path(0);
  EXPECT_TRUE(site.stays_away());
  ASSERT_TRUE(plug("10.9.0") && give_carrier());
  EXPECT_TRUE(site.crosses());
}

TEST_F(SecondPathTest, APacketIsOfTheAgeThatItsOwnSocketSays) {
  ASSERT_TRUE(give_carrier("2"));
  Site site(*this, left());
  site.near.take_path(1);
  ASSERT_TRUE(site.crosses());
  site.near.take_path(0);
  std::this_thread::sleep_for(std::chrono::seconds(1));  // nothing comes by the second
  ASSERT_TRUE(site.crosses());
  const auto waited = std::chrono::steady_clock::now() - site.far->crossed().back().received;
  EXPECT_LT(waited, std::chrono::milliseconds(500));
}

TEST_F(SecondPathTest, APortThatIsTakenThereIsAnErrorThatNamesIt) {
  const FileDescriptor taken(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(7410 + 250 * 20);
  ASSERT_EQ(inet_pton(AF_INET, "10.8.0.1", &at.sin_addr), 1);
  ASSERT_EQ(::bind(taken.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at), 0);
  try {
    (void)make_fast_dds_link_bus(left(), [] {});
    FAIL() << "no error";
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("UDP 10.8.0.1:12410, a path over the link"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(SecondPathTest, APacketOfNoPeerIsNotReceivedThere) {
  ASSERT_TRUE(give_carrier("2"));
  BusOptions stranger = left();
  stranger.second_address = "10.8.0.3";
  ASSERT_TRUE(run("addr add 10.8.0.3/24 dev left2"));
  Site site(*this, stranger);
  ASSERT_TRUE(site.crosses());
  site.near.take_path(1);
  EXPECT_TRUE(site.stays_away());
}

}  // namespace
}  // namespace tocsin
