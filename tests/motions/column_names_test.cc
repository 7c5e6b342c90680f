// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/column_names.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "text/input_error.h"

namespace girdle::column_names_test {
namespace {

constexpr std::array<std::string_view, 4> kKnown = {kTimeColumn, kElevationColumn, kPlaneColumn,
                                                    kAxialColumn};

// The note about a header, or the message of its refusal.
std::string NoteOf(const std::string& header, const std::vector<NamedColumn>& given = {}) {
  std::istringstream in(header + "\n");
  const CsvReader csv(in, "t.csv");
  try {
    const ColumnNames names(csv, {kKnown.begin(), kKnown.end()}, given);
    names.ExpectNoneNearly(false, false);
    return names.Note();
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string RefusalOf(const std::string& option) {
  try {
    static_cast<void>(ReadNamedColumns(option, kKnown));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ReadNamedColumns, TakesPairs) {
  const std::vector<NamedColumn> columns =
      ReadNamedColumns("elevation_deg=shoulder_elv, plane_deg = a=b ", kKnown);
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[0].known, "elevation_deg");
  EXPECT_EQ(columns[0].in_file, "shoulder_elv");
  EXPECT_EQ(columns[1].known, "plane_deg");
  EXPECT_EQ(columns[1].in_file, "a=b");
}

TEST(ReadNamedColumns, RefusesOtherTexts) {
  const std::string pairs =
      " does not name a column. Give pairs with commas between, such as --columns "
      "elevation_deg=shoulder_elv,plane_deg=elv_angle";
  EXPECT_EQ(RefusalOf("plane_deg"), "--columns 'plane_deg': 'plane_deg'" + pairs);
  EXPECT_EQ(RefusalOf("plane_deg=a,"), "--columns 'plane_deg=a,': ''" + pairs);
  EXPECT_EQ(RefusalOf("plan_deg=a"),
            "--columns plan_deg=a: 'plan_deg' is not known. Did you mean 'plane_deg'? Before = "
            "stands one of: time_s, elevation_deg, plane_deg, axial_deg");
  EXPECT_EQ(RefusalOf("plane_deg=a,plane_deg=b"),
            "--columns plane_deg=b: 'plane_deg' is given twice. Remove one");
  EXPECT_EQ(RefusalOf("plane_deg=a,elevation_deg=a"),
            "--columns elevation_deg=a: 'a' is given twice. Remove one");
}

TEST(ColumnNames, HaveTheirOwnNames) {
  EXPECT_EQ(NoteOf("time_s,elevation_deg,plane_deg"), "");
  // Another name for a column that is there is the owner's business.
  EXPECT_EQ(NoteOf("elevation_deg,plane_deg,humeral_elevation_deg,shoulder_elv,elv_angle"), "");
}

TEST(ColumnNames, AreGiven) {
  EXPECT_EQ(NoteOf("theta,psi", {{"elevation_deg", "theta"}, {"plane_deg", "psi"}}),
            "read 'theta' as elevation_deg, 'psi' as plane_deg");
  // Also where a name that is nearly known is there: it is something else.
  EXPECT_EQ(NoteOf("theta,elevation", {{"elevation_deg", "theta"}}),
            "read 'theta' as elevation_deg");
  EXPECT_EQ(NoteOf("elevation_deg,elevation", {{"elevation_deg", "elevation_deg"}}), "");
}

TEST(ColumnNames, ThatAreGivenAndNotThereAreRefused) {
  EXPECT_EQ(NoteOf("theta,psi", {{"elevation_deg", "teta"}}),
            "t.csv:1: --columns elevation_deg=teta: there is no column 'teta'. Did you mean "
            "'theta'? The header has: theta, psi");
  EXPECT_EQ(NoteOf("theta,elevation_deg", {{"elevation_deg", "theta"}}),
            "t.csv:1: --columns elevation_deg=theta: the column 'elevation_deg' is there, too. "
            "Rename it, or omit this name");
}

TEST(ColumnNames, WithOneMeaningAreReadByThemselves) {
  EXPECT_EQ(NoteOf("Time (s),humeral_elevation_deg,plane_of_elevation_deg"),
            "read 'humeral_elevation_deg' as elevation_deg, 'plane_of_elevation_deg' as plane_deg, "
            "'Time (s)' as time_s");
  EXPECT_EQ(NoteOf("time,elv_angle,shoulder_elv,shoulder_rot"),
            "read 'shoulder_elv' as elevation_deg, 'elv_angle' as plane_deg, 'time' as time_s, "
            "'shoulder_rot' as axial_deg + plane_deg from isb");
  EXPECT_EQ(
      NoteOf("sh_plane_elev_r,sh_elev_r,sh_axial_rot_r"),
      "read 'sh_elev_r' as elevation_deg, 'sh_plane_elev_r' as plane_deg, 'sh_axial_rot_r' as "
      "axial_deg from isb");
}

TEST(ColumnNames, OfASetAreCompletedByThoseThatAreGiven) {
  EXPECT_EQ(NoteOf("elv_angle,shoulder_elv", {{"elevation_deg", "shoulder_elv"}}),
            "read 'shoulder_elv' as elevation_deg, 'elv_angle' as plane_deg");
  EXPECT_EQ(NoteOf("elv_angle,shoulder_elv,theta", {{"elevation_deg", "theta"}}),
            "read 'theta' as elevation_deg");
}

// shoulder_elv is in the scapula in other models, and there plane_elv is its partner.
TEST(ColumnNames, OfASetHaveNoMeaningAlone) {
  EXPECT_EQ(NoteOf("shoulder_elv,plane_elv,axial_rot"), "");
  EXPECT_EQ(NoteOf("elv_angle"), "");
}

TEST(ColumnNames, ThatMeanOneColumnAreRefused) {
  EXPECT_EQ(NoteOf("humeral_elevation_deg,humerothoracic_elevation_deg"),
            "t.csv:1: the columns 'humeral_elevation_deg' and 'humerothoracic_elevation_deg' both "
            "mean elevation_deg. Choose one with --columns elevation_deg=humeral_elevation_deg");
  EXPECT_EQ(NoteOf("sh_plane_elev_r,sh_elev_r,sh_plane_elev_l,sh_elev_l"),
            "t.csv:1: the columns 'sh_elev_r' and 'sh_elev_l' both mean elevation_deg. Choose one "
            "arm with --columns elevation_deg=sh_elev_r,plane_deg=sh_plane_elev_r");
}

TEST(ColumnNames, LeaveAKnownNameThatIsNearlyAnother) {
  std::istringstream in("time_s,times_s\n");
  const CsvReader csv(in, "t.csv");
  const ColumnNames names(csv, {"time_s", "times_s"}, {});
  EXPECT_NO_THROW(names.ExpectNoneNearly(false, false));
}

TEST(ColumnsOption, IsWrittenForAShell) {
  EXPECT_EQ(ColumnsOption("axial_deg", "ht_rot.2"), "--columns axial_deg=ht_rot.2");
  EXPECT_EQ(ColumnsOption("axial_deg", "Rotation (deg)"), "--columns 'axial_deg=Rotation (deg)'");
  EXPECT_EQ(ColumnsOption("axial_deg", "rotation, internal"), "--columns axial_deg=NAME");
}

}  // namespace
}  // namespace girdle::column_names_test
