// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/scapulothoracic_survey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/named_elements.h"
#include "simulation/plugin_fixture.h"
#include "text/csv_text.h"
#include "text/input_error.h"

namespace girdle::scapulothoracic_survey_test {
namespace {

// What is left by equality constraints solved to 1e-9 rad, in degrees.
constexpr double kSolved_deg = 1e-6;
constexpr double kSolved_rad = RadiansFromDegrees(kSolved_deg);
// Positions by a chain of a few rotations.
constexpr double kSolved_m = 1e-8;

// A girdle that is a formula of the arm's elevation theta and plane psi [rad]:
//
//     clavicle  q_TC = Y(p) X(e)      p = -0.3 + 0.1 psi, e = -0.1 - 0.15 theta - 0.02 theta^2
//     scapula   q_TS = Y(i) X(u) Z(t) i = 0.6 + 0.2 psi,  u = -0.05 - 0.3 theta,  t = -0.1 + 0.1
//     theta
//
// The scapula floats on three slides, and a `connect` holds its origin at the clavicle's end. The
// humerus is Y(psi) X(-theta) Y(gamma). The thorax leans in the world.
constexpr double kClavicleLength_m = 0.15;

double Protraction(double plane) { return -0.3 + 0.1 * plane; }
double ClavicleElevation(double elevation) {
  return -0.1 - 0.15 * elevation - 0.02 * elevation * elevation;
}
double InternalRotation(double plane) { return 0.6 + 0.2 * plane; }
double UpwardRotation(double elevation) { return -0.05 - 0.3 * elevation; }
double Tilt(double elevation) { return -0.1 + 0.1 * elevation; }

// Text of three numbers; those of a left model are mirrored in the thorax's median plane.
std::string Point(bool left, double x, double y, double z) {
  return std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(left ? -z : z);
}
// An axis is turned and mirrored, so that the same angle makes the mirrored turn.
std::string Axis(bool left, double x, double y, double z) {
  const double sign = left ? -1 : 1;
  return std::to_string(sign * x) + " " + std::to_string(sign * y) + " " + std::to_string(z);
}

std::string FormulaModel(bool left = false) {
  const auto point = [left](double x, double y, double z) { return Point(left, x, y, z); };
  const auto hinge = [left](const std::string& name, double x, double y, double z) {
    return "<joint name=\"" + name + "\" axis=\"" + Axis(left, x, y, z) + "\"/>";
  };
  const auto site = [&](const std::string& name, double x, double y, double z) {
    return "<site name=\"" + name + "\" pos=\"" + point(x, y, z) + "\"/>";
  };
  const auto follows = [](const std::string& name, const std::string& leader, double constant,
                          double linear, double square = 0) {
    return "<joint joint1=\"" + name + "\" joint2=\"" + leader + "\" polycoef=\"" +
           std::to_string(constant) + " " + std::to_string(linear) + " " + std::to_string(square) +
           " 0 0\"/>";
  };
  const std::string mass = R"(<inertial pos="0 0 0" mass="1" diaginertia=".01 .01 .01"/>)";
  return R"(<mujoco><compiler angle="radian" autolimits="true"/><worldbody>
    <body name="trunk" pos="0.1 0.2 1" quat="0.6 0.5 -0.4 0.3">)" +
         mass + site("IJ", 0, 0, 0) + site("PX", 0.03, -0.13, 0) + site("C7", -0.12, 0.05, 0) +
         site("T8", -0.15, -0.17, 0) + "<body name=\"collar\" pos=\"" + point(-0.01, 0.01, 0.02) +
         "\">" + mass + hinge("collar_y", 0, 1, 0) + hinge("collar_x", 1, 0, 0) +
         site("root", 0, 0, 0) + site("collar_end", 0, 0, kClavicleLength_m) + "</body>" +
         "<body name=\"blade\" pos=\"" + point(-0.05, 0, 0.1) + "\">" + mass +
         R"(<joint name="slide_x" type="slide" axis="1 0 0"/>
            <joint name="slide_y" type="slide" axis="0 1 0"/>
            <joint name="slide_z" type="slide" axis="0 0 1"/>)" +
         hinge("blade_y", 0, 1, 0) + hinge("blade_x", 1, 0, 0) + hinge("blade_z", 0, 0, 1) +
         site("blade_origin", 0, 0, 0) + "</body>" + "<body name=\"upper\" pos=\"" +
         point(0, 0, 0.17) + "\">" + mass + hinge("swing", 0, 1, 0) + "<body name=\"middle\">" +
         mass + hinge("raise", -1, 0, 0) + "<body name=\"arm\">" + mass + hinge("twist", 0, 1, 0) +
         "</body></body></body></body></worldbody><equality>" +
         "<connect site1=\"collar_end\" site2=\"blade_origin\"/>" +
         follows("collar_y", "swing", -0.3, 0.1) +
         follows("collar_x", "raise", -0.1, -0.15, -0.02) + follows("blade_y", "swing", 0.6, 0.2) +
         follows("blade_x", "raise", -0.05, -0.3) + follows("blade_z", "raise", -0.1, 0.1) +
         "</equality></mujoco>";
}

