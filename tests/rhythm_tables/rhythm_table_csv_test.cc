// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/rhythm_table_csv.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"
#include "rhythm_tables/built_in_files.h"
#include "rhythm_tables/built_in_tables.h"
#include "rhythm_tables/rhythm_choice.h"
#include "text/csv_text.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle::rhythm_table_csv_test {
namespace {

// Rows of the built-in table: 3 planes of 22 elevations.
constexpr std::size_t kElevations = 22;
constexpr std::size_t kRows = 3 * kElevations;

CsvText BuiltInText() { return CsvText(built_in_files::kLudewig2009); }

RhythmTable Read(const std::string& text) {
  std::istringstream in(text);
  return ReadRhythmTable(in, "t.csv");
}

void ExpectSamePositions(const RhythmTable& actual, const RhythmTable& expected) {
  ASSERT_EQ(actual.planes_rad(), expected.planes_rad());
  ASSERT_EQ(actual.elevations_rad(), expected.elevations_rad());
  for (std::size_t plane = 0; plane < actual.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < actual.elevations_rad().size(); ++elevation) {
      const RhythmPosition& a = actual.position(plane, elevation);
      const RhythmPosition& b = expected.position(plane, elevation);
      EXPECT_EQ(a.angles_rad, b.angles_rad) << "plane " << plane << ", elevation " << elevation;
      EXPECT_EQ(a.measured, b.measured) << "plane " << plane << ", elevation " << elevation;
      EXPECT_EQ(a.scapulothoracic_rad, b.scapulothoracic_rad)
          << "plane " << plane << ", elevation " << elevation;
    }
  }
}

bool SameBits(const RhythmTable& a, const RhythmTable& b) {
  if (a.planes_rad() != b.planes_rad() || a.elevations_rad() != b.elevations_rad()) return false;
  for (std::size_t plane = 0; plane < a.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < a.elevations_rad().size(); ++elevation) {
      const RhythmPosition& p = a.position(plane, elevation);
      const RhythmPosition& q = b.position(plane, elevation);
      if (p.angles_rad != q.angles_rad || p.measured != q.measured ||
          p.scapulothoracic_rad != q.scapulothoracic_rad) {
        return false;
      }
    }
  }
  return true;
}

TEST(ReadRhythmTable, ReadsAnglesInDegrees) {
  const RhythmTable table = Read(BuiltInText().Text());
  const std::vector<MeasuredRow> rows = MeasuredRows();
  ASSERT_EQ(rows.size(), kRows);
  for (std::size_t i = 0; i < kRows; ++i) {
    EXPECT_EQ(table.position(i / kElevations, i % kElevations).angles_rad,
              Radians(rows[i].angles_deg))
        << "row " << i;
  }
}

TEST(ReadRhythmTable, ReadsThePublishedScapula) {
  const RhythmTable table = Read(BuiltInText().Text());
  const std::vector<MeasuredRow> rows = MeasuredRows();
  for (std::size_t i = 0; i < kRows; ++i) {
    const auto& [internal_deg, upward_deg, tilt_deg] = rows[i].scapulothoracic_deg;
    EXPECT_EQ(table.position(i / kElevations, i % kElevations).scapulothoracic_rad,
              Vector3(RadiansFromDegrees(internal_deg), RadiansFromDegrees(upward_deg),
                      RadiansFromDegrees(tilt_deg)))
        << "row " << i;
  }
}

TEST(ReadRhythmTable, ReadsWhatWasMeasuredAndWhatWasDerived) {
  constexpr double kFirstMeasured_deg = 30;
  const RhythmTable table = Read(BuiltInText().Text());
  const std::vector<MeasuredRow> rows = MeasuredRows();
  for (std::size_t i = 0; i < kRows; ++i) {
    EXPECT_EQ(table.position(i / kElevations, i % kElevations).measured,
              rows[i].elevation_deg >= kFirstMeasured_deg)
        << "row " << i;
  }
}

TEST(ReadRhythmTable, TakesAllForMeasuredIfTheFileDoesNotSay) {
  CsvText text = BuiltInText();
  text.RemoveColumn("origin");
  const RhythmTable table = Read(text.Text());
  for (std::size_t i = 0; i < kRows; ++i) {
    EXPECT_TRUE(table.position(i / kElevations, i % kElevations).measured) << "row " << i;
  }
}

