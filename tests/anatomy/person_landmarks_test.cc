// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/person_landmarks.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <iterator>
#include <map>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "anatomy/built_in_files.h"
#include "anatomy/humeral_head.h"
#include "kinematics/random_rotations.h"
#include "rhythm_tables/built_in_tables.h"
#include "text/csv_text.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle::person_landmarks_test {
namespace {

// Positions some metres from the origin, turned there and back.
constexpr double kRounding_m = 1e-14;

const Anatomy& Adult() {
  static const Anatomy kAnatomy = BuiltInAnatomy();
  return kAnatomy;
}

Anatomy Read(const std::string& text) {
  std::istringstream in(text);
  return ReadPersonAnatomy(in, "t.csv", Adult());
}

std::string MessageOn(const std::string& text) {
  return MessageOf<InputError>([&] { static_cast<void>(Read(text)); });
}

std::string ExampleText() {
  std::ifstream in(std::string(GIRDLE_SOURCE_DIR) + "/data/example_lab_landmarks.csv");
  return {std::istreambuf_iterator<char>(in), {}};
}

double LargestDifference_m(const Anatomy& a, const Anatomy& b) {
  double largest_m = 0;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    // Written so that a NaN is the largest of all.
    const double off_m = glm::distance(a.landmarks_m.at(i), b.landmarks_m.at(i));
    if (!(off_m <= largest_m)) largest_m = off_m;
  }
  return largest_m;
}

const Vector3& LandmarkOf(const Anatomy& anatomy, const std::string& name) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    if (kLandmarks.at(i).name == name) return anatomy.landmarks_m.at(i);
  }
  throw std::logic_error("the test names no landmark " + name);
}

// A file made of rows.
class Rows {
 public:
  void Add(const std::string& landmark, const std::string& segment, const Vector3& p_m) {
    text_ += landmark + "," + segment;
    for (const double coordinate_m : {p_m.x, p_m.y, p_m.z}) {
      text_ += "," + NumberText(coordinate_m);
    }
    text_ += "\n";
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_ = "landmark,segment,x_m,y_m,z_m\n";
};

struct Placement {
  Quaternion q_AB;
  Vector3 p_AB_m;

  [[nodiscard]] Vector3 operator()(const Vector3& p_m) const { return p_AB_m + q_AB * p_m; }
};

rc::Gen<Placement> AnyPlacement() {
  return rc::gen::exec([] { return Placement{*UnitQuaternion(), *VectorWithin(-3, 3)}; });
}

const std::vector<std::string> kIsbLandmarks = {"IJ", "PX", "C7", "T8", "SC", "PAC", "AA",
                                                "TS", "AI", "PC", "GH", "EM", "EL"};

// All landmarks of `anatomy` in one laboratory frame, the arm as `pose` has it.
std::string DigitisedInALab(const Anatomy& anatomy, const ShoulderPose& pose,
                            const Placement& lab) {
  const auto& at = [&](Landmark landmark) { return anatomy.landmark_m(landmark); };
  const Quaternion q_TS = pose.q_TC * pose.q_CS;
  const Vector3 pac_m = at(Landmark::kSC) + pose.q_TC * at(Landmark::kPAC);
  const Vector3 gh_m = pac_m + q_TS * at(Landmark::kGH);
  Rows rows;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const Vector3& p_m = anatomy.landmarks_m.at(i);
    const std::array<Vector3, kSegmentCount> in_thorax_m = {
        p_m, at(Landmark::kSC) + pose.q_TC * p_m, pac_m + q_TS * p_m, gh_m + pose.q_TH() * p_m};
    rows.Add(std::string(kLandmarks.at(i).name), "lab",
             lab(in_thorax_m.at(static_cast<std::size_t>(kLandmarks.at(i).segment))));
  }
  return rows.text();
}

// --- What comes out -------------------------------------------------------------------------

TEST(ReadPersonAnatomy, OfTheShippedLandmarksIsTheBuiltInAnatomyBitByBit) {
  const Anatomy anatomy = Read(std::string(built_in_files::kLandmarks));
  EXPECT_EQ(anatomy.landmarks_m, Adult().landmarks_m);
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    EXPECT_EQ(anatomy.segments.at(i).mass_kg, Adult().segments.at(i).mass_kg);
    EXPECT_EQ(anatomy.segments.at(i).center_of_mass_m, Adult().segments.at(i).center_of_mass_m);
    EXPECT_EQ(anatomy.segments.at(i).inertia_kg_m2, Adult().segments.at(i).inertia_kg_m2);
  }
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(anatomy.ranges.at(k).lower_rad, Adult().ranges.at(k).lower_rad);
    EXPECT_EQ(anatomy.ranges.at(k).upper_rad, Adult().ranges.at(k).upper_rad);
  }
  EXPECT_EQ(anatomy.ribcage.radii_m, Adult().ribcage.radii_m);
  EXPECT_EQ(anatomy.gliding.center_m, Adult().gliding.center_m);
  EXPECT_EQ(anatomy.jugular_notch_height_m, Adult().jugular_notch_height_m);
}

