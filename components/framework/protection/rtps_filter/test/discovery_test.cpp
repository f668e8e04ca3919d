// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

constexpr std::uint32_t huge = 0xffffffff;

std::optional<DropReason> drop_of_parameter(std::uint32_t id, const Bytes& value) {
  return drop_of(announcement('a', Wire().parameter(id, value)));
}

TEST(Announcement, OfAParticipantPasses) {
  EXPECT_EQ(drop_of(announcement('a')), passes);
  EXPECT_EQ(drop_of(announcement('a', Wire().parameter(0x62, Wire().text("robot").bytes()))),
            passes);
}

TEST(Announcement, NamesItsSender) {
  const Wire of_another = Wire().parameter(0x50, guid_of('b')).sentinel();
  const Bytes message = data_of(data_head(spdp_writer).raw(parameters_payload(of_another)));
  EXPECT_EQ(drop_of(message), DropReason::foreign_identity);
  EXPECT_EQ(drop_of_parameter(0x5a, guid_of('b')), DropReason::foreign_identity);
}

TEST(Announcement, WithoutGuidIsDropped) {
  const Bytes payload = parameters_payload(Wire().sentinel());
  EXPECT_EQ(drop_of(data_of(data_head(spdp_writer).raw(payload))), DropReason::discovery_payload);
}

TEST(Announcement, WithoutPayloadIsDropped) {
  EXPECT_EQ(drop_of(data_of(data_head(spdp_writer), 0)), DropReason::discovery_payload);
}

TEST(Announcement, ToAReaderOfSomethingElseIsDropped) {
  const Bytes payload = parameters_payload(Wire().parameter(0x50, guid_of('a')).sentinel());
  const auto to = [&](std::uint32_t reader) {
    const Wire content = data_head(spdp_writer, 1, 16, reader).raw(payload);
    return drop_of(data_of(content));
  };
  EXPECT_EQ(to(0x000100c7), passes);
  EXPECT_EQ(to(0x000003c7), DropReason::discovery_payload);
  EXPECT_EQ(to(0x00000104), DropReason::discovery_payload);
}

TEST(Announcement, InAnEncodingThatFastDdsCannotReadPasses) {
  const Bytes payload{0, 0x0a, 0, 0, 1, 2, 3, 4};
  RtpsFilter sut{Limits{}};
  const Bytes message = data_of(data_head(sedp_writer).raw(payload));
  EXPECT_EQ(drop_of(sut, message), passes);
}

TEST(Announcement, ListEndsWithinThePayload) {
  const auto with = [](const Wire& list) {
    return drop_of(data_of(data_head(spdp_writer).raw(parameters_payload(list))));
  };
  EXPECT_EQ(with(Wire().parameter(0x50, guid_of('a'))), DropReason::parameter_length);
  EXPECT_EQ(with(Wire().u16(0x50).u16(0xfff0).sentinel()), DropReason::parameter_length);
}

TEST(Parameter, StringFitsAndEndsWithZero) {
  for (const std::uint32_t id : {0x05U, 0x07U, 0x62U, 0x4014U}) {
    EXPECT_EQ(drop_of_parameter(id, Wire().text("name").bytes()), passes) << id;
    EXPECT_EQ(drop_of_parameter(id, Wire().u32(huge).u32(0).bytes()), DropReason::parameter_content)
        << id;
    EXPECT_EQ(drop_of_parameter(id, Wire().u32(4).raw({'a', 'b', 'c', 'd'}).bytes()),
              DropReason::parameter_content)
        << id;
    EXPECT_EQ(drop_of_parameter(id, {}), DropReason::parameter_content) << id;
  }
  EXPECT_EQ(drop_of_parameter(0x62, Wire().u32(0).bytes()), passes);
}

TEST(Parameter, UserDataFits) {
  for (const std::uint32_t id : {0x2cU, 0x2dU, 0x2eU}) {
    EXPECT_EQ(drop_of_parameter(id, Wire().u32(4).u32(7).bytes()), passes) << id;
    EXPECT_EQ(drop_of_parameter(id, Wire().u32(5).u32(7).bytes()), DropReason::parameter_content);
    EXPECT_EQ(drop_of_parameter(id, Wire().u32(huge).bytes()), DropReason::parameter_content);
  }
}