// The arm's own rows stand last: 12 raise, 13 swing, 14 twist.
std::string FormulaMapping(bool left = false) {
  const auto row = [left](const std::string& part, const std::string& body, double x, double y,
                          double z) {
    std::string point = Point(left, x, y, z);
    std::replace(point.begin(), point.end(), ' ', ',');
    return part + ",body," + body + "," + point + ",,,\n";
  };
  return "part,by,name,x_m,y_m,z_m,per_elevation,per_plane,per_axial\n"
         "side,," +
         std::string(left ? "left" : "right") +
         ",,,,,,\nIJ,site,IJ,,,,,,\nPX,site,PX,,,,,,\nC7,site,C7,,,,,,\nT8,site,T8,,,,,,\n"
         "SC,site,root,,,,,,\nPAC,site,blade_origin,,,,,,\n" +
         row("TS", "blade", 0, 0, -0.13) + row("AI", "blade", 0, -0.11, -0.145) +
         row("GH", "arm", 0, 0, 0) + row("EM", "arm", 0, -0.28, -0.03) +
         row("EL", "arm", 0, -0.28, 0.03) +
         "arm,joint,raise,,,,1,,\narm,joint,swing,,,,,1,\narm,joint,twist,,,,,,1\n";
}

ModelMapping MappingOf(const std::string& text) {
  std::istringstream in(text);
  return ReadModelMapping(in, "m.csv");
}

const SurveyGrid kGrid = {{30, 60, 90, 120, 150}, {-20, 0, 40, 90, 110}};

class SurveyGirdleTest : public EngineTest {
 protected:
  static ScapulothoracicSurvey Survey(const std::string& xml, const std::string& mapping_text,
                                      const SurveyGrid& grid = kGrid) {
    const ModelPointer model = LoadedModel(xml);
    const ModelMapping mapping = MappingOf(mapping_text);
    const MappedShoulder shoulder(*model, mapping);
    MappedArm arm(*model, mapping);
    return SurveyGirdle(arm, shoulder, BuiltInRhythm(), BuiltInAnatomy().gliding, grid,
                        [](double) {});
  }

  static std::string Message(const std::string& xml, const std::string& mapping_text) {
    return MessageOf<InputError>([&] { static_cast<void>(Survey(xml, mapping_text)); });
  }

  static double Figure(const GirdleFigures& figures_deg, GirdleFigure figure) {
    const auto& value = figures_deg[static_cast<std::size_t>(figure)];
    EXPECT_TRUE(value) << "no " << Name(figure);
    return value.value_or(std::nan(""));
  }

  static const Residual& Line(const ScapulothoracicSurvey& survey, std::string_view group,
                              std::string_view item) {
    const auto& lines = survey.report.residuals;
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const Residual& line) {
      return line.group == group && line.item == item;
    });
    if (found == lines.end()) {
      throw std::logic_error("no line " + std::string(group) + ", " + std::string(item));
    }
    return *found;
  }
};

