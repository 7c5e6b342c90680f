// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/xml_element.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "kinematics/random_rotations.h"
#include "mjcf/parsed_xml.h"

namespace girdle::xml_element_test {
namespace {

TEST(XmlFile, IsItsElementsInOrder) {
  XmlFile file("root");
  file.root().Add("first").Set("name", "a");
  file.root().Add("second").Add("third");
  EXPECT_EQ(file.Text(),
            "<root>\n  <first name=\"a\"/>\n  <second>\n    <third/>\n  </second>\n"
            "</root>\n");
}

TEST(XmlElement, WritesAQuaternionAsWxyz) {
  XmlFile file("root");
  file.root().Set("quat", Quaternion(0.5, 0.1, 0.2, 0.3));
  EXPECT_EQ(TextOf(ParsedXml(file.Text()).root(), "quat"), "0.5 0.1 0.2 0.3");
}

TEST(XmlElement, WritesNumbersAsTheirShortestDecimals) {
  XmlFile file("root");
  file.root().Set("range", std::array{-0.1, 1e-7, 2.0});
  EXPECT_EQ(TextOf(ParsedXml(file.Text()).root(), "range"), "-0.1 1e-07 2");
}

TEST(XmlElement, WritesNoMinusZero) {
  XmlFile file("root");
  file.root().Set("pos", Vector3(-0.0, 0, -0.0)).Set("gear", -0.0);
  const ParsedXml xml(file.Text());
  EXPECT_EQ(TextOf(xml.root(), "pos"), "0 0 0");
  EXPECT_EQ(TextOf(xml.root(), "gear"), "0");
}

RC_GTEST_PROP(XmlElement, WritesNumbersThatReadBackExactly, ()) {
  const std::vector<double> numbers = {*NumberWithin(-1000, 1000), *NumberWithin(-1e-6, 1e-6)};
  XmlFile file("root");
  file.root().Set("numbers", numbers);
  RC_ASSERT(NumbersOf(ParsedXml(file.Text()).root(), "numbers") == numbers);
}

TEST(XmlElement, KeepsTextThatXmlHasOtherUsesFor) {
  const std::string text = "a<b & \"c\" > 'd'";
  XmlFile file("root");
  file.root().Set("value", text);
  EXPECT_EQ(TextOf(ParsedXml(file.Text()).root(), "value"), text);
}

TEST(XmlElement, WritesCommentsWhereTheyAreAdded) {
  XmlFile file("root");
  file.root().AddComment("one");
  file.root().Add("after");
  EXPECT_EQ(file.Text(), "<root>\n  <!-- one -->\n  <after/>\n</root>\n");
}

}  // namespace
}  // namespace girdle::xml_element_test
