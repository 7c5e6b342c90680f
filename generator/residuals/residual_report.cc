// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/residual_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "residuals/report_parts.h"
#include "residuals/report_summary.h"
#include "text/json_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

std::string ResultText(const Residual& residual) {
  return residual.follows      ? "follows"
         : !residual.tolerance ? "stated"
         : residual.passed()   ? "pass"
                               : "FAIL";
}

constexpr Alignment kWords = Alignment::kLeft;
constexpr Alignment kNumbers = Alignment::kRight;

std::string WideTable(const ResidualReport& report) {
  std::vector<std::vector<std::string>> rows = {
      {"residual", "of", "value", "tolerance", "unit", "result", "where"}};
  for (const Residual& residual : report.residuals) {
    rows.push_back({residual.group, residual.item, ValueText(residual.value),
                    ToleranceText(residual), residual.unit, ResultText(residual), residual.where});
  }
  return ColumnsText(rows, {kWords, kWords, kNumbers, kNumbers, kWords});
}

// The table without the columns of the kind, which becomes a heading, and of the pose.
std::string NarrowTable(const ResidualReport& report, const TextStyle& style) {
  constexpr std::size_t kIndent = 2;
  std::vector<std::vector<std::string>> rows;
  rows.reserve(report.residuals.size());
  for (const Residual& residual : report.residuals) {
    rows.push_back(
        {ValueText(residual.value), ToleranceText(residual), residual.unit, ResultText(residual)});
  }
  std::istringstream numbers(ColumnsText(rows, {kNumbers, kNumbers, kWords}));
  const std::size_t numbers_width = WidestLine(numbers.str());
  const std::size_t item_width = style.width - std::min(style.width, numbers_width + kIndent);
  std::string text;
  std::string group;
  for (const Residual& residual : report.residuals) {
    if (residual.group != group) {
      group = residual.group;
      text += group + "\n";
    }
    std::string line;
    std::getline(numbers, line);
    const std::string item = std::string(kIndent, ' ') + residual.item;
    text += item.size() < item_width ? AlignedLeft(item, item_width)
                                     : item + "\n" + std::string(item_width, ' ');
    text += "  " + line + "\n";
    if (!residual.where.empty()) {
      text += LabelledText("", residual.where, 0, 3 * kIndent, style.width);
    }
  }
  return text;
}

}  // namespace

std::string ReportAsText(const ResidualReport& report, const TextStyle& style) {
  const std::string wide = WideTable(report);
  return SubjectText(report, style.width) + "\n" +
         (WidestLine(wide) <= style.width ? wide : NarrowTable(report, style)) + "\n" +
         RemarkText(report, style) + VerdictText(report, style);
}

std::string ReportIn(const ReportChoice& choice, const ResidualReport& report) {
  switch (choice.form) {
    case ReportForm::kSummary:
      return SummaryAsText(report, choice.style);
    case ReportForm::kFull:
      return ReportAsText(report, choice.style);
    case ReportForm::kJson:
      break;
  }
  return ReportAsJson(report);
}

std::string ReportAsJson(const ResidualReport& report) {
  nlohmann::ordered_json json;
  json["model"] = report.model;
  json["kind"] = report.kind;
  json["rhythm"] = report.rhythm;
  json["mujoco"] = report.engine;
  json["passed"] = report.passed();
  json["remark"] = report.remark;
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
