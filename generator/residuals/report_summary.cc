// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/report_summary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "residuals/residual_report.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

constexpr int kSummaryDigits = 3;

// All residuals of one kind.
struct Kind {
  std::string group;
  const Residual* shown;    // the nearest to its tolerance; the first if none has a tolerance
  std::size_t checked = 0;  // how many have a tolerance
};

// Returns the share of its tolerance that a residual takes: 1 at the tolerance, more beyond it.
double ShareOfTolerance(const Residual& residual) {
  if (!residual.tolerance) {
    return -1;
  }
  const double share = residual.bound == Bound::kAtMost ? residual.value / *residual.tolerance
                                                        : *residual.tolerance / residual.value;
  const bool is_number = !std::isnan(share);
  return is_number && (residual.passed() || share > 0) ? share
                                                       : std::numeric_limits<double>::infinity();
}

std::vector<Kind> KindsOf(const std::vector<Residual>& residuals) {
  std::vector<Kind> kinds;
  for (const Residual& residual : residuals) {
    const auto known = std::ranges::find(kinds, residual.group, &Kind::group);
    Kind& kind =
        known == kinds.end() ? kinds.emplace_back(Kind{residual.group, &residual}) : *known;
    kind.checked += residual.tolerance ? 1 : 0;
    if (ShareOfTolerance(residual) > ShareOfTolerance(*kind.shown)) {
      kind.shown = &residual;
    }
  }
  return kinds;
}

// Returns "flexion 120.4/90" for "flexion, elevation 120.4, plane 90".
std::string ShortPlace(const std::string& where) {
  const std::string elevation = "elevation ";
  const std::string plane = ", plane ";
  const std::size_t at_elevation = where.find(elevation);
  const std::size_t at_plane = where.find(plane);
  if (at_elevation == std::string::npos || at_plane == std::string::npos ||
      at_plane < at_elevation) {
    return where;
  }
  std::string before = where.substr(0, at_elevation);
  if (before.ends_with(", ")) {
    before.replace(before.size() - 2, 2, " ");
  }
  const std::size_t number = at_elevation + elevation.size();
  return before + where.substr(number, at_plane - number) + "/" +
         where.substr(at_plane + plane.size());
}

std::string ToleranceWithUnit(const Residual& residual) {
  if (!residual.tolerance) {
    return "none, " + residual.unit;
  }
  return (residual.bound == Bound::kMoreThan ? "> " : "") +
         SignificantText(*residual.tolerance, kSummaryDigits) + " " + residual.unit;
}

std::string Cut(const std::string& line, std::size_t width) {
  constexpr const char* kCut = "...";
  return line.size() <= width ? line
                              : line.substr(0, width - std::min<std::size_t>(width, 3)) + kCut;
}

std::string TableOf(const std::vector<Kind>& kinds, const TextStyle& style) {
  std::vector<std::vector<std::string>> rows = {
      {"kind", "worst", "tolerance", "checked", "worst at elevation/plane"}};
  for (const Kind& kind : kinds) {
    rows.push_back({kind.group, SignificantText(kind.shown->value, kSummaryDigits),
                    ToleranceWithUnit(*kind.shown), std::to_string(kind.checked),
                    ShortPlace(kind.shown->where)});
  }
  const std::string table = ColumnsText(
      rows,
      {Alignment::kLeft, Alignment::kRight, Alignment::kLeft, Alignment::kRight, Alignment::kLeft});
  std::string text;
  std::size_t from = 0;
  for (std::size_t end = table.find('\n'); end != std::string::npos; end = table.find('\n', from)) {
    text += Cut(table.substr(from, end - from), style.width) + "\n";
    from = end + 1;
  }
  return text;
}

std::string FailureText(const Residual& residual, const TextStyle& style) {
  const std::string value =
      std::isfinite(residual.value)
          ? SignificantText(residual.value, kSummaryDigits) + " " + residual.unit
          : "not a number";
  const std::string text =
      "FAIL  " + residual.group + ", " + residual.item + ": " + value +
      (residual.bound == Bound::kMoreThan ? ", must be more than " : ", must be at most ") +
      SignificantText(*residual.tolerance, kSummaryDigits) + " " + residual.unit +
      (residual.where.empty() ? "" : " (" + residual.where + ")");
  constexpr std::size_t kIndent = 6;
  return Coloured(WrappedText(text, style.width, kIndent), Colour::kRed, style) + "\n";
}

std::string FailuresOf(const ResidualReport& report, const TextStyle& style) {
  std::string text;
  for (const Residual& residual : report.residuals) {
    text += residual.passed() ? "" : FailureText(residual, style);
  }
  return text;
}

}  // namespace

SummaryParts SummaryPartsOf(const ResidualReport& report, const TextStyle& style) {
  const std::string verdict =
      Coloured(VerdictText(report), report.passed() ? Colour::kGreen : Colour::kRed, style) + "\n";
  const auto stated = std::ranges::count_if(
      report.residuals, [](const Residual& residual) { return !residual.tolerance; });
  const std::string rest =
      stated == 0 ? "" : " " + std::to_string(stated) + " values have no tolerance.";
  return {SubjectText(report, style.width) + "\n" + verdict,
          TableOf(KindsOf(report.residuals), style), FailuresOf(report, style),
          (report.remark.empty() ? "" : WrappedText(report.remark, style.width) + "\n") +
              WrappedText("girdle verify --full shows every residual." + rest, style.width) + "\n" +
              verdict};
}

std::string SummaryAsText(const ResidualReport& report, const TextStyle& style) {
  const SummaryParts parts = SummaryPartsOf(report, style);
  return parts.head + "\n" + parts.table + "\n" + parts.failures +
         (parts.failures.empty() ? "" : "\n") + parts.end;
}

}  // namespace girdle
