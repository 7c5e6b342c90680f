// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/model_mapping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "text/csv_text.h"
#include "text/input_error.h"

namespace girdle::model_mapping_test {
namespace {

// Numbers and sums of few of them.
constexpr double kRounding = 1e-14;

// Rows: 0 side, 1 thorax, 2 PAC, 3 TS, 4 AI, 5 GH, 6 EM, 7 EL, 8 and 9 the arm.
constexpr const char* kValid =
    "part,by,name,x_m,y_m,z_m,y_deg,x_deg,z_deg,per_elevation,per_plane,per_axial,offset_deg\n"
    "side,,right,,,,,,,,,,\n"
    "thorax,body,trunk,,,,30,-20,10,,,,\n"
    "PAC,site,acromion,,,,,,,,,,\n"
    "TS,body,blade,-0.08,-0.01,-0.1,,,,,,,\n"
    "AI,body,blade,-0.1,-0.12,-0.07,,,,,,,\n"
    "GH,body,arm,0,0,0,,,,,,,\n"
    "EM,body,arm,0,-0.28,-0.04,,,,,,,\n"
    "EL,body,arm,0,-0.28,0.02,,,,,,,\n"
    "arm,joint,raise,,,,,,,1,,,-2\n"
    "arm,joint,swing,,,,,,,,-1,0.5,\n";

ModelMapping Read(const CsvText& text) {
  std::istringstream in(text.Text());
  return ReadModelMapping(in, "m.csv");
}

TEST(ReadModelMapping, ReadsLandmarksBonesAndDrives) {
  const ModelMapping mapping = Read(CsvText(kValid));
  EXPECT_EQ(mapping.file, "m.csv");
  EXPECT_EQ(mapping.side, Side::kRight);
  ASSERT_TRUE(mapping.landmark(Landmark::kPAC));
  const auto* const site = std::get_if<MappedSite>(&mapping.landmark(Landmark::kPAC)->place);
  ASSERT_NE(site, nullptr);
  EXPECT_EQ(site->name, "acromion");
  EXPECT_EQ(mapping.landmark(Landmark::kPAC)->line, 4U);
  ASSERT_TRUE(mapping.landmark(Landmark::kTS));
  const auto* const point = std::get_if<MappedBodyPoint>(&mapping.landmark(Landmark::kTS)->place);
  ASSERT_NE(point, nullptr);
  EXPECT_EQ(point->body, "blade");
  EXPECT_EQ(point->point_m, Vector3(-0.08, -0.01, -0.1));
  EXPECT_FALSE(mapping.landmark(Landmark::kIJ));
  ASSERT_TRUE(mapping.bone(Segment::kThorax));
  EXPECT_EQ(mapping.bone(Segment::kThorax)->body, "trunk");
  EXPECT_LT(AngleBetween(mapping.bone(Segment::kThorax)->q_BF,
                         QuaternionFromEuler(EulerSequence::kYXZ,
                                             {RadiansFromDegrees(30), RadiansFromDegrees(-20),
                                              RadiansFromDegrees(10)})),
            kRounding);
  EXPECT_FALSE(mapping.drives_are_actuators);
  ASSERT_EQ(mapping.drives.size(), 2U);
  EXPECT_EQ(mapping.drives[0].name, "raise");
  EXPECT_EQ(mapping.drives[0].per_elevation, 1);
  EXPECT_NEAR(mapping.drives[0].offset_rad, RadiansFromDegrees(-2), kRounding);
  EXPECT_EQ(mapping.drives[1].per_plane, -1);
  EXPECT_EQ(mapping.drives[1].per_axial, 0.5);
  EXPECT_EQ(mapping.drives[1].offset_rad, 0);
}

TEST(ReadModelMapping, NeedsOnlyTheColumnsThatItsRowsFill) {
  CsvText text(kValid);
  for (const char* const column : {"x_m", "y_m", "z_m"}) {
    text.RemoveColumn(column);
  }
  for (auto& row : text.rows) {
    if (row[1] == "body" && row[0] != "thorax") row[1] = "site";
  }
  EXPECT_NO_THROW(static_cast<void>(Read(text)));
}

TEST(ReadModelMapping, TakesRowsInAnyOrderAndTheLeftSide) {
  CsvText text(kValid);
  text.Cell(0, "name") = "left";
  std::reverse(text.rows.begin(), text.rows.end());
  EXPECT_EQ(Read(text).side, Side::kLeft);
}

TEST(ReadModelMapping, TakesActuators) {
  CsvText text(kValid);
  text.Cell(8, "by") = "actuator";
  text.Cell(9, "by") = "actuator";
  EXPECT_TRUE(Read(text).drives_are_actuators);
}

TEST(ReadModelMapping, TakesABoneByItsBodyInPlaceOfItsLandmarks) {
  CsvText text(kValid);
  text.rows[2] = {"scapula", "body", "blade", "", "", "", "1", "2", "3", "", "", "", ""};
  text.RemoveRow(4);
  text.RemoveRow(3);
  EXPECT_TRUE(Read(text).bone(Segment::kScapula));
}

class ReadModelMappingBadTest : public testing::TestWithParam<CsvFlaw> {};

TEST_P(ReadModelMappingBadTest, SaysWhere) {
  CsvText text(kValid);
  GetParam().change(text);
  const std::string message = MessageOf<InputError>([&] { static_cast<void>(Read(text)); });
  EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    , ReadModelMappingBadTest,
    testing::Values(
        CsvFlaw{"UnknownColumn", [](CsvText& text) { text.AddColumn("size", ""); },
                "m.csv:1: column 'size' is not known"},
        CsvFlaw{"NoColumnBy", [](CsvText& text) { text.RemoveColumn("by"); },
                "m.csv:1: column 'by' is missing"},
        CsvFlaw{"UnknownPart", [](CsvText& text) { text.Cell(3, "part") = "TSS"; },
                "m.csv:5: part 'TSS' is not known. Did you mean 'TS'? Choose one of: side, arm, "
                "thorax,"},
        CsvFlaw{"NoName", [](CsvText& text) { text.Cell(3, "name") = ""; },
                "m.csv:5: the row of 'TS' has no name"},
        CsvFlaw{"LandmarkTwice", [](CsvText& text) { text.rows.push_back(text.rows[3]); },
                "m.csv:12: 'TS' is given twice. Remove one of the rows"},
        CsvFlaw{"BoneTwice", [](CsvText& text) { text.rows.push_back(text.rows[1]); },
                "m.csv:12: 'thorax' is given twice"},
        CsvFlaw{"SideTwice", [](CsvText& text) { text.rows.push_back(text.rows[0]); },
                "m.csv:12: 'side' is given twice"},
        CsvFlaw{"JointTwice", [](CsvText& text) { text.rows.push_back(text.rows[8]); },
                "m.csv:12: 'raise' is given twice"},
        CsvFlaw{"NoSide", [](CsvText& text) { text.RemoveRow(0); },
                "m.csv: no row for side. Add one: side,,right"},
        CsvFlaw{"UnknownSide", [](CsvText& text) { text.Cell(0, "name") = "both"; },
                "m.csv:2: side 'both' is not known. Choose right or left"},
        CsvFlaw{"LandmarkMissing", [](CsvText& text) { text.RemoveRow(4); },
                "m.csv: no row for AI, which the frame of the scapula needs. Add it, or a row "
                "scapula,body,NAME"},
        CsvFlaw{"ThoraxMissing", [](CsvText& text) { text.RemoveRow(1); },
                "m.csv: no row for IJ, which the frame of the thorax needs"},
        CsvFlaw{"LandmarkByGeom", [](CsvText& text) { text.Cell(3, "by") = "geom"; },
                "m.csv:5: 'TS' is given by 'geom'. Choose one of: body, site"},
        CsvFlaw{"BoneBySite", [](CsvText& text) { text.Cell(1, "by") = "site"; },
                "m.csv:3: 'thorax' is given by 'site'. Choose one of: body"},
        CsvFlaw{"SideByBody", [](CsvText& text) { text.Cell(0, "by") = "body"; },
                "m.csv:2: 'side' is given by 'body'. Leave the column by empty"},
        CsvFlaw{"ArmByTendon", [](CsvText& text) { text.Cell(8, "by") = "tendon"; },
                "m.csv:10: 'arm' is given by 'tendon'. Choose one of: joint, actuator"},
        CsvFlaw{"JointsAndActuators", [](CsvText& text) { text.Cell(9, "by") = "actuator"; },
                "m.csv:11: the arm is set by joints and by actuators"},
        CsvFlaw{"Millimeters", [](CsvText& text) { text.Cell(3, "z_m") = "-100"; },
                "m.csv:5: a point more than 1 m from its body. Give meters, not millimeters"},
        CsvFlaw{"NotANumber", [](CsvText& text) { text.Cell(3, "z_m") = "-0.1O"; }, "m.csv:5: "},
        CsvFlaw{"NoPoint", [](CsvText& text) { text.Cell(3, "y_m") = ""; },
                "m.csv:5: 'TS' by body needs y_m"},
        CsvFlaw{"NoTurn", [](CsvText& text) { text.Cell(1, "z_deg") = ""; },
                "m.csv:3: 'thorax' by body needs z_deg"},
        CsvFlaw{"TurnTooFar", [](CsvText& text) { text.Cell(1, "z_deg") = "361"; }, "m.csv:3: "},
        CsvFlaw{"PointOfASite", [](CsvText& text) { text.Cell(2, "x_m") = "0"; },
                "m.csv:4: 'PAC' by 'site' has no x_m. Leave it empty"},
        CsvFlaw{"FactorOfALandmark", [](CsvText& text) { text.Cell(3, "per_plane") = "1"; },
                "m.csv:5: 'TS' by 'body' has no per_plane. Leave it empty"},
        CsvFlaw{"OffsetOfABone", [](CsvText& text) { text.Cell(1, "offset_deg") = "1"; },
                "m.csv:3: 'thorax' by 'body' has no offset_deg. Leave it empty"},
        CsvFlaw{"FactorInDegrees", [](CsvText& text) { text.Cell(8, "per_elevation") = "57.3"; },
                "m.csv:10: "},
        CsvFlaw{"NoElevation", [](CsvText& text) { text.RemoveRow(8); },
                "m.csv: nothing sets the elevation. Add a row arm,joint,NAME with per_elevation"},
        CsvFlaw{"NoPlane", [](CsvText& text) { text.RemoveRow(9); },
                "m.csv: nothing sets the plane. Add a row arm,joint,NAME with per_plane"}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace girdle::model_mapping_test