TEST(Parameter, SequencesCountWhatIsThere) {
  const Bytes two_names = Wire().u32(2).text("a").text("bc").bytes();
  EXPECT_EQ(drop_of_parameter(0x29, two_names), passes);
  EXPECT_EQ(drop_of_parameter(0x29, Wire().u32(1).u32(0).bytes()), passes) << "an empty name";
  EXPECT_EQ(drop_of_parameter(0x29, Wire().u32(3).text("a").text("bc").bytes()),
            DropReason::parameter_content);
  for (const std::uint32_t id : {0x29U, 0x59U, 0x73U, 0x35U}) {
    EXPECT_EQ(drop_of_parameter(id, Wire().u32(huge).u32(0).bytes()), DropReason::parameter_content)
        << id;
  }
  EXPECT_EQ(drop_of_parameter(0x73, Wire().u32(2).u16(0).u16(2).bytes()), passes);
  EXPECT_EQ(drop_of_parameter(0x73, Wire().u32(3).u16(0).u16(2).bytes()),
            DropReason::parameter_content);
}

TEST(Parameter, PropertiesAreNamesAndValues) {
  EXPECT_EQ(drop_of_parameter(0x59, Wire().u32(1).text("name").text("value").bytes()), passes);
  EXPECT_EQ(drop_of_parameter(0x59, Wire().u32(1).text("name").bytes()),
            DropReason::parameter_content);
}

TEST(Parameter, ContentFilterIsFourNamesAndItsArguments) {
  Wire value = Wire().text("filtered").text("topic").text("DDSSQL").text("x > %0");
  EXPECT_EQ(drop_of_parameter(0x35, Wire(value).u32(1).text("7").bytes()), passes);
  EXPECT_EQ(drop_of_parameter(0x35, Wire(value).u32(huge).bytes()), DropReason::parameter_content);
}

TEST(Parameter, ThatIsShorterThanItsFormIsDropped) {
  for (const std::uint32_t id : {0x2fU, 0x30U, 0x31U, 0x32U, 0x33U, 0x48U}) {
    EXPECT_EQ(drop_of_parameter(id, Bytes(20, 0)), DropReason::parameter_content) << id;
  }
  EXPECT_EQ(drop_of_parameter(0x02, Bytes(4, 0)), DropReason::parameter_content);
  EXPECT_EQ(drop_of_parameter(0x5a, Bytes(12, 'a')), DropReason::parameter_content);
}

TEST(Token, HasTheFormOfADataHolder) {
  const Wire whole = Wire()
                         .text("DDS:Auth:PKI-DH:1.0")
                         .u32(1)
                         .text("dds.cert.sn")
                         .text("CN=alice")
                         .u32(1)
                         .text("bin")
                         .u32(4)
                         .u32(7);
  const Wire no_class = Wire().u32(huge).u32(0).u32(0);
  const Wire many = Wire().text("DDS:Auth").u32(huge).u32(0);
  const Wire many_binary = Wire().text("DDS:Auth").u32(0).u32(huge);
  const Wire long_binary = Wire().text("DDS:Auth").u32(0).u32(1).text("bin").u32(huge);
  for (const std::uint32_t id : {0x1001U, 0x1002U, 0x1006U}) {
    EXPECT_EQ(drop_of_parameter(id, whole.bytes()), passes) << id;
    for (const Wire& odd : {no_class, many, many_binary, long_binary, Wire()}) {
      EXPECT_EQ(drop_of_parameter(id, odd.bytes()), DropReason::security_content) << id;
    }
  }
}

TEST(Authentication, MessageIsWhole) {
  const auto with = [](const Wire& content) {
    const Wire payload = Wire().raw({0, 1, 0, 0}).zeros(24 + 24 + 48).raw(content.bytes());
    return drop_of(data_of(data_head(0x000201c3).raw(payload.bytes())));
  };
  EXPECT_EQ(with(Wire().text("dds.sec.auth").u32(1).text("DDS:Auth").u32(0).u32(0)), passes);
  EXPECT_EQ(with(Wire().text("dds.sec.auth").u32(huge)), DropReason::security_content);
  EXPECT_EQ(with(Wire().u32(huge)), DropReason::security_content);
}