// The example holds micrometers; a frame of short landmarks turns by some of them.
TEST(ReadPersonAnatomy, OfTheExampleIsTheBuiltInAnatomyToItsDecimals) {
  constexpr double kMicrometers_m = 5e-6;
  EXPECT_LT(LargestDifference_m(Read(ExampleText()), Adult()), kMicrometers_m);
}

// Whatever the posture, and wherever the laboratory has its origin.
RC_GTEST_PROP(ReadPersonAnatomy, UndoesPostureAndLaboratory, ()) {
  static const ShoulderRhythm kRhythm = BuiltInRhythm();
  const ShoulderPose pose = kRhythm.SolvePose(
      {RadiansFromDegrees(*NumberWithin(0, 140)), RadiansFromDegrees(*NumberWithin(-30, 120))});
  const Anatomy person = ScaledAnatomy(Adult(), {.clavicle_length_m = *NumberWithin(0.12, 0.18),
                                                 .stature_m = *NumberWithin(1.4, 2)});
  const Anatomy found = Read(DigitisedInALab(person, pose, *AnyPlacement()));
  RC_ASSERT(LargestDifference_m(found, person) < kRounding_m);
}

// Each segment in a frame of its own, the origins given as rows.
RC_GTEST_PROP(ReadPersonAnatomy, TakesAnyFrameOfEachSegment, ()) {
  const std::pair<const char*, Segment> kOrigins[] = {
      {"SC", Segment::kClavicle}, {"PAC", Segment::kScapula}, {"GH", Segment::kHumerus}};
  std::array<Placement, kSegmentCount> frames;
  for (Placement& frame : frames) frame = *AnyPlacement();
  // But for a humerus that looks like EM and EL swapped.
  RC_PRE(AngleBetween(frames[3].q_AB, Quaternion(0, 0, 1, 0)) > RadiansFromDegrees(16));
  Rows rows;
  for (const auto& [name, segment] : kOrigins) {
    const auto index = static_cast<std::size_t>(segment);
    rows.Add(name, std::string(kSegmentNames.at(index)), frames.at(index)({0, 0, 0}));
  }
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto index = static_cast<std::size_t>(kLandmarks.at(i).segment);
    rows.Add(std::string(kLandmarks.at(i).name), std::string(kSegmentNames.at(index)),
             frames.at(index)(Adult().landmarks_m.at(i)));
  }
  RC_ASSERT(LargestDifference_m(Read(rows.text()), Adult()) < kRounding_m);
}

// Without a row an origin is 0 0 0 of its segment's frame.
RC_GTEST_PROP(ReadPersonAnatomy, TakesZeroForAnOriginThatIsNotGiven, ()) {
  const Quaternion turn = *UnitQuaternion();
  RC_PRE(AngleBetween(turn, Quaternion(0, 0, 1, 0)) > RadiansFromDegrees(16));
  Rows rows;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto index = static_cast<std::size_t>(kLandmarks.at(i).segment);
    rows.Add(std::string(kLandmarks.at(i).name), std::string(kSegmentNames.at(index)),
             turn * Adult().landmarks_m.at(i));
  }
  RC_ASSERT(LargestDifference_m(Read(rows.text()), Adult()) < kRounding_m);
}

TEST(ReadPersonAnatomy, TakesAcForPac) {
  CsvText text(built_in_files::kLandmarks);
  text.rows.at(5).at(0) = "AC";
  EXPECT_EQ(Read(text.Text()).landmarks_m, Adult().landmarks_m);
}

TEST(ReadPersonAnatomy, TakesRowsInAnyOrder) {
  CsvText text(ExampleText());
  const Anatomy in_order = Read(text.Text());
  std::reverse(text.rows.begin(), text.rows.end());
  EXPECT_EQ(Read(text.Text()).landmarks_m, in_order.landmarks_m);
}

// What the ISB does not know comes from the built-in scapula, in this one's size.
TEST(ReadPersonAnatomy, FillsInTheJointCentreAndTheGlenoid) {
  constexpr double kScale = 1.2;
  Rows rows;
  for (const std::string& name : kIsbLandmarks) {
    const bool is_scapular = name != "PAC" && name != "IJ" && name != "PX" && name != "C7" &&
                             name != "T8" && name != "SC" && name != "EM" && name != "EL";
    const std::string segment = is_scapular                    ? "scapula"
                                : name == "PAC"                ? "clavicle"
                                : name == "EM" || name == "EL" ? "humerus"
                                                               : "thorax";
    rows.Add(name, segment, (is_scapular ? kScale : 1) * LandmarkOf(Adult(), name));
  }
  const Anatomy anatomy = Read(rows.text());
  for (const Landmark landmark : {Landmark::kACJ, Landmark::kGC}) {
    EXPECT_LT(glm::distance(anatomy.landmark_m(landmark), kScale * Adult().landmark_m(landmark)),
              kRounding_m);
  }
}