TEST(ReadRhythmTable, DoesWithoutThePublishedScapula) {
  CsvText text = BuiltInText();
  for (const char* const column :
       {"st_internal_rotation_deg", "st_upward_rotation_deg", "st_tilt_deg"}) {
    text.RemoveColumn(column);
  }
  const RhythmTable table = Read(text.Text());
  for (std::size_t i = 0; i < kRows; ++i) {
    EXPECT_EQ(table.position(i / kElevations, i % kElevations).scapulothoracic_rad, std::nullopt)
        << "row " << i;
  }
}

TEST(ReadRhythmTable, TakesColumnsInAnyOrder) {
  CsvText text = BuiltInText();
  std::reverse(text.columns.begin(), text.columns.end());
  for (std::vector<std::string>& row : text.rows) std::reverse(row.begin(), row.end());
  ExpectSamePositions(Read(text.Text()), BuiltInRhythmTable(BuiltInTable::kMeasured));
}

TEST(ReadRhythmTable, TakesAnglesOfHalfATurn) {
  CsvText text = BuiltInText();
  text.Cell(7, "gh_axial_deg") = "-180";
  EXPECT_EQ(Read(text.Text()).position(0, 7).angles_rad[kGhAxialIndex], -kPi);
}

class FlawedRhythm : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedRhythm, IsRefusedWithPlaceValueAndExpectation) {
  CsvText text = BuiltInText();
  GetParam().change(text);
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(Read(text.Text())); }),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Columns, FlawedRhythm,
    testing::Values(
        CsvFlaw{"no plane", [](CsvText& text) { text.RemoveColumn("plane_deg"); },
                "t.csv:1: column 'plane_deg' is missing. The header has: elevation_deg, origin, "
                "sc_protraction_deg, sc_elevation_deg, sc_rotation_deg, ac_internal_rotation_deg, "
                "ac_upward_rotation_deg, ac_tilt_deg, gh_elevation_deg, gh_flexion_deg, "
                "gh_axial_deg, st_internal_rotation_deg, st_upward_rotation_deg, st_tilt_deg"},
        CsvFlaw{"no elevation", [](CsvText& text) { text.RemoveColumn("elevation_deg"); },
                "t.csv:1: column 'elevation_deg' is missing. The header has: plane_deg, origin, "
                "sc_protraction_deg, sc_elevation_deg, sc_rotation_deg, ac_internal_rotation_deg, "
                "ac_upward_rotation_deg, ac_tilt_deg, gh_elevation_deg, gh_flexion_deg, "
                "gh_axial_deg, st_internal_rotation_deg, st_upward_rotation_deg, st_tilt_deg"},
        CsvFlaw{"no tilt", [](CsvText& text) { text.RemoveColumn("ac_tilt_deg"); },
                "t.csv:1: column 'ac_tilt_deg' is missing. The header has: plane_deg, "
                "elevation_deg, origin, sc_protraction_deg, sc_elevation_deg, sc_rotation_deg, "
                "ac_internal_rotation_deg, ac_upward_rotation_deg, gh_elevation_deg, "
                "gh_flexion_deg, gh_axial_deg, st_internal_rotation_deg, st_upward_rotation_deg, "
                "st_tilt_deg"},
        CsvFlaw{"two of three scapula angles",
                [](CsvText& text) { text.RemoveColumn("st_upward_rotation_deg"); },
                "t.csv:1: column 'st_upward_rotation_deg' is missing. The header has: plane_deg, "
                "elevation_deg, origin, sc_protraction_deg, sc_elevation_deg, sc_rotation_deg, "
                "ac_internal_rotation_deg, ac_upward_rotation_deg, ac_tilt_deg, gh_elevation_deg, "
                "gh_flexion_deg, gh_axial_deg, st_internal_rotation_deg, st_tilt_deg"},
        CsvFlaw{"a column too many", [](CsvText& text) { text.AddColumn("remark", ""); },
                "t.csv:1: column 'remark' is not known. Remove it or correct its name"}));