TEST_F(SurveyGirdleTest, FindsTheAnglesThatTheModelIsAFormulaOf) {
  const ScapulothoracicSurvey survey = Survey(FormulaModel(), FormulaMapping());
  ASSERT_EQ(survey.positions.size(), 25U);
  for (const SurveyedPosition& position : survey.positions) {
    const double elevation = position.elevation_rad;
    const double plane = position.plane_rad;
    ASSERT_EQ(position.not_reached, "");
    EXPECT_NEAR(position.reached.elevation_rad, elevation, kSolved_rad);
    EXPECT_NEAR(position.reached.plane_rad, plane, kSolved_rad);
    const GirdleFigures& model_deg = position.model_deg;
    const auto expect = [&](GirdleFigure figure, double value_rad) {
      EXPECT_NEAR(Figure(model_deg, figure), DegreesFromRadians(value_rad), kSolved_deg)
          << Name(figure) << elevation << " " << plane;
    };
    expect(GirdleFigure::kProtraction, Protraction(plane));
    expect(GirdleFigure::kClavicleElevation, ClavicleElevation(elevation));
    expect(GirdleFigure::kInternalRotation, InternalRotation(plane));
    expect(GirdleFigure::kUpwardRotation, UpwardRotation(elevation));
    expect(GirdleFigure::kTilt, Tilt(elevation));
    // Landmarks do not tell how a clavicle is turned about its axis.
    EXPECT_FALSE(model_deg[static_cast<std::size_t>(GirdleFigure::kClavicleRotation)]);
  }
  EXPECT_TRUE(survey.report.passed());
}

TEST_F(SurveyGirdleTest, HoldsThemAgainstTheMeasuredOnesForTheSameArm) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  for (const SurveyedPosition& position : Survey(FormulaModel(), FormulaMapping()).positions) {
    const double elevation = position.elevation_rad;
    const double plane = position.plane_rad;
    const ShoulderPose measured = rhythm.SolvePose({elevation, plane});
    const Quaternion q_TS = QuaternionFromEuler(
        EulerSequence::kYXZ, {InternalRotation(plane), UpwardRotation(elevation), Tilt(elevation)});
    EXPECT_NEAR(Figure(position.difference_deg, GirdleFigure::kScapula),
                DegreesFromRadians(AngleBetween(q_TS, measured.q_TS())), kSolved_deg);
    EXPECT_NEAR(Figure(position.difference_deg, GirdleFigure::kUpwardRotation),
                DegreesFromRadians(UpwardRotation(elevation) -
                                   EulerFromQuaternion(EulerSequence::kYXZ, measured.q_TS())[1]),
                kSolved_deg);
    const Vector3 axis =
        QuaternionFromEuler(EulerSequence::kYXZ,
                            {Protraction(plane), ClavicleElevation(elevation), 0}) *
        Vector3(0, 0, 1);
    EXPECT_NEAR(Figure(position.difference_deg, GirdleFigure::kClavicleAxis),
                DegreesFromRadians(std::acos(glm::dot(axis, measured.q_TC * Vector3(0, 0, 1)))),
                kSolved_deg);
  }
}

TEST_F(SurveyGirdleTest, TheMeasuredOnesAreThoseOfWhereTheArmIsAndNotOfTheCommand) {
  CsvText text(FormulaMapping());
  text.AddColumn("offset_deg", "");
  text.Cell(12, "offset_deg") = "4";
  text.Cell(13, "offset_deg") = "-3";
  const ShoulderRhythm rhythm = BuiltInRhythm();
  for (const SurveyedPosition& position : Survey(FormulaModel(), text.Text()).positions) {
    const double elevation = position.elevation_rad + RadiansFromDegrees(4);
    const double plane = position.plane_rad - RadiansFromDegrees(3);
    EXPECT_NEAR(position.reached.elevation_rad, elevation, kSolved_rad);
    EXPECT_NEAR(position.reached.plane_rad, plane, kSolved_rad);
    const Vector3 measured_rad =
        EulerFromQuaternion(EulerSequence::kYXZ, rhythm.SolvePose({elevation, plane}).q_TS());
    EXPECT_NEAR(Figure(position.measured_deg, GirdleFigure::kUpwardRotation),
                DegreesFromRadians(measured_rad[1]), kSolved_deg);
  }
}