TEST(ReadPersonAnatomy, KeepsTheWayFromTheGlenoidToGh) {
  CsvText text(built_in_files::kLandmarks);
  text.RemoveRow(11);  // GC
  constexpr double kOff_m = 0.004;
  text.Cell(11, "x_m") = std::to_string(0.0081 + kOff_m);  // GH
  const Anatomy anatomy = Read(text.Text());
  EXPECT_LT(glm::distance(anatomy.landmark_m(Landmark::kGC) - anatomy.landmark_m(Landmark::kGH),
                          Adult().landmark_m(Landmark::kGC) - Adult().landmark_m(Landmark::kGH)),
            kRounding_m);
}

// A person of another size from head to foot is the built-in one in that size.
TEST(ReadPersonAnatomy, GivesMassesAndEllipsoidsTheSizeOfTheBones) {
  constexpr double kRelativeRounding = 1e-13;
  const Anatomy tall = ScaledAnatomy(Adult(), {.stature_m = 1.9});
  Rows rows;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    rows.Add(std::string(kLandmarks.at(i).name), std::string(Name(kLandmarks.at(i).segment)),
             tall.landmarks_m.at(i));
  }
  const Anatomy found = Read(rows.text());
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    EXPECT_NEAR(found.segments.at(i).mass_kg / tall.segments.at(i).mass_kg, 1, kRelativeRounding);
    EXPECT_LT(
        glm::distance(found.segments.at(i).center_of_mass_m, tall.segments.at(i).center_of_mass_m),
        kRelativeRounding);
    EXPECT_LT(glm::distance(found.segments.at(i).inertia_kg_m2, tall.segments.at(i).inertia_kg_m2),
              kRelativeRounding);
  }
  EXPECT_LT(glm::distance(found.ribcage.radii_m, tall.ribcage.radii_m), kRelativeRounding);
  EXPECT_LT(glm::distance(found.gliding.center_m, tall.gliding.center_m), kRelativeRounding);
  EXPECT_NEAR(found.jugular_notch_height_m, tall.jugular_notch_height_m, kRelativeRounding);
}

TEST(ReadPersonAnatomy, DoesNotClaimThatTheGlidingEllipsoidFits) {
  EXPECT_FALSE(Read(std::string(built_in_files::kLandmarks)).has_adult_proportions);
}

// --- What is refused ------------------------------------------------------------------------

// Each cell of a row times `factor`.
void Scale(CsvText& text, std::size_t row, double factor) {
  for (const char* const column : {"x_m", "y_m", "z_m"}) {
    std::string& cell = text.Cell(row, column);
    cell = NumberText(std::stod(cell) * factor);
  }
}

void ScaleAll(CsvText& text, double factor) {
  for (std::size_t row = 0; row < text.rows.size(); ++row) Scale(text, row, factor);
}

void NegateZ(CsvText& text, std::size_t row) {
  std::string& cell = text.Cell(row, "z_m");
  cell = NumberText(-std::stod(cell));
}

// Gives two landmarks each other's names, in rows that keep their segments.
void SwapNames(CsvText& text, std::size_t a, std::size_t b) {
  std::swap(text.rows.at(a).at(0), text.rows.at(b).at(0));
}

class FlawedPerson : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedPerson, InSegmentsFramesIsRefusedWithPlaceAndFix) {
  CsvText text(built_in_files::kLandmarks);
  GetParam().change(text);
  EXPECT_EQ(MessageOn(text.Text()), GetParam().message);
}

