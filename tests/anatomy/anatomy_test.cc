// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/anatomy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "anatomy/built_in_files.h"
#include "text/csv_text.h"
#include "text/input_error.h"

namespace girdle::anatomy_test {
namespace {

using Reader = void (*)(std::istream&, const std::string&, Anatomy&);

Anatomy Read(Reader reader, const CsvText& text) {
  Anatomy anatomy;
  std::istringstream in(text.Text());
  reader(in, "t.csv", anatomy);
  return anatomy;
}

// Changes the text, and returns what the reader says about it.
std::string MessageOn(Reader reader, std::string_view valid, const CsvFlaw& flaw) {
  CsvText text(valid);
  flaw.change(text);
  return MessageOf<InputError>([&] { static_cast<void>(Read(reader, text)); });
}

// Row of a name in the first column.
std::size_t RowOf(const CsvText& text, const std::string& name) {
  for (std::size_t row = 0; row < text.rows.size(); ++row) {
    if (text.rows[row].front() == name) return row;
  }
  throw std::logic_error("the test names no row " + name);
}

double NumberIn(CsvText& text, const std::string& row, const std::string& column) {
  return std::stod(text.Cell(RowOf(text, row), column));
}

TEST(ReadLandmarks, ReadsEachLandmarkUnderItsName) {
  CsvText text(built_in_files::kLandmarks);
  const Anatomy anatomy = Read(ReadLandmarks, text);
  const std::pair<Landmark, const char*> kNames[] = {
      {Landmark::kIJ, "IJ"}, {Landmark::kPX, "PX"},   {Landmark::kC7, "C7"},
      {Landmark::kT8, "T8"}, {Landmark::kSC, "SC"},   {Landmark::kPAC, "PAC"},
      {Landmark::kTS, "TS"}, {Landmark::kAI, "AI"},   {Landmark::kAA, "AA"},
      {Landmark::kPC, "PC"}, {Landmark::kACJ, "ACJ"}, {Landmark::kGC, "GC"},
      {Landmark::kGH, "GH"}, {Landmark::kEM, "EM"},   {Landmark::kEL, "EL"}};
  ASSERT_EQ(std::size(kNames), kLandmarkCount);
  for (const auto& [landmark, name] : kNames) {
    EXPECT_EQ(anatomy.landmark_m(landmark),
              Vector3(NumberIn(text, name, "x_m"), NumberIn(text, name, "y_m"),
                      NumberIn(text, name, "z_m")))
        << name;
  }
}

TEST(ReadLandmarks, TakesRowsInAnyOrder) {
  CsvText text(built_in_files::kLandmarks);
  const Anatomy in_order = Read(ReadLandmarks, text);
  std::reverse(text.rows.begin(), text.rows.end());
  EXPECT_EQ(Read(ReadLandmarks, text).landmarks_m, in_order.landmarks_m);
}

TEST(ReadLandmarks, PutsTheElbowBetweenTheEpicondyles) {
  CsvText text(built_in_files::kLandmarks);
  const Vector3 elbow_m = Read(ReadLandmarks, text).elbow_m();
  EXPECT_DOUBLE_EQ(elbow_m.y, (NumberIn(text, "EM", "y_m") + NumberIn(text, "EL", "y_m")) / 2);
  EXPECT_DOUBLE_EQ(elbow_m.z, (NumberIn(text, "EM", "z_m") + NumberIn(text, "EL", "z_m")) / 2);
}

class FlawedLandmarks : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedLandmarks, AreRefusedWithPlaceAndReason) {
  EXPECT_EQ(MessageOn(ReadLandmarks, built_in_files::kLandmarks, GetParam()), GetParam().message);
}

// IJ PX C7 T8 SC PAC TS AI AA PC ACJ GC GH EM EL stand in lines 2 to 16.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedLandmarks,
    testing::Values(
        CsvFlaw{"missing column", [](CsvText& text) { text.RemoveColumn("y_m"); },
                "t.csv:1: column 'y_m' is missing. The header has: landmark, segment, x_m, z_m"},
        CsvFlaw{"unknown column", [](CsvText& text) { text.AddColumn("note", ""); },
                "t.csv:1: column 'note' is not known. Remove it or correct its name"},
        CsvFlaw{
            "unknown row",
            [](CsvText& text) {
              text.rows.push_back({"XX", "scapula", "0", "0", "0"});
            },
            "t.csv:17: 'XX' is not known. Did you mean 'PX'? Correct the name or remove the row"},
        CsvFlaw{"row twice", [](CsvText& text) { text.rows.push_back(text.rows[6]); },
                "t.csv:17: 'TS' is given twice. Remove one of the rows"},
        CsvFlaw{"missing row", [](CsvText& text) { text.RemoveRow(12); },
                "t.csv:15: no row for GH"},
        CsvFlaw{"another segment's frame",
                [](CsvText& text) { text.Cell(12, "segment") = "humerus"; },
                "t.csv:14: GH is given in the frame of 'humerus', expected 'scapula'"},
        CsvFlaw{"no number", [](CsvText& text) { text.Cell(5, "z_m") = "O.1575"; },
                "t.csv:7: z_m is 'O.1575', expected a finite number such as 22.5"},
        CsvFlaw{"millimeters",
                [](CsvText& text) {
                  text.rows[5] = {"PAC", "clavicle", "0", "0", "157.5"};
                },
                "t.csv:7: a position more than 1 m from the origin. Give meters, not millimeters"},
        CsvFlaw{"negative millimeters",
                [](CsvText& text) {
                  text.rows[13] = {"EM", "humerus", "0", "-289.8", "-34"};
                },
                "t.csv:15: a position more than 1 m from the origin. Give meters, not "
                "millimeters"},
        CsvFlaw{"too far along no axis, but in all",
                [](CsvText& text) {
                  text.rows[13] = {"EM", "humerus", "0.9", "0.9", "0.9"};
                },
                "t.csv:15: a position more than 1 m from the origin. Give meters, not "
                "millimeters"}));