TEST_F(SurveyGirdleTest, AModelOfTheMeasuredRhythmIsAtTheMeasuredPlaces) {
  std::ifstream in(GIRDLE_SOURCE_DIR "/data/mappings/girdle_right.csv");
  std::stringstream mapping;
  mapping << in.rdbuf();
  const ScapulothoracicSurvey survey = Survey(ShoulderXml(), mapping.str());
  // Servos at rest, at 1e-6 rad/s and with a lag of 20 ms.
  constexpr double kServo_deg = 1e-5;
  for (const Residual& line : survey.report.residuals) {
    if (line.unit == "deg") {
      EXPECT_LT(std::abs(line.value), kServo_deg) << line.group << " " << line.item;
    }
  }
  EXPECT_EQ(Line(survey, "arm", "positions not reached").value, 0);
  EXPECT_LT(std::abs(Line(survey, "scapulothoracic", "scapula orientation, largest").value),
            kServo_deg);
  EXPECT_LT(std::abs(Line(survey, "beyond the table", "clavicle axis, largest").value), kServo_deg);
  // Of the gliding surface that was fitted to it.
  EXPECT_LT(Line(survey, "scapulothoracic", "TS, AI to ellipsoid, rms").value, 5);
  EXPECT_TRUE(survey.report.passed());
}

TEST_F(SurveyGirdleTest, TheLeftMirrorImageHasTheSameAngles) {
  const ScapulothoracicSurvey right = Survey(FormulaModel(), FormulaMapping());
  const ScapulothoracicSurvey left = Survey(FormulaModel(true), FormulaMapping(true));
  ASSERT_EQ(left.positions.size(), right.positions.size());
  for (std::size_t i = 0; i < left.positions.size(); ++i) {
    ASSERT_EQ(left.positions[i].not_reached, "");
    for (std::size_t k = 0; k < kGirdleFigureCount; ++k) {
      ASSERT_EQ(left.positions[i].difference_deg[k].has_value(),
                right.positions[i].difference_deg[k].has_value());
      if (right.positions[i].difference_deg[k]) {
        EXPECT_NEAR(*left.positions[i].difference_deg[k], *right.positions[i].difference_deg[k],
                    kSolved_deg)
            << kGirdleFigureNames[k];
      }
    }
    for (const std::size_t border : {0U, 1U}) {
      EXPECT_NEAR(left.positions[i].border_mm[border].value(),
                  right.positions[i].border_mm[border].value(), 1000 * kSolved_m);
    }
  }
}

TEST_F(SurveyGirdleTest, BodiesWithTheirTurnsSayWhatLandmarksSayOnBothSides) {
  // The blade's and the collar's bodies have the bones' axes; the row of the thorax turns the axes
  // of a body on the trunk back.
  constexpr double kPlate_rad = 0.5;
  // Six decimals of the turn's text.
  constexpr double kText_deg = 1e-6;
  const ScapulothoracicSurvey by_landmarks = Survey(FormulaModel(), FormulaMapping());
  for (const bool left : {false, true}) {
    const double plate_rad = left ? -kPlate_rad : kPlate_rad;
    const std::string xml = Replaced(FormulaModel(left), "<body name=\"collar\"",
                                     "<body name=\"plate\" euler=\"0 " + std::to_string(plate_rad) +
                                         " 0\"/><body name=\"collar\"");
    CsvText text(FormulaMapping(left));
    for (const char* const column : {"y_deg", "x_deg", "z_deg"}) {
      text.AddColumn(column, "");
    }
    const auto bone = [](const std::string& name, const std::string& body, double y_rad) {
      return std::vector<std::string>{
          name, "body", body, "", "", "", "", "", "", std::to_string(DegreesFromRadians(y_rad)),
          "0",  "0"};
    };
    text.rows.push_back(bone("scapula", "blade", 0));
    text.rows.push_back(bone("clavicle", "collar", 0));
    text.rows.push_back(bone("thorax", "plate", -plate_rad));
    const ScapulothoracicSurvey by_bodies = Survey(xml, text.Text());
    for (std::size_t i = 0; i < by_bodies.positions.size(); ++i) {
      for (const GirdleFigure figure :
           {GirdleFigure::kClavicleAxis, GirdleFigure::kScapula, GirdleFigure::kUpwardRotation,
            GirdleFigure::kInternalRotation}) {
        EXPECT_NEAR(Figure(by_bodies.positions[i].difference_deg, figure),
                    Figure(by_landmarks.positions[i].difference_deg, figure),
                    kSolved_deg + kText_deg)
            << "left " << left;
      }
      EXPECT_NEAR(Figure(by_bodies.positions[i].model_deg, GirdleFigure::kClavicleRotation), 0,
                  kSolved_deg + kText_deg);
    }
  }
}