// IJ PX C7 T8 SC PAC TS AI AA PC ACJ GC GH EM EL stand in lines 2 to 16.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedPerson,
    testing::Values(
        CsvFlaw{"missing column", [](CsvText& text) { text.RemoveColumn("y_m"); },
                "t.csv:1: column 'y_m' is missing. The header has: landmark, segment, x_m, z_m"},
        CsvFlaw{"millimeters in the header", [](CsvText& text) { text.columns.at(2) = "x_mm"; },
                "t.csv:1: column 'x_mm' is not known. Did you mean 'x_m'? Remove it or correct its "
                "name"},
        CsvFlaw{"unknown landmark", [](CsvText& text) { text.Cell(8, "landmark") = "AX"; },
                "t.csv:10: 'AX' is not a landmark. Known are IJ PX C7 T8 SC PAC TS AI AA PC ACJ GC "
                "GH EM EL, AC for PAC, and HH1 HH2 ... for points of the humeral head"},
        CsvFlaw{"row twice", [](CsvText& text) { text.rows.push_back(text.rows.at(6)); },
                "t.csv:17: 'TS' stands in line 8 already. Remove one of the rows; a file holds "
                "landmarks "
                "of one side"},
        CsvFlaw{"AC and PAC",
                [](CsvText& text) {
                  text.rows.push_back({"AC", "clavicle", "0", "0", "0.15"});
                },
                "t.csv:17: 'AC' stands in line 7 already, AC and PAC being the same. Remove one of "
                "the rows; a file holds landmarks of one side"},
        CsvFlaw{"missing landmark", [](CsvText& text) { text.RemoveRow(8); },
                "t.csv:15: no row for AA in the frame 'scapula'. Add it; only ACJ, GC and GH may "
                "be left out"},
        CsvFlaw{"two missing landmarks",
                [](CsvText& text) {
                  text.RemoveRow(5);
                  text.RemoveRow(0);
                },
                "t.csv:14: no row for IJ in the frame 'thorax', PAC (or AC) in the frame "
                "'clavicle'. Add it; only ACJ, GC and GH may be left out"},
        CsvFlaw{"the origin but not the landmark",
                [](CsvText& text) { text.Cell(4, "segment") = "clavicle"; },
                "t.csv:16: no row for SC in the frame 'thorax'. Add it; only ACJ, GC and GH may "
                "be left out"},
        CsvFlaw{"another segment's frame",
                [](CsvText& text) { text.Cell(6, "segment") = "humerus"; },
                "t.csv:8: TS is given in the frame 'humerus', expected 'scapula', or 'lab' in "
                "every row"},
        CsvFlaw{"another segment's frame of an origin",
                [](CsvText& text) { text.Cell(12, "segment") = "thorax"; },
                "t.csv:14: GH is given in the frame 'thorax', expected 'scapula' (or 'humerus', "
                "whose origin it is), or 'lab' in every row"},
        CsvFlaw{"a row in the laboratory's frame",
                [](CsvText& text) { text.Cell(7, "segment") = "lab"; },
                "t.csv:9: AI is given in the frame 'lab', the rows above each in that of its "
                "segment. Give all landmarks in 'lab', or each in the frame of its segment"},
        CsvFlaw{"no number", [](CsvText& text) { text.Cell(5, "z_m") = "O.1575"; },
                "t.csv:7: z_m is 'O.1575', expected a finite number such as 22.5"},
        CsvFlaw{"millimeters", [](CsvText& text) { ScaleAll(text, 1000); },
                "t.csv:3: IJ to PX is 137 m, expected 0.0456 m to 0.41 m. Give meters, not "
                "millimeters"},
        CsvFlaw{"centimeters", [](CsvText& text) { ScaleAll(text, 100); },
                "t.csv:3: IJ to PX is 13.7 m, expected 0.0456 m to 0.41 m. Give meters, not "
                "centimeters"},
        CsvFlaw{"one row in millimeters", [](CsvText& text) { Scale(text, 7, 1000); },
                "t.csv:9: TS to AI is 186 m, expected 0.0392 m to 0.353 m. Give meters, not "
                "millimeters"},
        CsvFlaw{"length of zero", [](CsvText& text) { text.Cell(5, "z_m") = "0"; },
                "t.csv:7: SC and PAC are the same point"},
        CsvFlaw{"the same point twice",
                [](CsvText& text) {
                  text.rows.at(14) = {"EL", "humerus", "0", "-0.2898", "-0.034"};
                },
                "t.csv:16: EM and EL are the same point"},
        CsvFlaw{"clavicle of an elephant", [](CsvText& text) { text.Cell(5, "z_m") = "0.9"; },
                "t.csv:7: SC to PAC is 0.9 m, expected 0.0525 m to 0.473 m. Correct the positions"},
        CsvFlaw{"clavicle of a mouse", [](CsvText& text) { text.Cell(5, "z_m") = "0.01"; },
                "t.csv:7: SC to PAC is 0.01 m, expected 0.0525 m to 0.473 m. Correct the "
                "positions"},
        CsvFlaw{"scapula on a line",
                [](CsvText& text) {
                  text.rows.at(7) = {"AI", "scapula", "0", "-0.005", "-0.22"};
                },
                "t.csv:9: PAC, TS and AI lie nearly on a line, 3 mm off it, and tell no frame. "
                "Measure them again"},
        CsvFlaw{"TS and AI", [](CsvText& text) { SwapNames(text, 6, 7); },
                "t.csv:8: PAC to AI is 129 mm and to TS 186 mm, where bones of this size have AI "
                "at 186 mm: TS and AI have each other's place. Swap their names, or measure "
                "AI again if they are right"},
        CsvFlaw{"PX and T8", [](CsvText& text) { SwapNames(text, 1, 3); },
                "t.csv:3: IJ to PX is 232 mm and to T8 137 mm, where bones of this size have PX at "
                "137 mm: PX and T8 have each other's place. Swap their names, or measure "
                "PX again if they are right"},
        CsvFlaw{"IJ and C7", [](CsvText& text) { SwapNames(text, 0, 2); },
                "t.csv:2: PX to IJ is 244 mm and to C7 137 mm, where bones of this size have IJ at "
                "137 mm: IJ and C7 have each other's place. Swap their names, or measure "
                "IJ again if they are right"},
        CsvFlaw{"EM and EL", [](CsvText& text) { SwapNames(text, 13, 14); },
                "t.csv:15: EL lies to the left of EM: they have each other's place. Swap their "
                "names, or if they are right, negate x_m and z_m in the humerus's rows"},
        CsvFlaw{"left SC", [](CsvText& text) { NegateZ(text, 4); },
                "t.csv:6: SC lies to the left of IJ and C7, but the scapula is a right one. Give "
                "the right SC, swap the names of PX and C7 if they have each other's place, or "
                "negate z_m in the thorax's rows if they are mirrored"},
        CsvFlaw{"mirrored scapula",
                [](CsvText& text) {
                  for (std::size_t row = 6; row <= 12; ++row) NegateZ(text, row);
                },
                "t.csv:11: PC lies behind AA, as in a left scapula. Swap their names if they have "
                "each other's place, or negate z_m in the scapula's rows if it is mirrored"},
        CsvFlaw{"left shoulder",
                [](CsvText& text) {
                  for (std::size_t row = 0; row < text.rows.size(); ++row) NegateZ(text, row);
                },
                "t.csv:6: these are landmarks of a left shoulder. Make it a right one: negate z_m "
                "in every row"}));

