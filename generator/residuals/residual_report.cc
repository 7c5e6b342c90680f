// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/residual_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

constexpr int kReportedDigits = 3;

std::string ToleranceText(const Residual& residual) {
  return residual.tolerance ? (residual.bound == Bound::kMoreThan ? "> " : "") +
                                  SignificantText(*residual.tolerance, kReportedDigits)
                            : "-";
}

}  // namespace

std::string ReportAsText(const ResidualReport& report) {
  std::vector<std::vector<std::string>> rows = {
      {"residual", "of", "value", "tolerance", "unit", "result", "where"}};
  for (const Residual& residual : report.residuals) {
    rows.push_back({residual.group, residual.item, SignificantText(residual.value, kReportedDigits),
                    ToleranceText(residual), residual.unit,
                    residual.follows      ? "follows"
                    : !residual.tolerance ? "stated"
                    : residual.passed()   ? "pass"
                                          : "FAIL",
                    residual.where});
  }
  std::string text = "model   " + report.model + "\nkind    " + report.kind + "\nrhythm  " +
                     report.rhythm + "\nengine  MuJoCo " + report.engine + "\n\n";
  // Numbers stand to the right, words to the left.
  constexpr Alignment kWords = Alignment::kLeft;
  constexpr Alignment kNumbers = Alignment::kRight;
  text += ColumnsText(rows, {kWords, kWords, kNumbers, kNumbers, kWords});
  const auto failed = std::count_if(report.residuals.begin(), report.residuals.end(),
                                    [](const Residual& residual) { return !residual.passed(); });
  const bool are_bones_others = std::any_of(
      report.residuals.begin(), report.residuals.end(),
      [](const Residual& residual) { return residual.group == kBonesGroup && !residual.passed(); });
  return text + "\n" +
         (are_bones_others ? "the bones are not those of the anatomy that was said: verify a model "
                             "with the --anatomy, --thorax, --stature\nand so on that it was "
                             "generated with\n"
                           : "") +
         (failed == 0   ? "all residuals within their tolerances"
          : failed == 1 ? "1 residual outside its tolerance"
                        : std::to_string(failed) + " residuals outside their tolerances") +
         "\n";
}

std::string ReportAsJson(const ResidualReport& report) {
  nlohmann::ordered_json json;
  json["model"] = report.model;
  json["kind"] = report.kind;
  json["rhythm"] = report.rhythm;
  json["mujoco"] = report.engine;
  json["passed"] = report.passed();
  json["residuals"] = nlohmann::ordered_json::array();
  for (const Residual& residual : report.residuals) {
    nlohmann::ordered_json line;
    line["group"] = residual.group;
    line["item"] = residual.item;
    line["value"] = residual.value;
    line["unit"] = residual.unit;
    line["tolerance"] = residual.tolerance ? nlohmann::ordered_json(*residual.tolerance) : nullptr;
    line["bound"] = Name(residual.bound);
    line["follows"] = residual.follows;
    line["passed"] = residual.passed();
    line["where"] = residual.where;
    json["residuals"].push_back(line);
  }
  return JsonText(json);
}

}  // namespace girdle
