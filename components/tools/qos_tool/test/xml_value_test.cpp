// SPDX-License-Identifier: Apache-2.0
// Values in XML, each form in both directions, and what is none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include "dialect.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::Eq;
using ::testing::Optional;

Place place(Form form, const char* suffix = "") { return {"p", "a/b", form, suffix, ""}; }

/// What `xml`, the inner text of an element, says in our words.
std::optional<std::string> read(const Place& where, const std::string& xml) {
  tinyxml2::XMLDocument document;
  const std::string text = "<a>" + xml + "</a>";
  EXPECT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS) << xml;
  return read_value(*document.RootElement(), where);
}

/// The element as text that says `value`.
std::string written(const Place& where, const std::string& value) {
  tinyxml2::XMLDocument document;
  tinyxml2::XMLElement* const root = document.NewElement("a");
  document.InsertEndChild(root);
  write_value(*root, where, value);
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  return printer.CStr();
}

TEST(XmlValue, WordsAreInCapitalsWithTheirSuffix) {
  const Place plain = place(Form::word);
  EXPECT_EQ(written(plain, "transient_local"), "<a>TRANSIENT_LOCAL</a>");
  EXPECT_THAT(read(plain, " TRANSIENT_LOCAL\n"), Optional(Eq("transient_local")));
  const Place dds = place(Form::word, "_DURABILITY_QOS");
  EXPECT_EQ(written(dds, "volatile"), "<a>VOLATILE_DURABILITY_QOS</a>");
  EXPECT_THAT(read(dds, "VOLATILE_DURABILITY_QOS"), Optional(Eq("volatile")));
  EXPECT_EQ(read(dds, "VOLATILE"), std::nullopt);
  EXPECT_EQ(read(dds, "_DURABILITY_QOS"), std::nullopt);
  EXPECT_EQ(read(plain, ""), std::nullopt);
}

TEST(XmlValue, SecondsAreWholeOnesAndNanoseconds) {
  const Place where = place(Form::seconds);
  EXPECT_EQ(written(where, "1.25"), "<a><sec>1</sec><nanosec>250000000</nanosec></a>");
  EXPECT_EQ(written(where, "0.29"), "<a><sec>0</sec><nanosec>290000000</nanosec></a>");
  EXPECT_EQ(written(where, ".inf"),
            "<a><sec>DURATION_INFINITE_SEC</sec><nanosec>DURATION_INFINITE_NSEC</nanosec></a>");
  EXPECT_THAT(read(where, "<sec>1</sec><nanosec>250000000</nanosec>"), Optional(Eq("1.25")));
  EXPECT_THAT(read(where, "<nanosec>5000000</nanosec>"), Optional(Eq("0.005")));
  EXPECT_THAT(read(where, "<sec>3</sec>"), Optional(Eq("3")));
  for (const char* infinite : {"DURATION_INFINITY", "<sec>DURATION_INFINITE_SEC</sec>",
                               "<sec>0</sec><nanosec>DURATION_INFINITE_NSEC</nanosec>"}) {
    EXPECT_THAT(read(where, infinite), Optional(Eq(".inf"))) << infinite;
  }
  for (const char* wrong : {"", "3", "<sec>x</sec>", "<sec>1.5</sec>", "<sec/>", "<min>1</min>"}) {
    EXPECT_EQ(read(where, wrong), std::nullopt) << wrong;
  }
}

TEST(XmlValue, NumbersMayBeUnlimited) {
  const Place where = place(Form::number);
  EXPECT_EQ(written(where, "17"), "<a>17</a>");
  EXPECT_THAT(read(where, "17"), Optional(Eq("17")));
  EXPECT_THAT(read(where, "LENGTH_UNLIMITED"), Optional(Eq("0")));
  EXPECT_THAT(read(where, "-1"), Optional(Eq("0")));
  for (const char* wrong : {"", "many", "1 2", "1.5", "99999999999999999999"}) {
    EXPECT_EQ(read(where, wrong), std::nullopt) << wrong;
  }
}

TEST(XmlValue, FlagsMayBeTheOppositeOfOurs) {
  EXPECT_EQ(written(place(Form::flag), "true"), "<a>true</a>");
  EXPECT_EQ(written(place(Form::not_flag), "true"), "<a>false</a>");
  EXPECT_EQ(written(place(Form::not_flag), "false"), "<a>true</a>");
  EXPECT_THAT(read(place(Form::flag), "1"), Optional(Eq("true")));
  EXPECT_THAT(read(place(Form::not_flag), "true"), Optional(Eq("false")));
  EXPECT_THAT(read(place(Form::not_flag), "0"), Optional(Eq("true")));
  EXPECT_EQ(read(place(Form::flag), "yes"), std::nullopt);
}

TEST(XmlValue, NamesAreElements) {
  const Place where = place(Form::names, "name");
  EXPECT_EQ(written(where, "[a, 'b, c']"), "<a><name>a</name><name>b, c</name></a>");
  EXPECT_EQ(written(where, "['<&>']"), "<a><name>&lt;&amp;&gt;</name></a>");
  EXPECT_THAT(read(where, "<name>a</name><name>b, c</name><other/>"),
              Optional(Eq("[a, \"b, c\"]")));
  EXPECT_THAT(read(where, ""), Optional(Eq("[]")));
}

TEST(XmlValue, BytesAreDottedHexadecimalNumbers) {
  const Place where = place(Form::hex);
  EXPECT_EQ(written(where, "k=\xff"), "<a><value>6b.3d.ff</value></a>");
  EXPECT_THAT(read(where, "<value>6b.3D.ff</value>"), Optional(Eq("k=\xff")));
  for (const char* wrong :
       {"6b", "<value>6x</value>", "<value>100</value>", "<value>6b..3d</value>"}) {
    EXPECT_EQ(read(where, wrong), std::nullopt) << wrong;
  }
}

TEST(XmlPath, IsFoundOrMade) {
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse("<r><a><b>1</b></a></r>"), tinyxml2::XML_SUCCESS);
  tinyxml2::XMLElement& root = *document.RootElement();
  ASSERT_NE(find_at(root, "a/b"), nullptr);
  EXPECT_STREQ(find_at(root, "a/b")->GetText(), "1");
  EXPECT_EQ(find_at(root, "a/c"), nullptr);
  EXPECT_EQ(find_at(root, "c/b"), nullptr);
  EXPECT_EQ(&make_at(root, "a/b"), find_at(root, "a/b")) << "it is there already";
  make_at(root, "a/c/d").SetText("2");
  EXPECT_STREQ(find_at(root, "a/c/d")->GetText(), "2");
}

}  // namespace
}  // namespace tocsin::qos_tool
