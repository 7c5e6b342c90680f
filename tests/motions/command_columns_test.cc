// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/command_columns.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "text/input_error.h"

namespace girdle::command_columns_test {
namespace {

struct ReadFile {
  std::vector<ArmCommand> commands;
  AngleSpan span;
};

ReadFile Read(const std::string& text, const AngleReading& reading = {},
              const ArmCommand& otherwise = {}) {
  std::istringstream in(text);
  CsvReader csv(in, "t.csv");
  const CommandColumns columns(csv, reading);
  ReadFile file;
  while (csv.Next()) {
    file.commands.push_back(columns.Read(csv.row(), otherwise, file.span).value());
  }
  return file;
}

std::string RefusalOf(const std::string& text, const AngleReading& reading = {}) {
  try {
    Read(text, reading).span.ExpectKnownUnit("t.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

constexpr AngleReading kIsb = {AngleConvention::kIsb, {}};
constexpr AngleReading kRadians = {AngleConvention::kGirdle, AngleUnit::kRadian};
constexpr AngleReading kDegrees = {AngleConvention::kGirdle, AngleUnit::kDegree};

TEST(CommandColumns, AreReadInAnyOrderAmongOthers) {
  const ArmCommand command =
      Read(
          "note,shrug_deg,plane_deg,axial_deg,elevation_deg,protraction_deg,frame\n"
          "a,3,400,5,60,-4,1\n")
          .commands.at(0);
  EXPECT_EQ(command.elevation_rad, RadiansFromDegrees(60));
  EXPECT_EQ(command.plane_rad, RadiansFromDegrees(40));
  EXPECT_EQ(command.axial_rad, RadiansFromDegrees(5));
  EXPECT_EQ(command.shrug_rad, RadiansFromDegrees(3));
  EXPECT_EQ(command.protraction_rad, RadiansFromDegrees(-4));
}

TEST(CommandColumns, LeaveWhatTheyHaveNot) {
  const ArmCommand otherwise{9, 9, 0.25, 0.125, -0.125};
  const ArmCommand command = Read("elevation_deg,plane_deg\n60,40\n", {}, otherwise).commands.at(0);
  EXPECT_EQ(command.axial_rad, 0.25);
  EXPECT_EQ(command.shrug_rad, 0.125);
  EXPECT_EQ(command.protraction_rad, -0.125);
  EXPECT_EQ(command.plane_rad, RadiansFromDegrees(40));
}

// A row of elevation, plane and shrug, and what it is.
std::string RowOf(const std::string& fields) {
  std::istringstream in("elevation_deg,plane_deg,shrug_deg\n" + fields + "\n");
  CsvReader csv(in, "t.csv");
  const CommandColumns columns(csv, {});
  AngleSpan span;
  try {
    static_cast<void>(csv.Next());
    return columns.Read(csv.row(), {}, span) ? "command" : columns.GapText(csv.row());
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(CommandColumns, MayHaveGaps) {
  EXPECT_EQ(RowOf("15,40,1"), "command");
  EXPECT_EQ(RowOf(",40,1"), "elevation_deg is empty, a gap");
  EXPECT_EQ(RowOf("15,40, "), "shrug_deg is empty, a gap");
  for (const std::string gap : {"nan", "NaN", "NAN", "NA", "#N/A"}) {
    EXPECT_EQ(RowOf("15," + gap + ",1"), "plane_deg is '" + gap + "', a gap");
  }
}

TEST(CommandColumns, AreRefusedBesideGaps) {
  EXPECT_EQ(RowOf(",inf,1"), "t.csv:2: plane_deg is 'inf', expected a finite number such as 22.5");
  EXPECT_EQ(RowOf(",40,-"), "t.csv:2: shrug_deg is '-', expected a finite number such as 22.5");
  EXPECT_EQ(RowOf("181,,"), "t.csv:2: elevation_deg is 181: expected 0 to 180 degrees");
}

TEST(CommandColumns, OfMoblArmsCountTheAxialTurnWithThePlane) {
  const std::string header = "shoulder_rot,elv_angle,shoulder_elv\n";
  const ArmCommand command = Read(header + "20,30,90\n").commands.at(0);
  EXPECT_EQ(command.elevation_rad, RadiansFromDegrees(90));
  EXPECT_EQ(command.plane_rad, RadiansFromDegrees(30));
  EXPECT_NEAR(command.axial_rad, RadiansFromDegrees(-10), 1e-15);
  EXPECT_EQ(command.axial_from, AxialFrom::kIsb);
  AngleReading from_rhythm;
  from_rhythm.must_have_axial = true;
  EXPECT_EQ(RefusalOf(header + "20,30,90\n", from_rhythm),
            "t.csv:1: --axial-from rhythm: 'shoulder_rot' counts from isb. Omit --axial-from");
}

TEST(CommandColumns, OfOpenCapHaveIsbsAxialTurn) {
  const ArmCommand command =
      Read("sh_plane_elev_l,sh_elev_l,sh_axial_rot_l\n30,90,-10\n").commands.at(0);
  EXPECT_EQ(command.plane_rad, RadiansFromDegrees(30));
  EXPECT_EQ(command.axial_rad, RadiansFromDegrees(-10));
  EXPECT_EQ(command.axial_from, AxialFrom::kIsb);
}

TEST(CommandColumns, AreReadAsIsbWritesThem) {
  const ArmCommand command = Read("elevation_deg,plane_deg\n-90,40\n", kIsb).commands.at(0);
  EXPECT_EQ(command.elevation_rad, RadiansFromDegrees(90));
  EXPECT_EQ(command.plane_rad, RadiansFromDegrees(40));
}

TEST(CommandColumns, CountAxialTurnsFromWhatTheReadingSays) {
  AngleReading from_isb;
  from_isb.axial_from = AxialFrom::kIsb;
  const ArmCommand given =
      Read("elevation_deg,plane_deg,axial_deg\n60,40,-50\n", from_isb).commands.at(0);
  EXPECT_EQ(given.axial_rad, RadiansFromDegrees(-50));
  EXPECT_EQ(given.axial_from, AxialFrom::kIsb);
  // Without the column the turn is the rhythm's own.
  EXPECT_EQ(Read("elevation_deg,plane_deg\n60,40\n", from_isb).commands.at(0).axial_from,
            AxialFrom::kRhythm);
}

TEST(CommandColumns, AreReadAsRadians) {
  // The bounds of the offsets, 35 and 30 degrees, are accepted in as many digits as people write.
  const ArmCommand command = Read(
                                 "elevation_deg,plane_deg,axial_deg,shrug_deg,protraction_deg\n"
                                 "1.25,0.5,-0.25,0.6108652381980153,0.523598775598299\n",
                                 kRadians)
                                 .commands.at(0);
  constexpr double kFewUnits = 1e-15;
  EXPECT_NEAR(command.elevation_rad, 1.25, kFewUnits);
  EXPECT_NEAR(command.plane_rad, 0.5, kFewUnits);
  EXPECT_NEAR(command.axial_rad, -0.25, kFewUnits);
  EXPECT_NEAR(DegreesFromRadians(command.shrug_rad), 35, 1e-9);
  EXPECT_NEAR(DegreesFromRadians(command.protraction_rad), 30, 1e-9);
}

TEST(CommandColumns, WithRadiansInTheirNamesAreToldTheOption) {
  EXPECT_EQ(
      RefusalOf("Elevation [rad],plane_rad\n0.5,0.4\n"),
      "t.csv:1: column 'Elevation [rad]' is not known. Name it 'elevation_deg' or give --columns "
      "'elevation_deg=Elevation [rad]', whatever the unit, and give --angles rad");
  AngleReading radians;
  radians.unit = AngleUnit::kRadian;
  EXPECT_EQ(RefusalOf("elevation_deg,plane_rad\n0.5,0.4\n", radians),
            "t.csv:1: column 'plane_rad' is not known. Name it 'plane_deg' or give --columns "
            "plane_deg=plane_rad, whatever the unit, if all angles of the file are in radians");
  AngleReading degrees;
  degrees.unit = AngleUnit::kDegree;
  EXPECT_EQ(
      RefusalOf("elevation_rad,plane_rad\n0.5,0.4\n", degrees),
      "t.csv:1: column 'elevation_rad' is not known. All angles of a file have one unit: write "
      "these in degrees, too, as 'elevation_deg', or all in radians with --angles rad");
  EXPECT_EQ(
      RefusalOf("elevation_deg,plane_deg,elevation_rad\n60,40,1\n"),
      "t.csv:1: column 'elevation_rad' is not known. 'elevation_deg' is there, too: leave one "
      "of them out");
  EXPECT_EQ(RefusalOf("elevation_deg,plane_rad\n60,0.4\n"),
            "t.csv:1: column 'plane_rad' is not known. All angles of a file have one unit: write "
            "these in degrees, too, as 'plane_deg', or all in radians with --angles rad");
  EXPECT_EQ(RefusalOf("elevation,plane_deg\n0.5,40\n"),
            "t.csv:1: column 'elevation' is not known. Did you mean 'elevation_deg'? Correct its "
            "name or give --columns elevation_deg=elevation. If it is something else, give it a "
            "name that is less alike");
}

TEST(CommandColumns, AreRefusedWithPlaceValueAndFix) {
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg\n15,40\n-15,40\n"),
            "t.csv:3: elevation_deg is -15: elevation counts from 0, hanging, up to 180. In ISB's "
            "Y-X'-Y'' a raised arm has a negative elevation: for such angles give --convention "
            "isb");
  // An axial turn is ISB's, too, and stays so where only the elevation is turned by hand.
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg,axial_deg\n-15,40,-60\n"),
            "t.csv:2: elevation_deg is -15: elevation counts from 0, hanging, up to 180. In ISB's "
            "Y-X'-Y'' a raised arm has a negative elevation: for such angles give --convention "
            "isb, which reads axial as ISB's third angle, too. If you turn the sign of the "
            "elevation yourself instead, leave axial as it is and give --axial-from isb");
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg,axial_deg\n15,40,-60\n", kIsb),
            "t.csv:2: elevation_deg is 15: ISB's Y-X'-Y'' writes the elevation of a raised arm "
            "negative, 0 to -180. If here it is positive, give --convention girdle, and "
            "--axial-from isb if axial is ISB's third angle; if the arm points to the other side, "
            "write (plane + 180, -elevation, axial + 180), the same rotation");
  EXPECT_TRUE(RefusalOf("elevation_deg,plane_deg\n-15,40\n15,40\n", kIsb)
                  .starts_with("t.csv:3: elevation_deg is 15: ISB's Y-X'-Y'' writes"));
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg\n181,40\n"),
            "t.csv:2: elevation_deg is 181: expected 0 to 180 degrees");
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg\n15,1e300\n"),
            "t.csv:2: plane_deg is 1e+300: expected an angle within -3600 to 3600 degrees");
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg\n15,inf\n"),
            "t.csv:2: plane_deg is 'inf', expected a finite number such as 22.5");
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg,shrug_deg\n1,1,1\n", kRadians),
            "t.csv:2: shrug_deg is 1, expected -15 to 35 degrees");
}