INSTANTIATE_TEST_SUITE_P(
    Cells, FlawedRhythm,
    testing::Values(
        CsvFlaw{"a letter for a digit",
                [](CsvText& text) { text.Cell(5, "gh_axial_deg") = "-63.O"; },
                "t.csv:7: gh_axial_deg is '-63.O', expected a finite number such as 22.5"},
        CsvFlaw{"an empty angle", [](CsvText& text) { text.Cell(5, "sc_rotation_deg") = ""; },
                "t.csv:7: sc_rotation_deg is '', expected a finite number such as 22.5"},
        CsvFlaw{"an angle above half a turn",
                [](CsvText& text) { text.Cell(65, "sc_protraction_deg") = "180.5"; },
                "t.csv:67: sc_protraction_deg is 180.5, expected -180 to 180"},
        CsvFlaw{"a scapula angle below half a turn",
                [](CsvText& text) { text.Cell(0, "st_tilt_deg") = "-181"; },
                "t.csv:2: st_tilt_deg is -181, expected -180 to 180"},
        CsvFlaw{"a plane beyond half a turn",
                [](CsvText& text) { text.Cell(0, "plane_deg") = "-190"; },
                "t.csv:2: plane_deg is -190, expected -180 to 180"},
        CsvFlaw{"a negative elevation", [](CsvText& text) { text.Cell(0, "elevation_deg") = "-5"; },
                "t.csv:2: elevation_deg is -5, expected 0 to 180"},
        CsvFlaw{"an elevation above half a turn",
                [](CsvText& text) { text.Cell(21, "elevation_deg") = "185"; },
                "t.csv:23: elevation_deg is 185, expected 0 to 180"},
        CsvFlaw{"another origin", [](CsvText& text) { text.Cell(3, "origin") = "guessed"; },
                "t.csv:5: origin is 'guessed', expected measured or sc_ac_derived"},
        CsvFlaw{"a cell too few", [](CsvText& text) { text.rows[9].pop_back(); },
                "t.csv:11: 14 fields, expected 15 as in the header "
                "(plane_deg,elevation_deg,origin,sc_protraction_deg,sc_elevation_deg,"
                "sc_rotation_deg,ac_internal_rotation_deg,ac_upward_rotation_deg,ac_tilt_deg,"
                "gh_elevation_deg,gh_flexion_deg,gh_axial_deg,st_internal_rotation_deg,"
                "st_upward_rotation_deg,st_tilt_deg)"}));

INSTANTIATE_TEST_SUITE_P(
    Grid, FlawedRhythm,
    testing::Values(
        CsvFlaw{"a row twice",
                [](CsvText& text) { text.rows.insert(text.rows.begin() + 3, text.rows[2]); },
                "t.csv:5: plane 0 deg, elevation 25 deg is given twice. Remove one of the rows"},
        CsvFlaw{"elevations in disorder",
                [](CsvText& text) { std::swap(text.rows[1], text.rows[2]); },
                "t.csv:4: elevation 20 deg does not increase (previous 25)"},
        CsvFlaw{"a hole in the first plane", [](CsvText& text) { text.RemoveRow(9); },
                "t.csv:32: plane 40 deg has elevation 60 deg where 65 deg is expected: every plane "
                "needs the elevations of plane 0 deg"},
        CsvFlaw{"a first plane that ends early",
                [](CsvText& text) { text.RemoveRow(kElevations - 1); },
                "t.csv:44: plane 40 deg has elevation 120 deg where no further row is expected: "
                "every plane needs the elevations of plane 0 deg"},
        CsvFlaw{"a hole in another plane", [](CsvText& text) { text.RemoveRow(kElevations + 9); },
                "t.csv:33: plane 40 deg has elevation 65 deg where 60 deg is expected: every plane "
                "needs the elevations of plane 0 deg"},
        CsvFlaw{"a plane that ends early",
                [](CsvText& text) { text.RemoveRow(2 * kElevations - 1); },
                "t.csv:45: plane 40 deg ends without elevation 120 deg: the grid has a hole"},
        CsvFlaw{"a table that ends early", [](CsvText& text) { text.RemoveRow(kRows - 1); },
                "t.csv:66: plane 90 deg ends without elevation 120 deg: the grid has a hole"},
        CsvFlaw{"planes in disorder",
                [](CsvText& text) {
                  std::rotate(text.rows.begin() + kElevations, text.rows.begin() + 2 * kElevations,
                              text.rows.end());
                },
                "t.csv:46: plane 40 deg does not increase (previous 90)"},
        CsvFlaw{"no rows", [](CsvText& text) { text.rows.clear(); },
                "t.csv:1: the table has no rows"},
        CsvFlaw{"one plane", [](CsvText& text) { text.KeepRows("plane_deg", "40"); },
                "t.csv: planes: 1 given, at least 2 are needed to interpolate"},
        CsvFlaw{"one elevation", [](CsvText& text) { text.KeepRows("elevation_deg", "60"); },
                "t.csv: elevations: 1 given, at least 2 are needed to interpolate"}));

