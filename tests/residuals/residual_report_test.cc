// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/residual_report.h"
#include "residuals/report_parts.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace girdle::residual_report_test {
namespace {

ResidualReport PassingReport() {
  ResidualReport report{"scene.xml", "right, tree", "smooth", "4.0.1", "", {}};
  report.residuals = {
      {"joint constraint", "SC", 0.5, "mm", 1, "abduction, elevation 15, plane 0"},
      {"joint constraint", "AC", 0.02, "mm", 0.03, "1 Hz, elevation 90, plane -30"},
      {"joint constraint", "AC force", 900, "N", std::nullopt, "abduction"},
      {"skin", "acromion rises", 9, "mm", 8, "elevation 30 to 120, plane 0", Bound::kMoreThan},
      {"range", "farthest", 64.8, "deg", std::nullopt, "grid, elevation 62.5, plane -95"}};
  return report;
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

// The line of a table that begins with a kind.
std::string LineOf(const std::string& text, const std::string& kind) {
  for (const std::string& line : LinesOf(text)) {
    if (line.starts_with(kind)) {
      return line;
    }
  }
  return "no line of " + kind;
}

std::string Summary(const ResidualReport& report, const TextStyle& style = {}) {
  return ReportIn({ReportForm::kSummary, style}, report);
}

TEST(Verdict, CountsWhatIsCheckedAndWhatFails) {
  ResidualReport report = PassingReport();
  EXPECT_EQ(VerdictText(report, {}), "PASS: 3 residuals checked, all within their tolerances\n");
  report.residuals[0].value = 2;
  EXPECT_EQ(VerdictText(report, {}), "FAIL: 1 of 3 residuals outside its tolerance\n");
  report.residuals[3].value = 7;
  EXPECT_EQ(VerdictText(report, {}), "FAIL: 2 of 3 residuals outside their tolerances\n");
}

TEST(Verdict, IsInTheSingularForOneResidual) {
  ResidualReport report = PassingReport();
  report.residuals.resize(1);
  EXPECT_EQ(VerdictText(report, {}), "PASS: 1 residual checked, within its tolerance\n");
  report.residuals.push_back(PassingReport().residuals[0]);
  report.residuals[1].tolerance = std::nullopt;
  EXPECT_NE(Summary(report).find(" 1 value has no tolerance."), std::string::npos)
      << Summary(report);
}

TEST(Json, HasNullForAValueThatIsNotFinite) {
  ResidualReport report = PassingReport();
  report.residuals[0].value = std::numeric_limits<double>::quiet_NaN();
  report.residuals[1].value = std::numeric_limits<double>::infinity();
  const nlohmann::json json = nlohmann::json::parse(ReportIn({ReportForm::kJson, {}}, report));
  EXPECT_TRUE(json["residuals"][0]["value"].is_null());
  EXPECT_FALSE(json["residuals"][0]["passed"]);
  EXPECT_TRUE(json["residuals"][1]["value"].is_null());
  EXPECT_TRUE(json["residuals"][2]["value"].is_number());
}

TEST(Summary, ShortensOnlyThePlaceThatHasNoRoom) {
  ResidualReport report = PassingReport();
  report.residuals[3].where = std::string(60, 'x') + ", elevation 30, plane 40";
  const std::string text = Summary(report);
  EXPECT_TRUE(LineOf(text, "skin").ends_with("  30/40")) << text;
  EXPECT_TRUE(LineOf(text, "joint constraint").ends_with("  1 Hz 90/-30")) << text;
}

TEST(Summary, HasTheVerdictFirstAndLast) {
  const std::string text = Summary(PassingReport());
  const std::string verdict = VerdictText(PassingReport(), {});
  EXPECT_TRUE(text.ends_with("\n" + verdict)) << text;
  EXPECT_LT(text.find(verdict), text.find("joint constraint")) << text;
}

TEST(Summary, ShowsOfEachKindTheResidualNearestToItsTolerance) {
  const std::string text = Summary(PassingReport());
  // AC takes two thirds of its tolerance, SC half, though its value is larger.
  EXPECT_EQ(LineOf(text, "joint constraint"),
            "joint constraint   0.02 mm  <= 0.03   2        1 Hz 90/-30")
      << text;
  EXPECT_EQ(LineOf(text, "skin"), "skin                  9 mm  > 8       1        30 to 120/0")
      << text;
  EXPECT_EQ(LineOf(text, "range"), "range             64.8 deg  no limit  0        grid 62.5/-95")
      << text;
}

TEST(Summary, SaysHowManyValuesHaveNoTolerance) {
  EXPECT_NE(Summary(PassingReport()).find("2 values have no tolerance"), std::string::npos);
}

TEST(Summary, ShowsEveryFailureInFull) {
  ResidualReport report = PassingReport();
  report.residuals[0].value = 2;
  report.residuals[3].value = std::numeric_limits<double>::quiet_NaN();
  const std::string text = Summary(report);
  EXPECT_NE(text.find("FAIL joint constraint, SC: 2 mm, must be at most 1 mm (abduction, elevation "
                      "15,\n     plane 0)\n"),
            std::string::npos)
      << text;
  EXPECT_NE(
      text.find("FAIL skin, acromion rises: nan mm, must be more than 8 mm (elevation 30 to 120,\n"
                "     plane 0)\n"),
      std::string::npos)
      << text;
  EXPECT_EQ(
      LineOf(text, "joint constraint").find("joint constraint      2 mm  <= 1      2, 1 FAIL"), 0U)
      << text;
}

TEST(Summary, ShowsTheRemarkOfTheReport) {
  ResidualReport report = PassingReport();
  report.remark = "The model does not carry its anatomy.";
  EXPECT_NE(Summary(report).find("\n" + report.remark + "\n"), std::string::npos);
}

TEST(Summary, IsNoWiderThanItsStyle) {
  ResidualReport report = PassingReport();
  report.model = std::string(300, 'm');
  report.residuals[0].value = 2;
  report.residuals[0].where = std::string(50, 'w') + " " + std::string(30, 'w');
  report.remark =
      "A remark of so many words that it stands on two lines of a terminal, or on more.";
  for (const std::size_t width : {60U, 66U, 80U, 120U}) {
    for (const ReportForm form : {ReportForm::kSummary, ReportForm::kFull}) {
      for (const std::string& line : LinesOf(ReportIn({form, {.width = width}}, report))) {
        EXPECT_LE(line.size(), width) << line;
      }
    }
  }
}

TEST(Summary, LeavesOutThePlaceRatherThanCutIt) {
  ResidualReport report = PassingReport();
  report.residuals[1].where = "a motion with a long name, elevation 119.7, plane 102.4";
  EXPECT_TRUE(LineOf(Summary(report, {.width = 120}), "joint constraint")
                  .ends_with("a motion with a long name 119.7/102.4"));
  EXPECT_TRUE(
      LineOf(Summary(report, {.width = 70}), "joint constraint").ends_with("  119.7/102.4"));
  EXPECT_TRUE(LineOf(Summary(report, {.width = 50}), "joint constraint").ends_with(" 2"));
}

TEST(Summary, DoesNotTakeZeroOfZeroForTheWorst) {
  ResidualReport report = PassingReport();
  report.residuals.push_back({"joint constraint", "GH", 0, "mm", 0, "hanging"});
  EXPECT_NE(LineOf(Summary(report), "joint constraint").find("0.02"), std::string::npos);
}

TEST(Summary, IsColouredOnlyWhereTheStyleIs) {
  EXPECT_EQ(Summary(PassingReport()).find('\x1b'), std::string::npos);
  const std::string text = Summary(PassingReport(), {.has_colour = true});
  EXPECT_NE(text.find("\x1b[32mPASS"), std::string::npos) << text;
  ResidualReport failed = PassingReport();
  failed.residuals[0].value = 2;
  EXPECT_NE(Summary(failed, {.has_colour = true}).find("\x1b[31mFAIL"), std::string::npos);
}

TEST(FullReport, HasALineForEachResidual) {
  const std::string text = ReportIn({ReportForm::kFull, {.width = 500}}, PassingReport());
  EXPECT_EQ(LineOf(text, "joint constraint  AC force"),
            "joint constraint  AC force          900          -  N     stated  abduction")
      << text;
  EXPECT_TRUE(text.ends_with(VerdictText(PassingReport(), {}))) << text;
}

TEST(FullReport, PutsKindsAndPosesOnLinesOfTheirOwnWhereItIsNarrow) {
  const std::string text = ReportIn({ReportForm::kFull, {.width = 60}}, PassingReport());
  EXPECT_NE(text.find("joint constraint\n"
                      "  SC                                  0.5     1  mm   pass\n"
                      "      abduction, elevation 15, plane 0\n"),
            std::string::npos)
      << text;
  for (const std::string& line : LinesOf(text)) {
    EXPECT_LE(line.size(), 60U) << line;
  }
}

}  // namespace
}  // namespace girdle::residual_report_test