TEST(CommandColumns, AreRefusedWhereOneIsNearlyKnown) {
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg,axial\n15,40,1\n"),
            "t.csv:1: column 'axial' is not known. Did you mean 'axial_deg'? Correct its name or "
            "give --columns axial_deg=axial. If it is something else, give it a name that is less "
            "alike");
  EXPECT_TRUE(RefusalOf("elevation_deg,plane_deg,shrug_degs\n15,40,1\n").starts_with("t.csv:1: "));
  EXPECT_TRUE(RefusalOf("elevation,plane_deg\n15,40\n").find("mean 'elevation_deg'") !=
              std::string::npos);
  EXPECT_EQ(RefusalOf("elevation_deg,psi\n15,40\n"),
            "t.csv:1: column 'plane_deg' is missing. If it has another name, give --columns "
            "plane_deg=NAME. The header has: elevation_deg, psi");
}

TEST(CommandColumns, AreRefusedWhereAnotherOnePlainlyIsTheAxialTurn) {
  EXPECT_EQ(
      RefusalOf("elevation_deg,plane_deg,internal_rotation_deg\n15,40,1\n"),
      "t.csv:1: column 'internal_rotation_deg' is not known. Did you mean 'axial_deg', in "
      "which internal rotation is positive? Correct its name or give --columns "
      "axial_deg=internal_rotation_deg, and give --axial-from isb if it is ISB's third angle. "
      "If it is something else, give it a name that is less alike");
  // Beside the one that is read it is the owner's business.
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg,axial_deg,axial_isb_deg\n15,40,1,-40\n"),
            "accepted");
}

