// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/report_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "residuals/residuals.h"
#include "simulation/engine_fixture.h"
#include "text/number_text.h"

namespace girdle {

std::string LineName(const Residual& residual) { return residual.group + ": " + residual.item; }

ReportLine LineOf(const Residual& residual) {
  constexpr int kDigits = 6;
  std::string judged = residual.follows ? "follows" : "stated";
  if (residual.tolerance) {
    judged = (residual.bound == Bound::kAtMost ? "<= " : "> ") +
             SignificantText(*residual.tolerance, kDigits);
  }
  return {LineName(residual), residual.unit, judged};
}

std::string TextOf(const std::vector<ReportLine>& lines) {
  std::string text;
  for (const ReportLine& line : lines) {
    text += line.name + " [" + line.unit + "] " + line.judged + "\n";
  }
  return text;
}

// Tolerances of what is exact, of what is held by a constraint, of what was measured: each with its
// reason in the group's file.
std::vector<ReportLine> LinesOf(ModelKind kind) {
  const bool is_loop = IsLoop(kind);
  const bool has_contact = HasContact(kind);
  const bool is_published = kind == ModelKind::kPublished;
  std::vector<ReportLine> lines;
  const auto add = [&lines](const std::string& name, const char* unit, const char* judged) {
    lines.push_back({name, unit, judged});
  };

  add("joint constraint: SC", "mm", "<= 1e-06");
  if (is_loop) {
    add("joint constraint: AC at rest", "mm", "<= 0.05");
    add("joint constraint: AC at the worst pose", "mm", "<= 0.05");
    add("joint constraint: AC moving", "mm", "<= 0.1");
    add("joint constraint: AC at 1 Hz", "mm", "<= 0.1");
    add("joint constraint: AC force at rest", "N", "stated");
    add("joint constraint: AC force at the worst pose", "N", "stated");
    add("joint constraint: AC force at 1 Hz", "N", "stated");
  } else {
    add("joint constraint: AC", "mm", "<= 1e-06");
  }
  add("joint constraint: GH", "mm", "<= 1e-06");

  add("bones: landmarks", "mm", "<= 1e-06");
  add("bones: masses", "kg", "<= 1e-09");
  add("bones: centres of mass", "mm", "<= 1e-06");
  add("bones: moments of inertia", "kg m^2", "<= 1e-09");

  for (const char* const item :
       {"SC", "AC", "GH", "clavicle landmarks", "scapula landmarks", "humerus landmarks"}) {
    add("kinematic consistency: " + std::string(item), "deg", "<= 1e-06");
  }
  if (is_loop) {
    add("kinematic consistency: scapula's place", "mm", "<= 1e-06");
  }
  add("kinematic consistency: keyframes", "deg", "<= 1e-06");
  if (is_loop) {
    add("kinematic consistency: keyframes, scapula's place", "mm", "<= 1e-06");
  }

  const std::vector<std::string> driven = {"SC", is_loop ? "ST" : "AC", "GH"};
  for (const std::string& joint : driven) {
    add("tracking settled: " + joint, "deg", has_contact ? "<= 0.03" : "<= 0.01");
  }
  add("tracking settled: fastest joint", "rad/s", "<= 1e-06");
  if (is_loop) {
    add("tracking settled: scapula's place, fastest", "m/s", "<= 1e-07");
  }
  for (const std::string& joint : driven) {
    add("tracking moving: " + joint, "deg", "<= 3");
  }

  const char* const own = is_published ? "<= 1e-06" : "follows";
  add("closure: elevation against the table's own", "deg", own);
  add("closure: plane against the table's own", "deg", own);
  add("closure: elevation reached - commanded", "deg", is_published ? "stated" : "<= 1e-06");
  if (is_published) {
    add("closure: plane, from elevation 30", "deg", "stated");
    add("closure: plane, below elevation 30", "deg", "stated");
  } else {
    add("closure: plane reached - commanded", "deg", "<= 1e-06");
    add("range: farthest from measured data", "deg", "stated");
  }

  add("scapulothoracic: published ST, rms", "deg", is_loop ? "follows" : "<= 2.1");
  add("scapulothoracic: published ST, worst", "deg", is_loop ? "follows" : "<= 2.6");
  if (is_loop) {
    add("emergent AC: measured AC, rms", "deg", "<= 2.1");
    add("emergent AC: measured AC, worst", "deg", "<= 2.6");
    add("emergent AC: ac_internal_rotation", "deg", "stated");
    add("emergent AC: ac_upward_rotation", "deg", "stated");
    add("emergent AC: ac_tilt", "deg", "stated");
  }
  // An adult's, and as much smaller as a small person.
  const bool is_small = kind == ModelKind::kSmallContact;
  add("scapulothoracic: TS, AI to ellipsoid, rms", "mm",
      is_small  ? "<= 4.38596"
      : is_loop ? "<= 6.5"
                : "<= 5");
  add("scapulothoracic: TS, AI to ellipsoid, worst", "mm", is_small ? "<= 14.9123" : "<= 17");
  if (!is_published) {
    add("scapulothoracic: TS, AI to ellipsoid, outside measured data", "mm", "stated");
  }

  if (has_contact) {
    add("thorax contact: force on TS or AI", "N", "stated");
    add(kContactStiffnessLine, "%", "<= 20");
    add("thorax contact: armature against the built-in's", "%", "<= 1e-06");
    add("thorax contact: depth against the anatomy's", "mm", "<= 0.01");
    add("thorax contact: TS or AI in the ellipsoid", "mm", "stated");
    for (const std::string& joint : driven) {
      add("thorax contact: " + joint + " pushed off its target", "deg", "stated");
    }
  }

  add("ligaments: lengths against the bones", "mm", "<= 1e-06");
  add("ligaments: slack against the anatomy's", "mm", "<= 1e-06");
  add("ligaments: stiffness against the anatomy's", "N/mm", "<= 1e-06");
  add("ligaments: range against the anatomy's", "mm", "<= 1e-06");
  for (const auto& [ligament, published] :
       {std::pair("conoid", "12.3 +- 6.6"), std::pair("trapezoid", "16.1 +- 5.2")}) {
    const std::string name = "ligaments: " + std::string(ligament);
    add(name + ", shortest", "mm", "stated");
    add(name + ", longest (published " + published + ")", "mm", "stated");
    add(name + ", beyond slack", "mm", "<= 0.1");
    add(name + ", force", "N", "stated");
  }
  return lines;
}

namespace report_lines_test {
namespace {

std::vector<ReportLine> LinesOf(const ResidualReport& report) {
  std::vector<ReportLine> lines;
  std::transform(report.residuals.begin(), report.residuals.end(), std::back_inserter(lines),
                 LineOf);
  return lines;
}

std::string FailedLines(const ResidualReport& report) {
  std::string text;
  for (const Residual& residual : report.residuals) {
    text += residual.passed() ? "" : LineName(residual) + "\n";
  }
  return text;
}

ResidualReport Measured(ModelPointer model, const ShoulderRhythm& rhythm, Assembly assembly,
                        const Anatomy& anatomy = BuiltInAnatomy()) {
  ShoulderSimulation simulation(std::move(model), "shoulder.xml");
  return MeasureResiduals(simulation, {rhythm, assembly}, anatomy, [](double) {});
}

class ReportLinesTest : public EngineTest, public testing::WithParamInterface<ModelKind> {};

// Which lines there are, in which order, and what each is judged by; and a sound model passes.
TEST_P(ReportLinesTest, AreAllOfThemAndPassForASoundModel) {
  const ShoulderModelOptions options = ModelOptionsOf(GetParam());
  const ShoulderRhythm rhythm = BuiltInRhythm(RhythmOptionsOf(GetParam()));
  const Anatomy anatomy = AnatomyOf(GetParam());
  const std::string xml = ShoulderModelXml(anatomy, rhythm, options);
  const ResidualReport report =
      Measured(LoadModel({{"shoulder.xml", xml}}), rhythm, options.assembly, anatomy);
  EXPECT_EQ(TextOf(LinesOf(report)), TextOf(girdle::LinesOf(GetParam())));
  EXPECT_EQ(FailedLines(report), "");
}

INSTANTIATE_TEST_SUITE_P(Kinds, ReportLinesTest, testing::ValuesIn(kModelKinds),
                         [](const testing::TestParamInfo<ModelKind>& kind) {
                           return std::string(Name(kind.param));
                         });

class LeaningThoraxTest : public EngineTest {};

// Somebody's thorax may have joints of its own, of which the shoulder's lines know nothing.
TEST_F(LeaningThoraxTest, HasTheSameLinesAndTheShouldersArmature) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  std::string xml = ShoulderModelXml(BuiltInAnatomy(), rhythm, ModelOptionsOf(ModelKind::kContact));
  const std::size_t thorax = xml.find("<body name=\"thorax\"");
  ASSERT_NE(thorax, std::string::npos);
  xml.insert(xml.find('>', thorax) + 1, "<joint name=\"lean\" axis=\"1 0 0\"/>");
  const ResidualReport report =
      Measured(LoadModel({{"shoulder.xml", xml}}), rhythm, Assembly::kTree);
  EXPECT_EQ(TextOf(LinesOf(report)), TextOf(girdle::LinesOf(ModelKind::kContact)));
  EXPECT_EQ(FailedLines(report).find("armature"), std::string::npos) << FailedLines(report);
}

class SkinnedReportTest : public EngineTest {};

// The committed models: a skin brings its lines after all others, and a model of both shoulders has
// every line twice.
TEST_F(SkinnedReportTest, HasTheLinesOfTheModelAndThoseOfTheSkin) {
  const ResidualReport report =
      Measured(LoadModel(GIRDLE_SOURCE_DIR "/model/shoulder_skin/shoulder_both.xml"),
               BuiltInRhythm(), Assembly::kTree);
  EXPECT_EQ(FailedLines(report), "");
  const std::vector<ReportLine> lines = LinesOf(report);
  ASSERT_EQ(lines.size() % 2, 0U);
  const std::vector<ReportLine> without_skin = girdle::LinesOf(ModelKind::kTree);
  ASSERT_GT(lines.size() / 2, without_skin.size());
  for (const std::string side : {"right", "left"}) {
    const auto first = lines.begin() + (side == "right" ? 0 : std::ssize(lines) / 2);
    std::vector<ReportLine> of_side(first, first + std::ssize(lines) / 2);
    std::set<std::string> names;
    for (ReportLine& line : of_side) {
      ASSERT_TRUE(line.name.ends_with(", " + side)) << line.name;
      line.name.resize(line.name.size() - side.size() - 2);
      EXPECT_TRUE(names.insert(line.name).second) << line.name << " twice";
    }
    const auto skin = of_side.begin() + std::ssize(without_skin);
    EXPECT_EQ(TextOf({of_side.begin(), skin}), TextOf(without_skin));
    EXPECT_TRUE(std::all_of(skin, of_side.end(), [](const ReportLine& line) {
      return line.name.starts_with("skin: ");
    }));
  }
}

}  // namespace
}  // namespace report_lines_test
}  // namespace girdle