TEST(ReadLandmarks, RefusesEveryLandmarkInMillimeters) {
  const CsvText valid(built_in_files::kLandmarks);
  for (std::size_t row = 0; row < valid.rows.size(); ++row) {
    CsvText text = valid;
    if (text.rows[row].front() == "IJ") continue;  // the origin is 0 in any unit
    for (const char* const column : {"x_m", "y_m", "z_m"}) {
      std::string& cell = text.Cell(row, column);
      cell = std::to_string(1000 * std::stod(cell));
    }
    EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(Read(ReadLandmarks, text)); }),
              "t.csv:" + std::to_string(row + 2) +
                  ": a position more than 1 m from the origin. Give meters, not millimeters");
  }
}

TEST(ReadSegments, ReadsEachSegment) {
  CsvText text(built_in_files::kSegments);
  const Anatomy anatomy = Read(ReadSegments, text);
  const std::pair<Segment, const char*> kNames[] = {{Segment::kThorax, "thorax"},
                                                    {Segment::kClavicle, "clavicle"},
                                                    {Segment::kScapula, "scapula"},
                                                    {Segment::kHumerus, "humerus"}};
  ASSERT_EQ(std::size(kNames), kSegmentCount);
  for (const auto& [segment, name] : kNames) {
    const SegmentInertia& inertia = anatomy.segment(segment);
    EXPECT_EQ(inertia.mass_kg, NumberIn(text, name, "mass_kg")) << name;
    EXPECT_EQ(inertia.center_of_mass_m,
              Vector3(NumberIn(text, name, "com_x_m"), NumberIn(text, name, "com_y_m"),
                      NumberIn(text, name, "com_z_m")))
        << name;
    EXPECT_EQ(inertia.inertia_kg_m2,
              Vector3(NumberIn(text, name, "ixx_kg_m2"), NumberIn(text, name, "iyy_kg_m2"),
                      NumberIn(text, name, "izz_kg_m2")))
        << name;
  }
}

class FlawedSegments : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedSegments, AreRefusedWithPlaceAndReason) {
  EXPECT_EQ(MessageOn(ReadSegments, built_in_files::kSegments, GetParam()), GetParam().message);
}