class FlawedExample : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedExample, IsRefusedWithPlaceAndFix) {
  CsvText text(ExampleText());
  GetParam().change(text);
  EXPECT_EQ(MessageOn(text.Text()), GetParam().message);
}

// IJ PX C7 T8 SC AC AA TS AI PC GH EM EL stand in lines 2 to 14.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedExample,
    testing::Values(
        CsvFlaw{"missing landmark", [](CsvText& text) { text.RemoveRow(5); },
                "t.csv:13: no row for PAC (or AC). Add it; only ACJ, GC and GH may be left out"},
        CsvFlaw{"row twice", [](CsvText& text) { text.rows.push_back(text.rows.at(4)); },
                "t.csv:15: 'SC' stands in line 6 already. Remove one of the rows; a file holds "
                "landmarks "
                "of one side"},
        CsvFlaw{"a row in a segment's frame",
                [](CsvText& text) { text.Cell(7, "segment") = "scapula"; },
                "t.csv:9: TS is given in the frame 'scapula', the rows above in the laboratory's. "
                "Give all landmarks in 'lab', or each in the frame of its segment"},
        CsvFlaw{"millimeters", [](CsvText& text) { ScaleAll(text, 1000); },
                "t.csv:3: IJ to PX is 137 m, expected 0.0456 m to 0.41 m. Give meters, not "
                "millimeters"},
        CsvFlaw{"EM and EL", [](CsvText& text) { SwapNames(text, 11, 12); },
                "t.csv:13: the humerus is turned about its long axis as no shoulder turns it: EM "
                "and EL have each other's place. Swap their names"},
        CsvFlaw{"AA and PC", [](CsvText& text) { SwapNames(text, 6, 9); },
                "t.csv:8: TS to PC is 120 mm and to AA 139 mm, where bones of this size have PC at "
                "139 mm: AA and PC have each other's place. Swap their names, or measure "
                "PC again if they are right"},
        CsvFlaw{"left shoulder",
                [](CsvText& text) {
                  for (std::size_t row = 0; row < text.rows.size(); ++row) NegateZ(text, row);
                },
                "t.csv:6: these are landmarks of a left shoulder. Make it a right one: negate z_m "
                "in every row"}));

// --- Exchanged names ------------------------------------------------------------------------

// All landmarks of `anatomy` but those that the ISB does not know, in a laboratory.
CsvText IsbInALab(const Anatomy& anatomy, const ShoulderPose& pose, const Placement& lab) {
  CsvText text(DigitisedInALab(anatomy, pose, lab));
  std::erase_if(text.rows, [](const auto& row) { return row.at(0) == "ACJ" || row.at(0) == "GC"; });
  return text;
}

void MirrorAll(CsvText& text) {
  for (std::size_t row = 0; row < text.rows.size(); ++row) NegateZ(text, row);
}

// Of each exchange of two names whose message does not name both, the names and the message.
std::string NotNamed(const CsvText& text) {
  std::string wrong;
  for (std::size_t a = 0; a < text.rows.size(); ++a) {
    for (std::size_t b = a + 1; b < text.rows.size(); ++b) {
      CsvText exchanged = text;
      SwapNames(exchanged, a, b);
      const std::string message = MessageOn(exchanged.Text());
      const std::string& first = text.rows.at(a).at(0);
      const std::string& second = text.rows.at(b).at(0);
      const auto says = [&](const std::string& names) {
        return message.find(names + " have each other's place") != std::string::npos;
      };
      // The humerus's shape does not tell its epicondyles apart; its posture does.
      const bool is_epicondyles = first == "EM" && second == "EL";
      if (is_epicondyles ? message == "(nothing was thrown)"
                         : !says(first + " and " + second) && !says(second + " and " + first)) {
        wrong.append(first).append(" ").append(second).append(": ").append(message).append("\n");
      }
    }
  }
  return wrong;
}

TEST(ExchangedNames, OfTheExampleAreAllToldOnBothSides) {
  CsvText text(ExampleText());
  EXPECT_EQ(text.rows.size(), 13);
  EXPECT_EQ(NotNamed(text), "");
  MirrorAll(text);
  EXPECT_EQ(NotNamed(text), "");
}

