// SPDX-License-Identifier: Apache-2.0
// Values as XML, in each form.
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include "dialect.hpp"

namespace tocsin::qos_tool {
namespace {

Place place(Form form, const char* suffix = "") { return {"p", "a/b", form, suffix}; }

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
  const Place dds = place(Form::word, "_DURABILITY_QOS");
  EXPECT_EQ(written(dds, "volatile"), "<a>VOLATILE_DURABILITY_QOS</a>");
}

TEST(XmlValue, SecondsAreWholeOnesAndNanoseconds) {
  const Place where = place(Form::seconds);
  EXPECT_EQ(written(where, "1.25"), "<a><sec>1</sec><nanosec>250000000</nanosec></a>");
  EXPECT_EQ(written(where, "0.29"), "<a><sec>0</sec><nanosec>290000000</nanosec></a>");
  EXPECT_EQ(written(where, ".inf"),
            "<a><sec>DURATION_INFINITE_SEC</sec><nanosec>DURATION_INFINITE_NSEC</nanosec></a>");
}

TEST(XmlValue, NumbersMayBeUnlimited) {
  const Place where = place(Form::number);
  EXPECT_EQ(written(where, "17"), "<a>17</a>");
}

TEST(XmlValue, FlagsMayBeTheOppositeOfOurs) {
  EXPECT_EQ(written(place(Form::flag), "true"), "<a>true</a>");
  EXPECT_EQ(written(place(Form::not_flag), "true"), "<a>false</a>");
  EXPECT_EQ(written(place(Form::not_flag), "false"), "<a>true</a>");
}

TEST(XmlValue, NamesAreElements) {
  const Place where = place(Form::names, "name");
  EXPECT_EQ(written(where, "[a, 'b, c']"), "<a><name>a</name><name>b, c</name></a>");
  EXPECT_EQ(written(where, "['<&>']"), "<a><name>&lt;&amp;&gt;</name></a>");
}

TEST(XmlValue, BytesAreDottedHexadecimalNumbers) {
  const Place where = place(Form::hex);
  EXPECT_EQ(written(where, "k=\xff"), "<a><value>6b.3d.ff</value></a>");
}

TEST(XmlPath, IsMadeWhereItIsMissing) {
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse("<r><a><b>1</b></a></r>"), tinyxml2::XML_SUCCESS);
  tinyxml2::XMLElement& root = *document.RootElement();
  EXPECT_STREQ(make_at(root, "a/b").GetText(), "1");
  make_at(root, "a/c/d").SetText("2");
  EXPECT_STREQ(make_at(root, "a/c/d").GetText(), "2");
}

}  // namespace
}  // namespace tocsin::qos_tool