// thorax clavicle scapula humerus stand in lines 2 to 5.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedSegments,
    testing::Values(
        CsvFlaw{"missing column", [](CsvText& text) { text.RemoveColumn("com_z_m"); },
                "t.csv:1: column 'com_z_m' is missing. The header has: segment, mass_kg, com_x_m, "
                "com_y_m, ixx_kg_m2, iyy_kg_m2, izz_kg_m2"},
        CsvFlaw{"unknown column", [](CsvText& text) { text.AddColumn("ixy_kg_m2", "0"); },
                "t.csv:1: column 'ixy_kg_m2' is not known. Remove it or correct its name"},
        CsvFlaw{"unknown row", [](CsvText& text) { text.Cell(3, "segment") = "forearm"; },
                "t.csv:5: 'forearm' is not known. Correct the name or remove the row"},
        CsvFlaw{"row twice", [](CsvText& text) { text.rows.push_back(text.rows[0]); },
                "t.csv:6: 'thorax' is given twice. Remove one of the rows"},
        CsvFlaw{"missing row", [](CsvText& text) { text.RemoveRow(1); },
                "t.csv:4: no row for clavicle"},
        CsvFlaw{"no mass", [](CsvText& text) { text.Cell(2, "mass_kg") = "0"; },
                "t.csv:4: mass_kg is 0, expected a positive number"},
        CsvFlaw{"negative mass", [](CsvText& text) { text.Cell(2, "mass_kg") = "-0.7"; },
                "t.csv:4: mass_kg is -0.7, expected 0 to 200"},
        CsvFlaw{"grams", [](CsvText& text) { text.Cell(2, "mass_kg") = "704"; },
                "t.csv:4: mass_kg is 704, expected 0 to 200"},
        CsvFlaw{"centre of mass in millimeters",
                [](CsvText& text) { text.Cell(3, "com_y_m") = "-129.195"; },
                "t.csv:5: a position more than 1 m from the origin. Give meters, not millimeters"},
        CsvFlaw{"no inertia", [](CsvText& text) { text.Cell(1, "izz_kg_m2") = "0"; },
                "t.csv:3: izz_kg_m2 is 0, expected a positive number"},
        CsvFlaw{"negative inertia", [](CsvText& text) { text.Cell(1, "ixx_kg_m2") = "-0.00024"; },
                "t.csv:3: ixx_kg_m2 is -0.00024, expected 0 to 100"},
        CsvFlaw{"inertia of another unit", [](CsvText& text) { text.Cell(1, "iyy_kg_m2") = "240"; },
                "t.csv:3: iyy_kg_m2 is 240, expected 0 to 100"},
        CsvFlaw{"inertia that no body has",
                [](CsvText& text) { text.Cell(2, "ixx_kg_m2") = "0.0026"; },
                "t.csv:4: the largest moment of inertia exceeds the sum of the other two, which no "
                "body has"},
        CsvFlaw{"no number", [](CsvText& text) { text.Cell(0, "com_x_m") = "nan"; },
                "t.csv:2: com_x_m is 'nan', expected a finite number such as 22.5"}));

TEST(ReadSegments, TakesTheInertiaOfAFlatPlate) {
  CsvText text(built_in_files::kSegments);
  text.rows[2] = {"scapula", "1", "0", "0", "0", "0.25", "0.5", "0.75"};
  EXPECT_NO_THROW(static_cast<void>(Read(ReadSegments, text)));
}

TEST(ReadJointRanges, ReadsEachRangeInDegrees) {
  CsvText text(built_in_files::kJointRanges);
  const Anatomy anatomy = Read(ReadJointRanges, text);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const std::string name(kCoordinateNames[k]);
    EXPECT_EQ(anatomy.ranges[k].lower_rad, RadiansFromDegrees(NumberIn(text, name, "lower_deg")))
        << name;
    EXPECT_EQ(anatomy.ranges[k].upper_rad, RadiansFromDegrees(NumberIn(text, name, "upper_deg")))
        << name;
  }
}