// Bones of other proportions, in any posture and laboratory.
TEST(ExchangedNames, AreToldInPeopleOfAnySizeAndPosture) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (const double scale : {0.8, 0.9, 1.0, 1.1, 1.2}) {
    const ShoulderPose pose = rhythm.SolvePose(
        {RadiansFromDegrees(10 + 80 * share(random)), RadiansFromDegrees(80 * share(random))});
    const Anatomy person =
        ScaledAnatomy(Adult(), {.clavicle_length_m = scale * (0.13 + 0.05 * share(random)),
                                .scapula_length_m = scale * (0.115 + 0.03 * share(random)),
                                .humerus_length_m = scale * (0.26 + 0.06 * share(random)),
                                .stature_m = scale * kAdultStature_m});
    const Placement lab = {Exp(Vector3(share(random), -2 * share(random), 3 * share(random))),
                           {share(random), 3, -share(random)}};
    CsvText text = IsbInALab(person, pose, lab);
    ASSERT_EQ(MessageOn(text.Text()), "(nothing was thrown)");
    EXPECT_EQ(NotNamed(text), "") << scale;
    MirrorAll(text);
    EXPECT_EQ(NotNamed(text), "") << scale;
  }
}

TEST(ExchangedNames, AreToldWithoutGh) {
  CsvText text(ExampleText());
  text.RemoveRow(10);
  EXPECT_EQ(NotNamed(text), "");
}

// In the segments' own frames most exchanges take a landmark to a frame that is not its own.
TEST(ExchangedNames, InSegmentsFramesAreAllRefused) {
  const CsvText text(built_in_files::kLandmarks);
  for (std::size_t a = 0; a < text.rows.size(); ++a) {
    for (std::size_t b = a + 1; b < text.rows.size(); ++b) {
      CsvText exchanged = text;
      SwapNames(exchanged, a, b);
      const std::string names = text.rows.at(a).at(0) + " " + text.rows.at(b).at(0);
      EXPECT_NE(MessageOn(exchanged.Text()), "(nothing was thrown)") << names;
    }
  }
}

void AddNoise(CsvText& text, double deviation_m, std::mt19937& random) {
  std::normal_distribution<double> noise_m(0, deviation_m);
  for (std::size_t row = 0; row < text.rows.size(); ++row) {
    for (const char* const column : {"x_m", "y_m", "z_m"}) {
      std::string& cell = text.Cell(row, column);
      cell = NumberText(std::stod(cell) + noise_m(random));
    }
  }
}

TEST(ExchangedNames, AreNotSeenInThreeMillimetersOfNoise) {
  constexpr double kNoise_m = 0.003;
  constexpr unsigned kSeeds = 1000;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    std::mt19937 random(seed);
    CsvText text(ExampleText());
    AddNoise(text, kNoise_m, random);
    EXPECT_EQ(MessageOn(text.Text()), "(nothing was thrown)") << "seed " << seed;
  }
}

TEST(ExchangedNames, AreToldThroughThreeMillimetersOfNoise) {
  constexpr double kNoise_m = 0.003;
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 random(seed);
    CsvText text(ExampleText());
    AddNoise(text, kNoise_m, random);
    EXPECT_EQ(NotNamed(text), "") << "seed " << seed;
  }
}

// --- Two sides ------------------------------------------------------------------------------

// Takes a row to the other side of the body.
void MirrorInBody(CsvText& text, std::size_t row) {
  std::istringstream in(ExampleText());
  const DigitizedPerson person = ReadDigitizedPerson(in, "t.csv", Adult());
  const Vector3 normal = person.q_AT * Vector3(0, 0, 1);
  Vector3 p_m{std::stod(text.Cell(row, "x_m")), std::stod(text.Cell(row, "y_m")),
              std::stod(text.Cell(row, "z_m"))};
  p_m -= 2 * glm::dot(p_m - person.p_AT_m, normal) * normal;
  text.Cell(row, "x_m") = NumberText(p_m.x);
  text.Cell(row, "y_m") = NumberText(p_m.y);
  text.Cell(row, "z_m") = NumberText(p_m.z);
}

struct TwoSides {
  const char* name;
  std::vector<std::size_t> rows;
  const char* told;  // the landmark of the other side
};

void PrintTo(const TwoSides& sides, std::ostream* out) { *out << sides.name; }

class LandmarksOfTwoSides : public testing::TestWithParam<TwoSides> {};

TEST_P(LandmarksOfTwoSides, AreToldWithTheLandmark) {
  CsvText text(ExampleText());
  for (const std::size_t row : GetParam().rows) MirrorInBody(text, row);
  const std::string message = MessageOn(text.Text());
  EXPECT_NE(message.find(std::string(": ") + GetParam().told + " lies "), std::string::npos)
      << message;
  EXPECT_NE(message.find("these are landmarks of two sides. Give all of one side"),
            std::string::npos)
      << message;
}

INSTANTIATE_TEST_SUITE_P(
    OneEach, LandmarksOfTwoSides,
    testing::Values(TwoSides{"SC", {4}, "SC"}, TwoSides{"AC", {5}, "AC"}, TwoSides{"AI", {8}, "AI"},
                    TwoSides{"GH", {10}, "GH"}, TwoSides{"arm", {11, 12}, "EM"},
                    TwoSides{"EL", {12}, "EL"},
                    TwoSides{"scapula and arm", {6, 7, 8, 9, 10, 11, 12}, "SC"}));