TEST_F(SurveyGirdleTest, TheChangeOfTheScapulaDoesNotDependOnItsLandmarks) {
  CsvText other(FormulaMapping());
  // Row 7 is TS: 20 mm up and 10 back.
  other.Cell(7, "x_m") = "-0.01";
  other.Cell(7, "y_m") = "0.02";
  const ScapulothoracicSurvey a = Survey(FormulaModel(), FormulaMapping());
  const ScapulothoracicSurvey b = Survey(FormulaModel(), other.Text());
  std::size_t compared = 0;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    const auto& change = a.positions[i].change_difference_deg;
    if (!change[static_cast<std::size_t>(GirdleFigure::kScapula)]) {
      continue;
    }
    ++compared;
    for (const GirdleFigure figure : {GirdleFigure::kScapula, GirdleFigure::kInternalRotation,
                                      GirdleFigure::kUpwardRotation, GirdleFigure::kTilt}) {
      EXPECT_NEAR(Figure(b.positions[i].change_difference_deg, figure), Figure(change, figure),
                  kSolved_deg);
    }
    // The orientation itself does.
    EXPECT_GT(std::abs(Figure(b.positions[i].model_deg, GirdleFigure::kUpwardRotation) -
                       Figure(a.positions[i].model_deg, GirdleFigure::kUpwardRotation)),
              5);
  }
  // Planes 0, 40 and 90, three elevations above 30 each.
  EXPECT_EQ(compared, 9U);
}

TEST_F(SurveyGirdleTest, CountsWhatIsBeyondTheTableByItself) {
  const ScapulothoracicSurvey survey = Survey(FormulaModel(), FormulaMapping());
  for (const SurveyedPosition& position : survey.positions) {
    const double elevation_deg = DegreesFromRadians(position.elevation_rad);
    const double plane_deg = DegreesFromRadians(position.plane_rad);
    EXPECT_EQ(position.is_in_table, elevation_deg < 121 && plane_deg > -1 && plane_deg < 91)
        << elevation_deg << " " << plane_deg;
  }
  EXPECT_EQ(Line(survey, "scapulothoracic", "scapula orientation, rms").where, "12 values");
  EXPECT_EQ(Line(survey, "since elevation 30", "scapula orientation, rms").where, "9 values");
  EXPECT_EQ(Line(survey, "beyond the table", "scapula orientation, rms").where, "13 values");
}

TEST_F(SurveyGirdleTest, TheReportHoldsRmsAndTheLargestWithItsSign) {
  const ScapulothoracicSurvey survey = Survey(FormulaModel(), FormulaMapping());
  bool some_are_negative = false;
  for (const GirdleFigure figure :
       {GirdleFigure::kProtraction, GirdleFigure::kClavicleElevation,
        GirdleFigure::kInternalRotation, GirdleFigure::kUpwardRotation, GirdleFigure::kTilt}) {
    double square_sum = 0;
    double largest = 0;
    for (const SurveyedPosition& position : survey.positions) {
      if (position.is_in_table) {
        const double difference_deg = Figure(position.difference_deg, figure);
        square_sum += difference_deg * difference_deg;
        largest = std::abs(difference_deg) > std::abs(largest) ? difference_deg : largest;
      }
    }
    const std::string name(Name(figure));
    EXPECT_NEAR(Line(survey, "scapulothoracic", name + ", rms").value, std::sqrt(square_sum / 12),
                kSolved_deg);
    EXPECT_EQ(Line(survey, "scapulothoracic", name + ", largest").value, largest);
    some_are_negative = some_are_negative || largest < 0;
  }
  EXPECT_TRUE(some_are_negative) << "the formula does not show that signs are kept";
}

TEST_F(SurveyGirdleTest, TheSentenceSaysHowFarTheScapulaTurns) {
  // From 30 to 120 deg the formula turns the scapula upward by 0.3 * 90 deg.
  const ScapulothoracicSurvey survey = Survey(FormulaModel(), FormulaMapping());
  EXPECT_NE(survey.sentence.find("from 30 to 120 degrees in plane 0, its scapula turns upward by "
                                 "27 degrees, the measured one by "),
            std::string::npos)
      << survey.sentence;
  // From plane 0 to 90 by 0.2 * 90 deg about the vertical.
  EXPECT_NE(survey.sentence.find("from plane 0 to 90 at elevation 120 it turns by 18 degrees"),
            std::string::npos)
      << survey.sentence;
  const ScapulothoracicSurvey outside =
      Survey(FormulaModel(), FormulaMapping(), {{130, 150}, {0, 40}});
  EXPECT_EQ(outside.sentence.find("As this arm"), std::string::npos) << outside.sentence;
}