class FlawedRanges : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedRanges, AreRefusedWithPlaceAndReason) {
  EXPECT_EQ(MessageOn(ReadJointRanges, built_in_files::kJointRanges, GetParam()),
            GetParam().message);
}

// The nine coordinates stand in lines 2 to 10.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedRanges,
    testing::Values(
        CsvFlaw{"missing column", [](CsvText& text) { text.RemoveColumn("upper_deg"); },
                "t.csv:1: column 'upper_deg' is missing. The header has: coordinate, lower_deg"},
        CsvFlaw{"unknown column", [](CsvText& text) { text.AddColumn("note", ""); },
                "t.csv:1: column 'note' is not known. Remove it or correct its name"},
        CsvFlaw{"unknown row", [](CsvText& text) { text.Cell(8, "coordinate") = "gh_rotation"; },
                "t.csv:10: 'gh_rotation' is not known. Did you mean 'sc_rotation'? Correct the "
                "name or remove the row"},
        CsvFlaw{"row twice", [](CsvText& text) { text.rows.push_back(text.rows[4]); },
                "t.csv:14: 'ac_upward_rotation' is given twice. Remove one of the rows"},
        CsvFlaw{"missing row", [](CsvText& text) { text.RemoveRow(0); },
                "t.csv:12: no row for sc_protraction"},
        CsvFlaw{"empty range", [](CsvText& text) { text.Cell(0, "upper_deg") = "-60"; },
                "t.csv:2: lower_deg is not below upper_deg"},
        CsvFlaw{"range upside down", [](CsvText& text) { text.Cell(0, "upper_deg") = "-61"; },
                "t.csv:2: lower_deg is not below upper_deg"},
        CsvFlaw{"beyond half a turn upward",
                [](CsvText& text) { text.Cell(8, "upper_deg") = "181"; },
                "t.csv:10: upper_deg is 181, expected -180 to 180"},
        CsvFlaw{"beyond half a turn downward",
                [](CsvText& text) { text.Cell(8, "lower_deg") = "-181"; },
                "t.csv:10: lower_deg is -181, expected -180 to 180"},
        CsvFlaw{"no number", [](CsvText& text) { text.Cell(3, "lower_deg") = "3O"; },
                "t.csv:5: lower_deg is '3O', expected a finite number such as 22.5"}));

TEST(ReadThoraxEllipsoids, ReadsBoth) {
  CsvText text(built_in_files::kThoraxEllipsoids);
  const Anatomy anatomy = Read(ReadThoraxEllipsoids, text);
  for (const auto& [ellipsoid, name] :
       {std::pair(anatomy.ribcage, "ribcage"), std::pair(anatomy.gliding, "gliding")}) {
    EXPECT_EQ(ellipsoid.center_m,
              Vector3(NumberIn(text, name, "center_x_m"), NumberIn(text, name, "center_y_m"),
                      NumberIn(text, name, "center_z_m")))
        << name;
    EXPECT_EQ(ellipsoid.radii_m,
              Vector3(NumberIn(text, name, "radius_x_m"), NumberIn(text, name, "radius_y_m"),
                      NumberIn(text, name, "radius_z_m")))
        << name;
  }
}

class FlawedEllipsoids : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedEllipsoids, AreRefusedWithPlaceAndReason) {
  EXPECT_EQ(MessageOn(ReadThoraxEllipsoids, built_in_files::kThoraxEllipsoids, GetParam()),
            GetParam().message);
}