std::string DataFile(const std::string& name) {
  return std::string(GIRDLE_SOURCE_DIR) + "/data/" + name;
}

ShoulderRhythm ReadUnbounded(const std::string& path, const RhythmOptions& options = {}) {
  return MakeRhythm(
      Resolve({options.interpolation, options.closure, options.range, TableFromWordOrFile(path)}),
      ShoulderRhythm::Unbounded());
}

TEST(RhythmOfAFile, ReadsTheShippedFile) {
  ExpectSamePositions(ReadUnbounded(DataFile("ludewig2009.csv")).table(),
                      BuiltInRhythmTable(BuiltInTable::kMeasured));
}

TEST(RhythmOfAFile, TakesItsOptions) {
  EXPECT_EQ(ReadUnbounded(DataFile("ludewig2009.csv"), {Interpolation::kSlerp, Closure::kTable})
                .options()
                .interpolation,
            Interpolation::kSlerp);
}

TEST(RhythmOfAFile, NamesTheFileThatHasNoRuleForTheRangeWanted) {
  const std::string path = DataFile("ludewig2009.csv");
  EXPECT_EQ(MessageOf<InputError>([&] {
              static_cast<void>(
                  ReadUnbounded(path, {Interpolation::kSquad, Closure::kExact, Range::kWhole}));
            }),
            path +
                ": the range whole needs the interpolation smooth and the closure exact: with "
                "others nothing is known outside the table. Choose the range clamp");
}

TEST(RhythmOfAFile, NamesAFileThatIsNotThereAndWhy) {
  EXPECT_EQ(MessageOf<InputError>([] { static_cast<void>(ReadUnbounded("no/such/table.csv")); }),
            "no/such/table.csv: cannot be opened: No such file or directory. Check the name and "
            "its permissions");
}

TEST(RhythmOfAFile, RefusesAFolder) {
  EXPECT_EQ(MessageOf<InputError>([] { static_cast<void>(ReadUnbounded(GIRDLE_SOURCE_DIR)); }),
            std::string(GIRDLE_SOURCE_DIR) + ": is a folder. Name a file in it");
}

// A file of the test's own, gone with the test.
class OwnFile : public testing::Test {
 protected:
  void Write(const std::string& text) { std::ofstream(path_) << text; }
  void TearDown() override { std::remove(path_.c_str()); }

  // By process, because tests run side by side.
  std::string path_ =
      testing::TempDir() + "girdle_rhythm_table_" + std::to_string(getpid()) + ".csv";
};

TEST_F(OwnFile, OfABrokenTableIsNamedWithItsLine) {
  CsvText text = BuiltInText();
  text.Cell(6, "gh_flexion_deg") = "7O";
  Write(text.Text());
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(ReadUnbounded(path_)); }),
            path_ + ":8: gh_flexion_deg is '7O', expected a finite number such as 22.5");
}

TEST_F(OwnFile, OfATableWithUndeterminedWaysIsNamed) {
  CsvText text = BuiltInText();
  // From the first to the third elevation the clavicle turns by 200 deg in the last plane alone.
  for (std::size_t row = 2 * kElevations; row < kRows; ++row) {
    const std::size_t elevation = row - 2 * kElevations;
    text.Cell(row, "sc_protraction_deg") = elevation == 0 ? "-20" : elevation == 1 ? "80" : "180";
  }
  Write(text.Text());
  const std::string message = MessageOf<InputError>([&] {
    static_cast<void>(ReadUnbounded(path_, {Interpolation::kSquad, Closure::kTable}));
  });
  EXPECT_EQ(message.rfind(path_ + ": SC turns by 180 deg or more between planes", 0), 0U)
      << message;
}

TEST(RhythmTableToCsv, IsTheTextOfTheFileWithTheseComments) {
  EXPECT_EQ(RhythmTableToCsv(BuiltInRhythmTable(BuiltInTable::kMeasured), {"# one", "#two"}, 1),
            "# one\n#two\n" + BuiltInText().Text());
}

TEST(RhythmTableToCsv, RoundsAnglesButNotPlanesOrElevations) {
  std::vector<RhythmPosition> positions(4);
  positions[3].angles_rad[1] = RadiansFromDegrees(-12.34567);
  positions[3].measured = false;
  const RhythmTable table({0, RadiansFromDegrees(40.125)}, {0, RadiansFromDegrees(15.0625)},
                          positions);
  const std::string text = RhythmTableToCsv(table, {}, 2);
  EXPECT_EQ(text.substr(text.rfind('\n', text.size() - 2) + 1),
            "40.125,15.0625,sc_ac_derived,0,-12.35,0,0,0,0,0,0,0\n");
}