TEST(LandmarksOfTwoSides, AreNotSeenInAnArmAcrossTheBody) {
  const ShoulderPose pose =
      BuiltInRhythm().SolvePose({RadiansFromDegrees(70), RadiansFromDegrees(130)});
  EXPECT_EQ(MessageOn(IsbInALab(Adult(), pose, {{1, 0, 0, 0}, {0, 0, 0}}).Text()),
            "(nothing was thrown)");
}

// --- GH -------------------------------------------------------------------------------------

TEST(ReadPersonAnatomy, EstimatesGhThatIsNotThere) {
  CsvText text(ExampleText());
  text.RemoveRow(10);
  const Anatomy anatomy = Read(text.Text());
  const auto at = [&](Landmark landmark) { return anatomy.landmark_m(landmark); };
  EXPECT_LT(glm::distance(at(Landmark::kGH),
                          EstimatedGh_m(at(Landmark::kPC), {0, 0, 0}, at(Landmark::kAA),
                                        at(Landmark::kTS), at(Landmark::kAI))),
            kRounding_m);
  EXPECT_EQ(anatomy.gh_origin,
            "estimated from PC, AC, AA, TS and AI (Meskers et al. 1998), with a root mean square "
            "error of 2.3 mm to the side, 2.7 mm up and 3 mm forward on bare bones, and more on "
            "landmarks felt through skin; it misses GH of the built-in bones by 15 mm. Points of "
            "the humeral head, HH1 HH2 ..., would tell GH");
}

TEST(ReadPersonAnatomy, EstimatesGhInTheScapulasFrameToo) {
  CsvText text(built_in_files::kLandmarks);
  text.RemoveRow(12);
  const Anatomy anatomy = Read(text.Text());
  EXPECT_NE(anatomy.gh_origin.find("Meskers"), std::string::npos);
  EXPECT_EQ(anatomy.landmark_m(Landmark::kEM), Adult().landmark_m(Landmark::kEM));
}

TEST(ReadPersonAnatomy, SaysNothingOfGhThatIsThere) {
  EXPECT_EQ(Read(ExampleText()).gh_origin, "");
}

// Rows of points on a sphere about the example's GH in place of it.
CsvText ExampleWithHead(const std::vector<Vector3>& directions, double radius_m) {
  CsvText text(ExampleText());
  const Vector3 gh_m{std::stod(text.Cell(10, "x_m")), std::stod(text.Cell(10, "y_m")),
                     std::stod(text.Cell(10, "z_m"))};
  text.RemoveRow(10);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vector3 p_m = gh_m + radius_m * glm::normalize(directions.at(i));
    text.rows.push_back({"HH" + std::to_string(i + 1), "lab", NumberText(p_m.x), NumberText(p_m.y),
                         NumberText(p_m.z)});
  }
  return text;
}

const std::vector<Vector3> kDirections = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 1, 0.5}};

TEST(ReadPersonAnatomy, TakesGhFromPointsOfTheHumeralHead) {
  const Anatomy anatomy = Read(ExampleWithHead(kDirections, 0.024).Text());
  EXPECT_LT(LargestDifference_m(anatomy, Read(ExampleText())), 1e-9);
  EXPECT_NE(
      anatomy.gh_origin.find("centre of the sphere through 5 points of the humeral head, with "
                             "a radius of 24 mm; the points lie 0 mm off it (root mean "
                             "square); an error of 1 mm in the points moves the centre by "),
      std::string::npos)
      << anatomy.gh_origin;
}

class FlawedHead : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedHead, IsRefusedWithPlaceAndFix) {
  CsvText text = ExampleWithHead(kDirections, 0.024);
  GetParam().change(text);
  EXPECT_EQ(MessageOn(text.Text()), GetParam().message);
}

// HH1 to HH5 stand in lines 14 to 18.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedHead,
    testing::Values(
        CsvFlaw{"four in a plane",
                [](CsvText& text) {
                  text = ExampleWithHead({{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}}, 0.024);
                },
                "t.csv:17: HH1 HH2 HH3 HH4: lie nearly in a plane, 0 mm off it, and tell no "
                "sphere. Add points off that plane, over as much of the humeral head as can be "
                "reached"},
        CsvFlaw{"three",
                [](CsvText& text) {
                  text.RemoveRow(16);
                  text.RemoveRow(15);
                },
                "t.csv:16: HH1 HH2 HH3: 3 of them tell no sphere. Give at least four"},
        CsvFlaw{"a hip's size", [](CsvText& text) { text = ExampleWithHead(kDirections, 0.06); },
                "t.csv:18: HH1 HH2 HH3 HH4 HH5: the sphere through them has a radius of 60 mm, "
                "expected 8 mm to 48 mm. Give points of the humeral head, in meters"},
        CsvFlaw{"GH besides",
                [](CsvText& text) {
                  text.rows.insert(text.rows.begin(), CsvText(ExampleText()).rows.at(10));
                },
                "t.csv:19: HH1 HH2 HH3 HH4 HH5: the sphere through these gives GH, which stands in "
                "line 2 already. Remove that row or these"},
        CsvFlaw{"a number twice", [](CsvText& text) { text.rows.at(16).at(0) = "HH1"; },
                "t.csv:18: 'HH1' is given twice. Number the points of the humeral head"},
        CsvFlaw{"in a segment's frame",
                [](CsvText& text) {
                  const auto row = text.rows.at(12);
                  text = CsvText(built_in_files::kLandmarks);
                  text.rows.at(12) = {"HH1", "humerus", row.at(2), row.at(3), row.at(4)};
                },
                "t.csv:14: HH1 is given in the frame 'humerus': points of the humeral head serve "
                "where all landmarks stand in 'lab'. Give GH in the scapula's frame instead"}));