// ribcage and gliding stand in lines 2 and 3.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedEllipsoids,
    testing::Values(
        CsvFlaw{"missing column", [](CsvText& text) { text.RemoveColumn("radius_x_m"); },
                "t.csv:1: column 'radius_x_m' is missing. The header has: ellipsoid, center_x_m, "
                "center_y_m, center_z_m, radius_y_m, radius_z_m"},
        CsvFlaw{"unknown column", [](CsvText& text) { text.AddColumn("turn_deg", "0"); },
                "t.csv:1: column 'turn_deg' is not known. Remove it or correct its name"},
        CsvFlaw{"unknown row", [](CsvText& text) { text.Cell(1, "ellipsoid") = "skin"; },
                "t.csv:3: 'skin' is not known. Correct the name or remove the row"},
        CsvFlaw{"row twice", [](CsvText& text) { text.rows.push_back(text.rows[1]); },
                "t.csv:4: 'gliding' is given twice. Remove one of the rows"},
        CsvFlaw{"missing row", [](CsvText& text) { text.RemoveRow(1); },
                "t.csv:2: no row for gliding"},
        CsvFlaw{"no radius", [](CsvText& text) { text.Cell(1, "radius_y_m") = "0"; },
                "t.csv:3: radius_y_m is 0, expected a positive number"},
        CsvFlaw{"negative radius", [](CsvText& text) { text.Cell(0, "radius_z_m") = "-0.147"; },
                "t.csv:2: radius_z_m is -0.147, expected 0 to 1"},
        CsvFlaw{"radius in millimeters", [](CsvText& text) { text.Cell(0, "radius_z_m") = "147"; },
                "t.csv:2: radius_z_m is 147, expected 0 to 1"},
        CsvFlaw{"centre in millimeters", [](CsvText& text) { text.Cell(0, "center_y_m") = "-149"; },
                "t.csv:2: a position more than 1 m from the origin. Give meters, not millimeters"},
        CsvFlaw{"no number", [](CsvText& text) { text.Cell(0, "center_x_m") = ""; },
                "t.csv:2: center_x_m is '', expected a finite number such as 22.5"}));

TEST(LandmarksToCsv, IsReadBackBitByBit) {
  Anatomy anatomy;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    anatomy.landmarks_m.at(i) = Vector3{1, -2, 0.5} / (3.0 * static_cast<double>(i + 1));
  }
  std::istringstream in(LandmarksToCsv(anatomy, {"# how", "# it was made"}));
  Anatomy read;
  ReadLandmarks(in, "t.csv", read);
  EXPECT_EQ(read.landmarks_m, anatomy.landmarks_m);
}

TEST(ThoraxEllipsoidsToCsv, IsReadBack) {
  Anatomy anatomy;
  anatomy.ribcage = {{-0.059, -0.149, 0}, {0.094, 0.208, 0.147}};
  anatomy.gliding = {{-0.0871, 0.0832, 0.0493}, {0.0774, 0.2015, 0.0766}};
  std::istringstream in(ThoraxEllipsoidsToCsv(anatomy, {"# how", "# it was made"}));
  Anatomy again;
  ReadThoraxEllipsoids(in, "t.csv", again);
  for (const auto& [read, written] :
       {std::pair(again.ribcage, anatomy.ribcage), std::pair(again.gliding, anatomy.gliding)}) {
    EXPECT_EQ(read.center_m, written.center_m);
    EXPECT_EQ(read.radii_m, written.radii_m);
  }
}

TEST(ReadLigaments, ReadsBoth) {
  CsvText text(built_in_files::kLigaments);
  const Anatomy anatomy = Read(ReadLigaments, text);
  for (const auto& [ligament, name] :
       {std::pair(anatomy.ligament(LigamentName::kConoid), "conoid"),
        std::pair(anatomy.ligament(LigamentName::kTrapezoid), "trapezoid")}) {
    EXPECT_EQ(ligament.clavicle_m,
              Vector3(NumberIn(text, name, "clavicle_x_m"), NumberIn(text, name, "clavicle_y_m"),
                      NumberIn(text, name, "clavicle_z_m")))
        << name;
    EXPECT_EQ(ligament.scapula_m,
              Vector3(NumberIn(text, name, "scapula_x_m"), NumberIn(text, name, "scapula_y_m"),
                      NumberIn(text, name, "scapula_z_m")))
        << name;
    EXPECT_EQ(ligament.slack_m, NumberIn(text, name, "slack_m")) << name;
    EXPECT_EQ(ligament.stiffness_N_per_m, NumberIn(text, name, "stiffness_N_per_m")) << name;
    EXPECT_EQ(ligament.failure_elongation_m, NumberIn(text, name, "failure_elongation_m")) << name;
    EXPECT_EQ(ligament.published_m, NumberIn(text, name, "published_m")) << name;
    EXPECT_EQ(ligament.published_sd_m, NumberIn(text, name, "published_sd_m")) << name;
  }
}