// The file's own rows, separated by ; as promised: short texts keep their digits.
TEST(RhythmTableToLine, IsTheTextOfTheFileInOneLine) {
  std::string expected = BuiltInText().Text();
  expected.pop_back();
  std::replace(expected.begin(), expected.end(), '\n', ';');
  EXPECT_EQ(RhythmTableToLine(BuiltInRhythmTable(BuiltInTable::kMeasured)), expected);
}

TEST(RhythmTableFromLine, GivesBackTheBuiltInTable) {
  ExpectSamePositions(
      RhythmTableFromLine(RhythmTableToLine(BuiltInRhythmTable(BuiltInTable::kMeasured)), "t.csv"),
      BuiltInRhythmTable(BuiltInTable::kMeasured));
}

TEST(RhythmTableFromLine, CountsARowAsALine) {
  CsvText text = BuiltInText();
  text.Cell(4, "ac_tilt_deg") = "x";
  std::string line = text.Text();
  std::replace(line.begin(), line.end(), '\n', ';');
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(RhythmTableFromLine(line, "key")); }),
            "key:6: ac_tilt_deg is 'x', expected a finite number such as 22.5");
}

// Two planes of two elevations with one angle of any size.
RhythmTable TableWith(double angle_rad) {
  std::vector<RhythmPosition> positions(4);
  const std::size_t index = *rc::gen::inRange<std::size_t>(0, positions.size());
  positions[index].angles_rad[*rc::gen::inRange<std::size_t>(0, kCoordinateCount)] = angle_rad;
  positions[index].measured = false;
  for (RhythmPosition& position : positions) {
    position.scapulothoracic_rad = Vector3(angle_rad, 0, -angle_rad);
  }
  return {{0, RadiansFromDegrees(40)}, {RadiansFromDegrees(15), RadiansFromDegrees(20)}, positions};
}

RC_GTEST_PROP(RhythmTableFromLine, GivesBackATableOfShortDegrees, ()) {
  const int decimals = *rc::gen::inRange(0, 13);
  const std::string angle_deg = RoundedText(*NumberWithin(-180, 180), decimals);
  const RhythmTable table = TableWith(RadiansFromDegrees(*FiniteNumber(angle_deg)));
  RC_ASSERT(SameBits(RhythmTableFromLine(RhythmTableToLine(table), "t.csv"), table));
}

// As a file may hold them: degrees with all their digits.
RC_GTEST_PROP(RhythmTableFromLine, GivesBackATableOfDegreesWithAllDigits, ()) {
  const double range_deg = *rc::gen::element(180.0, 1.0, 1e-3, 1e-9);
  const RhythmTable table = TableWith(RadiansFromDegrees(*NumberWithin(-range_deg, range_deg)));
  RC_ASSERT(SameBits(RhythmTableFromLine(RhythmTableToLine(table), "t.csv"), table));
}

// As a program may make them: radians, which degrees need not hit exactly.
RC_GTEST_PROP(RhythmTableFromLine, GivesBackATableOfRadiansToTheirLastDigits, ()) {
  constexpr double kTwoUnitsInTheLastPlace = 4.5e-16;
  const RhythmTable table = TableWith(*NumberWithin(-kPi, kPi));
  const RhythmTable back = RhythmTableFromLine(RhythmTableToLine(table), "t.csv");
  for (std::size_t i = 0; i < 4; ++i) {
    const RhythmPosition& a = back.position(i / 2, i % 2);
    const RhythmPosition& b = table.position(i / 2, i % 2);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      RC_ASSERT(std::abs(a.angles_rad[k] - b.angles_rad[k]) <=
                kTwoUnitsInTheLastPlace * std::abs(b.angles_rad[k]));
    }
  }
}

TEST(RhythmTableToLine, LeavesOutAPublishedScapulaThatIsNotThere) {
  const RhythmTable table({0, 1}, {0, 1}, std::vector<RhythmPosition>(4));
  EXPECT_EQ(RhythmTableToLine(table).find("st_"), std::string::npos);
  EXPECT_TRUE(SameBits(RhythmTableFromLine(RhythmTableToLine(table), "t.csv"), table));
}

}  // namespace
}  // namespace girdle::rhythm_table_csv_test