TEST(CommandColumns, AreRefusedWithoutAnAxialTurnWhereItsZeroIsSaid) {
  AngleReading said;
  said.axial_from = AxialFrom::kIsb;
  said.must_have_axial = true;
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg\n15,40\n", said),
            "t.csv:1: --axial-from isb: no axial turn is given. Add the column axial_deg, or omit "
            "--axial-from");
  EXPECT_EQ(RefusalOf("elevation_deg,plane_deg,axial_deg\n15,40,1\n", said), "accepted");
}

TEST(CommandColumns, SayWhatAxialTurnsCountFrom) {
  AngleReading from_isb;
  from_isb.axial_from = AxialFrom::kIsb;
  const auto axial_from = [&from_isb](const std::string& header) {
    std::istringstream in(header);
    const CsvReader csv(in, "t.csv");
    return CommandColumns(csv, from_isb).axial_from();
  };
  EXPECT_EQ(axial_from("elevation_deg,plane_deg,axial_deg\n"), AxialFrom::kIsb);
  EXPECT_EQ(axial_from("elevation_deg,plane_deg\n"), std::nullopt);
}

// Rows of an arm that is raised from 0.1 to `last` in steps of a tenth.
std::string RaisedTo(double last, int rows, double plane) {
  std::ostringstream text;
  text << "elevation_deg,plane_deg\n";
  for (int i = 0; i < rows; ++i) {
    text << 0.1 + (last - 0.1) * i / (rows - 1) << ',' << plane << '\n';
  }
  return text.str();
}