class FlawedLigaments : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedLigaments, AreRefusedWithPlaceAndReason) {
  EXPECT_EQ(MessageOn(ReadLigaments, built_in_files::kLigaments, GetParam()), GetParam().message);
}

// conoid and trapezoid stand in lines 2 and 3.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedLigaments,
    testing::Values(
        CsvFlaw{"missing column", [](CsvText& text) { text.RemoveColumn("slack_m"); },
                "t.csv:1: column 'slack_m' is missing. The header has: ligament, clavicle_x_m, "
                "clavicle_y_m, clavicle_z_m, scapula_x_m, scapula_y_m, scapula_z_m, "
                "stiffness_N_per_m, failure_elongation_m, published_m, published_sd_m"},
        CsvFlaw{"unknown column", [](CsvText& text) { text.AddColumn("damping", "0"); },
                "t.csv:1: column 'damping' is not known. Remove it or correct its name"},
        CsvFlaw{"unknown row", [](CsvText& text) { text.Cell(1, "ligament") = "costoclavicular"; },
                "t.csv:3: 'costoclavicular' is not known. Correct the name or remove the row"},
        CsvFlaw{"row twice", [](CsvText& text) { text.rows.push_back(text.rows[0]); },
                "t.csv:4: 'conoid' is given twice. Remove one of the rows"},
        CsvFlaw{"missing row", [](CsvText& text) { text.RemoveRow(1); },
                "t.csv:2: no row for trapezoid"},
        CsvFlaw{"clavicle's attachment in millimeters",
                [](CsvText& text) { text.Cell(0, "clavicle_z_m") = "129.3"; },
                "t.csv:2: a position more than 1 m from the origin. Give meters, not millimeters"},
        CsvFlaw{"scapula's attachment in millimeters",
                [](CsvText& text) { text.Cell(1, "scapula_z_m") = "-26.4"; },
                "t.csv:3: a position more than 1 m from the origin. Give meters, not millimeters"},
        CsvFlaw{"slack in millimeters", [](CsvText& text) { text.Cell(0, "slack_m") = "24"; },
                "t.csv:2: slack_m is 24, expected 0 to 0.2"},
        CsvFlaw{"no slack", [](CsvText& text) { text.Cell(0, "slack_m") = "0"; },
                "t.csv:2: slack_m is 0, expected a positive number"},
        CsvFlaw{"no stiffness", [](CsvText& text) { text.Cell(1, "stiffness_N_per_m") = "0"; },
                "t.csv:3: stiffness_N_per_m is 0, expected a positive number"},
        CsvFlaw{"a ligament that pushes",
                [](CsvText& text) { text.Cell(1, "stiffness_N_per_m") = "-51500"; },
                "t.csv:3: stiffness_N_per_m is -51500, expected 0 to 1e+07"},
        CsvFlaw{"elongation in millimeters",
                [](CsvText& text) { text.Cell(0, "failure_elongation_m") = "7.7"; },
                "t.csv:2: failure_elongation_m is 7.7, expected 0 to 0.2"},
        CsvFlaw{"published length in millimeters",
                [](CsvText& text) { text.Cell(0, "published_m") = "12.3"; },
                "t.csv:2: published_m is 12.3, expected 0 to 0.2"},
        CsvFlaw{"negative deviation",
                [](CsvText& text) { text.Cell(0, "published_sd_m") = "-0.0066"; },
                "t.csv:2: published_sd_m is -0.0066, expected 0 to 0.2"},
        CsvFlaw{"no number", [](CsvText& text) { text.Cell(0, "scapula_y_m") = "O"; },
                "t.csv:2: scapula_y_m is 'O', expected a finite number such as 22.5"}));

}  // namespace
}  // namespace girdle::anatomy_test