// --- A left shoulder ------------------------------------------------------------------------

TEST(ReadDigitizedPerson, TellsToMirrorTheMeshOfALeftPersonToo) {
  CsvText text(ExampleText());
  MirrorAll(text);
  std::istringstream in(text.Text());
  EXPECT_EQ(MessageOf<InputError>(
                [&] { static_cast<void>(ReadDigitizedPerson(in, "t.csv", Adult(), "her.obj")); }),
            "t.csv:6: these are landmarks of a left shoulder. Make it a right one: negate z_m in "
            "every row, and mirror the mesh with them: negate the third coordinate of every vertex "
            "of her.obj and turn the order of the corners of every face");
}

// What the message of a left shoulder tells to do.
TEST(ReadPersonAnatomy, TakesALeftShoulderWhoseZIsNegated) {
  const Quaternion turn = Exp(Vector3(0.3, -0.7, 1.1));
  CsvText left(ExampleText());
  CsvText right = left;
  for (std::size_t row = 0; row < left.rows.size(); ++row) {
    // The mirror image in a plane of any direction.
    const Vector3 p_m{std::stod(left.Cell(row, "x_m")), std::stod(left.Cell(row, "y_m")),
                      std::stod(left.Cell(row, "z_m"))};
    const Vector3 normal = turn * Vector3(1, 0, 0);
    const Vector3 mirrored_m = p_m - 2 * glm::dot(p_m, normal) * normal;
    left.Cell(row, "x_m") = right.Cell(row, "x_m") = NumberText(mirrored_m.x);
    left.Cell(row, "y_m") = right.Cell(row, "y_m") = NumberText(mirrored_m.y);
    left.Cell(row, "z_m") = NumberText(mirrored_m.z);
    right.Cell(row, "z_m") = NumberText(-mirrored_m.z);
  }
  EXPECT_NE(MessageOn(left.Text()), "(nothing was thrown)");
  EXPECT_LT(LargestDifference_m(Read(right.Text()), Read(ExampleText())), kRounding_m);
}

// All that a laboratory's landmarks say: bones, posture and where the thorax was. The clavicle's
// turn about its long axis is not among it.
RC_GTEST_PROP(ReadDigitizedPerson, FindsPostureAndPlace, ()) {
  static const ShoulderRhythm kRhythm = BuiltInRhythm();
  const ShoulderPose pose = kRhythm.SolvePose(
      {RadiansFromDegrees(*NumberWithin(0, 140)), RadiansFromDegrees(*NumberWithin(-30, 120))});
  const Placement lab = *AnyPlacement();
  std::istringstream in(DigitisedInALab(Adult(), pose, lab));
  const DigitizedPerson person = ReadDigitizedPerson(in, "t.csv", Adult());
  // The shortest landmarks of a frame are some centimetres apart.
  constexpr double kRounding_rad = 1e-12;
  RC_ASSERT(LargestDifference_m(person.anatomy, Adult()) < kRounding_m);
  RC_ASSERT(AngleBetween(person.q_AT, lab.q_AB) < kRounding_rad);
  RC_ASSERT(glm::distance(person.p_AT_m, lab.p_AB_m) < kRounding_m);
  RC_ASSERT(AngleBetween(person.pose.q_TS(), pose.q_TS()) < kRounding_rad);
  RC_ASSERT(AngleBetween(person.pose.q_TH(), pose.q_TH()) < kRounding_rad);
  const Vector3 z{0, 0, 1};
  RC_ASSERT(glm::distance(person.pose.q_TC * z, pose.q_TC * z) < kRounding_rad);
  RC_ASSERT(std::abs(AnglesFromPose(person.pose)[2]) < kRounding_rad);
}

TEST(ReadDigitizedPerson, RefusesLandmarksThatDoNotSayHowThePersonStood) {
  std::istringstream in{std::string(built_in_files::kLandmarks)};
  const std::string message =
      MessageOf<InputError>([&] { static_cast<void>(ReadDigitizedPerson(in, "t.csv", Adult())); });
  EXPECT_NE(message.find("do not say how the person stood. Give all in one frame, with 'lab'"),
            std::string::npos)
      << message;
}

}  // namespace
}  // namespace girdle::person_landmarks_test