TEST(Liveliness, MessageIsWholeAndTheSenders) {
  const auto with = [](const Bytes& content) {
    const Wire payload = Wire().raw({0, 1, 0, 0}).raw(content);
    return drop_of(data_of(data_head(0x000200c2).raw(payload.bytes())));
  };
  EXPECT_EQ(with(Wire().raw(prefix_of('a')).entity(1).u32(0).bytes()), passes);
  EXPECT_EQ(with(Wire().raw(prefix_of('b')).u32(1).u32(0).bytes()), DropReason::foreign_identity);
  EXPECT_EQ(with(prefix_of('a')), DropReason::discovery_payload);
}

TEST(Liveliness, KeyHashIsTheSenders) {
  const Wire qos = Wire().parameter(0x70, guid_of('b')).sentinel();
  EXPECT_EQ(drop_of(data_of(data_head(0x000200c2).raw(qos.bytes()), with_qos)),
            DropReason::foreign_identity);
}

Limits own_network() {
  Limits limits;
  limits.answers = [](std::uint32_t address) { return address == ipv4(10, 0, 0, 2); };
  return limits;
}

TEST(Locator, OfAnUnknownAddressIsStripped) {
  RtpsFilter sut(own_network());
  const Wire list = Wire()
                        .parameter(0x32, locator(ipv4(10, 0, 0, 2)))
                        .parameter(0x32, locator(ipv4(203, 0, 113, 9)));
  const Bytes message = announcement('a', list);
  const Inspection inspection = inspect(sut, message);
  EXPECT_EQ(inspection.drop, passes);
  ASSERT_EQ(inspection.strip.size(), 1U);
  const std::size_t at = inspection.strip[0];
  EXPECT_EQ(message[at], 0x32);
  EXPECT_EQ(message[at + 4 + 20], 203);
}

TEST(Locator, OfAnyKindOfUdpTrafficIsLookedAt) {
  for (const std::uint32_t id : {0x2fU, 0x30U, 0x31U, 0x32U, 0x33U, 0x48U}) {
    RtpsFilter sut(own_network());
    const Bytes message = announcement('a', Wire().parameter(id, locator(ipv4(203, 0, 113, 9))));
    EXPECT_EQ(inspect(sut, message).strip.size(), 1U) << id;
  }
}

TEST(Locator, OfAnotherTransportStays) {
  RtpsFilter sut(own_network());
  constexpr std::uint32_t shared_memory = 16;
  const Wire list = Wire().parameter(0x32, locator(ipv4(203, 0, 113, 9), shared_memory));
  EXPECT_TRUE(inspect(sut, announcement('a', list)).strip.empty());
}

TEST(Locator, UnderASealOfDdsSecurityStays) {
  const Wire list = Wire()
                        .parameter(0x50, guid_of('a'))
                        .parameter(0x32, locator(ipv4(203, 0, 113, 9)))
                        .sentinel();
  const Bytes message =
      Message()
          .add(0x31, 0, Bytes(20, 1))
          .add(0x15, with_data, data_head(spdp_writer).raw(parameters_payload(list)).bytes())
          .bytes();
  Limits limits = own_network();
  RtpsFilter plain(limits);
  EXPECT_EQ(inspect(plain, message).strip.size(), 1U);  // a forged seal protects nothing
  limits.secured = true;
  RtpsFilter secured(limits);
  EXPECT_TRUE(inspect(secured, message).strip.empty());
}

TEST(TypeInformation, IsStrippedWhereNobodyReadsIt) {
  for (const std::uint32_t id : {0x69U, 0x72U, 0x75U}) {
    const Bytes message = announcement('a', Wire().parameter(id, Bytes(16, 0xff)), sedp_writer);
    RtpsFilter sut{Limits{}};
    EXPECT_EQ(inspect(sut, message).strip.size(), 1U) << id;
    Limits limits;
    limits.strip_type_information = false;
    RtpsFilter reader(limits);
    EXPECT_TRUE(inspect(reader, message).strip.empty()) << id;
  }
}

TEST(DataSharing, OfAnotherVendorIsNotReadAsFastDdss) {
  const Wire list = Wire().parameter(0x8006, Wire().u32(huge).bytes());
  RtpsFilter sut{Limits{}};
  const Inspection other = inspect(sut, announcement('a', list, sedp_writer, 0x0101));
  EXPECT_EQ(other.drop, passes);
  EXPECT_EQ(other.strip.size(), 1U);
  EXPECT_EQ(drop_of(sut, announcement('a', list, sedp_writer, 0x010f)),
            DropReason::parameter_content);
}

}  // namespace
}  // namespace tocsin::rtps_filter