TEST_F(SurveyGirdleTest, TheJsonHasEveryPosition) {
  const ScapulothoracicSurvey survey = Survey(FormulaModel(), FormulaMapping());
  const nlohmann::json json = nlohmann::json::parse(SurveyIn({ReportForm::kJson, {}}, survey));
  EXPECT_EQ(json["sentence"], survey.sentence);
  EXPECT_EQ(json["residuals"].size(), survey.report.residuals.size());
  ASSERT_EQ(json["positions"].size(), survey.positions.size());
  const SurveyedPosition& position = survey.positions[7];
  const nlohmann::json& row = json["positions"][7];
  EXPECT_EQ(row["elevation_deg"], 90);
  EXPECT_EQ(row["plane_deg"], 0);
  EXPECT_EQ(row["in_table"], true);
  EXPECT_EQ(row["model"]["scapula_upward_rotation_deg"],
            Figure(position.model_deg, GirdleFigure::kUpwardRotation));
  EXPECT_EQ(row["difference_of_change"]["scapula_orientation_deg"],
            Figure(position.change_difference_deg, GirdleFigure::kScapula));
  EXPECT_EQ(row["TS_to_ellipsoid_mm"], position.border_mm[0].value());
}

TEST_F(SurveyGirdleTest, BonesThatHangOnTheArmFollowToTheModelsConnections) {
  const ModelPointer model = LoadedModel(FormulaModel());
  const ModelMapping mapping = MappingOf(FormulaMapping());
  MappedArm arm(*model, mapping);
  const int end = mj_name2id(model.get(), mjOBJ_SITE, "collar_end");
  const int origin = mj_name2id(model.get(), mjOBJ_SITE, "blade_origin");
  const auto gap_m = [&] {
    const mjtNum* a = arm.data().site_xpos + 3 * end;
    const mjtNum* b = arm.data().site_xpos + 3 * origin;
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  // The model as it is written is open.
  EXPECT_GT(gap_m(), 0.01);
  for (const double elevation : {0.2, 2.5, 1.0}) {
    const ArmMove move = arm.Move({elevation, 0.7, 0.1});
    EXPECT_TRUE(move.reached) << move.reason;
    EXPECT_LT(gap_m(), kSolved_m) << elevation;
  }
}

TEST_F(SurveyGirdleTest, SaysInTheSummaryByHowMuchTheArmMissesCommands) {
  CsvText text(FormulaMapping());
  text.AddColumn("offset_deg", "");
  text.Cell(12, "offset_deg") = "4";
  text.Cell(13, "offset_deg") = "-3";
  const auto summary = [](const std::string& mapping) {
    std::string shown = SurveyIn({ReportForm::kSummary, {}}, Survey(FormulaModel(), mapping));
    std::ranges::replace(shown, '\n', ' ');
    return shown;
  };
  const std::string missed = summary(text.Text());
  EXPECT_NE(missed.find("misses the commanded elevation by up to 4 deg"), std::string::npos)
      << missed;
  EXPECT_NE(missed.find("misses the commanded plane by up to 3 deg"), std::string::npos) << missed;
  const std::string exact = summary(FormulaMapping());
  EXPECT_EQ(exact.find("misses the commanded"), std::string::npos) << exact;
}

TEST_F(SurveyGirdleTest, SaysWhichPositionsAreBeyondTheRangeOfAJoint) {
  const std::string xml =
      Replaced(FormulaModel(), "<joint name=\"raise\"", "<joint name=\"raise\" range=\"0 1.7\"");
  const ScapulothoracicSurvey survey = Survey(xml, FormulaMapping());
  for (const SurveyedPosition& position : survey.positions) {
    EXPECT_EQ(position.not_reached.empty(), position.elevation_rad < 1.7);
  }
  const Residual& line = Line(survey, "arm", "positions not reached");
  EXPECT_EQ(line.value, 10);
  EXPECT_EQ(line.where,
            "of 25; elevation 120, plane -20: raise would be 120, its range is 0 to 97.4");
  // The summary shows few lines of the report, and this one in any case.
  for (const std::size_t width : {std::size_t{60}, std::size_t{80}}) {
    std::string summary = SurveyIn({ReportForm::kSummary, {.width = width}}, survey);
    std::ranges::replace(summary, '\n', ' ');
    EXPECT_NE(
        summary.find("Positions not reached: " + std::to_string(std::lround(line.value)) + " of "),
        std::string::npos)
        << summary;
  }
}

TEST_F(SurveyGirdleTest, SaysThatConstraintsCannotBeMet) {
  // The arm's point is held 0.3 m below a shoulder that it has to leave.
  const std::string held =
      Replaced(FormulaModel(), "<equality>",
               "<equality><connect body1=\"arm\" body2=\"trunk\" anchor=\"0 -0.3 0\"/>");
  const std::string message = Message(held, FormulaMapping());
  EXPECT_NE(message.find("the arm reaches none of the 25 positions; at elevation 30, plane -20 the "
                         "model's equality constraints cannot be met"),
            std::string::npos)
      << message;
}

TEST_F(SurveyGirdleTest, FindsItsWayBackFromAPositionThatCannotBeMet) {
  // A rope of 0.25 m from the arm's end to a point in front lets it go a part of the way only.
  const std::string roped =
      Replaced(Replaced(FormulaModel(), "<body name=\"arm\">",
                        "<body name=\"arm\"><site name=\"hand\" pos=\"0 -0.3 0\"/>"),
               "</equality>", "<connect site1=\"hand\" site2=\"hook\"/></equality>");
  const std::string xml =
      Replaced(roped, "<body name=\"collar\"",
               R"(<body name="sled" pos="0 -0.3 0.17"><inertial pos="0 0 0" mass="1"
         diaginertia=".01 .01 .01"/><joint name="along" type="slide" axis="0 0 1"/>
         <joint name="rise" type="slide" axis="0 1 0"/><site name="hook"/></body>
         <body name="collar")");
  // The sled slides in the frontal plane: other planes cannot be met.
  const ScapulothoracicSurvey survey = Survey(xml, FormulaMapping());
  for (const SurveyedPosition& position : survey.positions) {
    EXPECT_EQ(position.not_reached.empty(), position.plane_rad == 0)
        << position.elevation_rad << " " << position.plane_rad << " " << position.not_reached;
  }
}

TEST_F(SurveyGirdleTest, LandmarksOfOneBoneOnTwoBodiesFail) {
  CsvText text(FormulaMapping());
  text.Cell(7, "name") = "collar";
  const ScapulothoracicSurvey survey = Survey(FormulaModel(), text.Text());
  EXPECT_FALSE(Line(survey, "bones", "distances of a bone's landmarks").passed());
  EXPECT_FALSE(survey.report.passed());
}

TEST_F(SurveyGirdleTest, SaysThatServosDoNotComeToRest) {
  // Without damping and against gravity.
  const std::string xml =
      Replaced(Replaced(FormulaModel(), "</mujoco>",
                        "<actuator><position name=\"lift\" joint=\"raise\" kp=\"20\"/><position "
                        "name=\"turn\" joint=\"swing\" kp=\"20\"/></actuator></mujoco>"),
               "<worldbody>", "<option timestep=\"0.005\"/><worldbody>");
  CsvText text(FormulaMapping());
  text.RemoveRow(14);
  text.Cell(12, "by") = text.Cell(13, "by") = "actuator";
  text.Cell(12, "name") = "lift";
  text.Cell(13, "name") = "turn";
  const std::string message = MessageOf<InputError>([&] {
    static_cast<void>(Survey(xml, text.Text(), {{30, 60}, {0}}));
  });
  EXPECT_NE(message.find("the model does not come to rest, after 10 s"), std::string::npos)
      << message;
}

TEST_F(SurveyGirdleTest, AnArmThatDidNotRestStartsAnew) {
  const ModelPointer model = LoadedModel(R"(<mujoco><option gravity="0 0 0"/><worldbody>
    <body name="upper"><geom size=".1"/><joint name="swing" axis="0 1 0"/>
    <body name="arm"><geom size=".1" pos="0 -.3 0"/><joint name="raise" axis="-1 0 0"/></body></body>
    </worldbody><actuator><position name="lift" joint="raise"/><position name="turn" joint="swing"/>
    </actuator></mujoco>)");
  ModelMapping mapping;
  mapping.drives = {{.name = "lift", .per_elevation = 1}, {.name = "turn", .per_plane = 1}};
  mapping.drives_are_actuators = true;
  MappedArm arm(*model, mapping);
  // Nothing damps its swinging ...
  EXPECT_FALSE(arm.Move({1, 0, 0}).reached);
  // ... and where it starts from is where it is to be.
  EXPECT_TRUE(arm.Move({0, 0, 0}).reached);
}

struct MappingFlaw {
  const char* name;
  std::function<void(CsvText&)> change;
  const char* message;
};

void PrintTo(const MappingFlaw& flaw, std::ostream* out) { *out << flaw.name; }

class BadMappingTest : public SurveyGirdleTest, public testing::WithParamInterface<MappingFlaw> {};

TEST_P(BadMappingTest, IsRefusedWithItsLine) {
  CsvText text(FormulaMapping());
  GetParam().change(text);
  const std::string message = Message(FormulaModel(), text.Text());
  EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    , BadMappingTest,
    testing::Values(
        MappingFlaw{"NoSuchBody", [](CsvText& text) { text.Cell(7, "name") = "blades"; },
                    "m.csv:9: the model has no body 'blades'. The nearest are: blade, "},
        MappingFlaw{"NoSuchSite", [](CsvText& text) { text.Cell(5, "name") = "rooot"; },
                    "m.csv:7: the model has no site 'rooot'. The nearest are: root, "},
        MappingFlaw{"NoSuchJoint", [](CsvText& text) { text.Cell(12, "name") = "rise"; },
                    "m.csv:14: the model has no joint 'rise'. The nearest are: raise, "},
        MappingFlaw{"NoSuchActuator",
                    [](CsvText& text) {
                      for (const std::size_t row : {12U, 13U, 14U})
                        text.Cell(row, "by") = "actuator";
                    },
                    "m.csv:14: the model has no actuator 'raise' and none with a name"},
        MappingFlaw{"Slide", [](CsvText& text) { text.Cell(12, "name") = "slide_x"; },
                    "m.csv:14: joint 'slide_x' is not a hinge"},
        MappingFlaw{"Follower", [](CsvText& text) { text.Cell(12, "name") = "blade_x"; },
                    "m.csv:14: joint 'blade_x' follows joint 'raise' by an equality constraint"},
        MappingFlaw{"OnALine",
                    [](CsvText& text) {
                      text.Cell(8, "y_m") = "-0.001";
                      text.Cell(8, "z_m") = "-0.06";
                    },
                    "m.csv:10: PAC, TS and AI lie nearly on a line, 1 mm off it"},
        MappingFlaw{"OnePlace",
                    [](CsvText& text) {
                      for (const char* const column : {"x_m", "y_m", "z_m"}) {
                        text.Cell(11, column) = text.Cell(10, column);
                      }
                    },
                    "m.csv:13: GH, EM and EL are 0 to "},
        MappingFlaw{"OtherSide", [](CsvText& text) { text.Cell(0, "name") = "left"; },
                    "which no left shoulder does. Correct the side, or swap TS and PAC"},
        MappingFlaw{"TsAndPacSwapped",
                    [](CsvText& text) { std::swap(text.Cell(6, "part"), text.Cell(7, "part")); },
                    "which no right shoulder does"},
        MappingFlaw{"ScInPac", [](CsvText& text) { text.Cell(5, "name") = "collar_end"; },
                    "m.csv:7: SC and PAC are in one place"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(NearestNames, AreThoseWithTheFewestLettersChanged) {
  const std::vector<std::string> names = {"elbow", "shoulder_elv_r", "shoulder_rot_r", "clavicle"};
  EXPECT_EQ(NearestNames("shoulder_elv", names, 2),
            (std::vector<std::string>{"shoulder_elv_r", "shoulder_rot_r"}));
  EXPECT_EQ(NearestNames("elbwo", names, 1), std::vector<std::string>{"elbow"});
  EXPECT_EQ(NearestNames("x", {}, 3), std::vector<std::string>{});
}

}  // namespace
}  // namespace girdle::scapulothoracic_survey_test