TEST(AngleSpan, TellsRadiansThatNobodySaid) {
  EXPECT_EQ(RefusalOf(RaisedTo(2.1, 10, 0.7)),
            "t.csv: in 10 rows elevation_deg is 0.1 to 2.1 and plane_deg 0.7 to 0.7, which look "
            "like radians. Give --angles rad, or --angles deg if they are degrees");
}

TEST(AngleSpan, TellsRadiansOfPlanesThatAreCountedFromZeroToAWholeTurn) {
  for (const double plane : {3.3, 6.28, -6.28}) {
    EXPECT_TRUE(RefusalOf(RaisedTo(2.1, 10, plane)).ends_with("--angles deg if they are degrees"))
        << plane;
  }
}

TEST(AngleSpan, LeavesWhatIsSaidOrShortOrStillOrFar) {
  EXPECT_EQ(RefusalOf(RaisedTo(2.1, 10, 0.7), kRadians), "accepted");
  EXPECT_EQ(RefusalOf(RaisedTo(2.1, 10, 0.7), kDegrees), "accepted");
  EXPECT_EQ(RefusalOf(RaisedTo(2.1, 9, 0.7)), "accepted");
  EXPECT_EQ(RefusalOf(RaisedTo(0.6, 10, 0.7)), "accepted");
  EXPECT_EQ(RefusalOf(RaisedTo(2.1, 10, 6.5)), "accepted");
  EXPECT_EQ(RefusalOf(RaisedTo(2.1, 10, -6.5)), "accepted");
  EXPECT_EQ(RefusalOf(RaisedTo(3.3, 10, 0.7)), "accepted");
}

TEST(AngleSpan, AddsUpParts) {
  AngleSpan whole;
  AngleSpan part;
  for (int i = 0; i < 5; ++i) {
    whole.Add(0.1, 0);
    part.Add(2, 0.1);
  }
  EXPECT_FALSE(whole.LooksLikeRadians());
  whole.Add(part);
  EXPECT_TRUE(whole.LooksLikeRadians());
  part.Add(40, 0);
  whole.Add(part);
  EXPECT_FALSE(whole.LooksLikeRadians());
}

}  // namespace
}  // namespace girdle::command_columns_test
