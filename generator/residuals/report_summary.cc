// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/report_summary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "residuals/report_parts.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

// All residuals of one kind.
struct Kind {
  std::string group;
  const Residual* shown;    // the nearest to its tolerance; the first if none has a tolerance
  std::size_t checked = 0;  // how many have a tolerance
  std::size_t failed = 0;
};

// Returns the share of its tolerance that a residual takes: 1 at the tolerance, more beyond it.
double ShareOfTolerance(const Residual& residual) {
  if (!residual.tolerance) {
    return -1;
  }
  if (residual.value == 0 && *residual.tolerance == 0) {
    return residual.passed() ? 0 : std::numeric_limits<double>::infinity();
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
    kind.failed += residual.passed() ? 0 : 1;
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

std::string LimitText(const Residual& residual) {
  if (!residual.tolerance) {
    return "no limit";
  }
  return (residual.bound == Bound::kMoreThan ? "> " : "<= ") + ValueText(*residual.tolerance);
}

std::string CountsText(const Kind& kind) {
  return std::to_string(kind.checked) +
         (kind.failed > 0 ? ", " + std::to_string(kind.failed) + " FAIL" : "");
}

// Returns as much of the place of a residual as has room: "flexion 120.4/90", "120.4/90" or "".
std::string PlaceText(const Residual& residual, std::size_t room) {
  std::string place = ShortPlace(residual.where);
  if (place.size() <= room) {
    return place;
  }
  std::string direction = place == residual.where ? "" : place.substr(place.rfind(' ') + 1);
  return direction.size() <= room ? direction : "";
}

// The table with as much of each place as there is room for.
std::string TableOf(const std::vector<Kind>& kinds, const TextStyle& style) {
  const std::vector<Alignment> alignments = {Alignment::kLeft, Alignment::kRight, Alignment::kLeft};
  std::vector<std::vector<std::string>> rows = {{"kind", "worst", "required", "checked"}};
  for (const Kind& kind : kinds) {
    rows.push_back({kind.group, ValueText(kind.shown->value) + " " + kind.shown->unit,
                    LimitText(*kind.shown), CountsText(kind)});
  }
  const std::string title = "at elevation/plane";
  const std::size_t taken = WidestLine(ColumnsText(rows, alignments)) + kColumnGap;
  if (taken + title.size() <= style.width) {
    rows.front().push_back(title);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      rows[i + 1].push_back(PlaceText(*kinds[i].shown, style.width - taken));
    }
  }
  return ColumnsText(rows, alignments);
}

std::string FailureText(const Residual& residual, const TextStyle& style) {
  constexpr std::size_t kIndent = 5;
  const std::string text = "FAIL " + residual.group + ", " + residual.item + ": " +
                           ValueText(residual.value) + " " + residual.unit + ", must be " +
                           (residual.bound == Bound::kMoreThan ? "more than " : "at most ") +
                           ValueText(*residual.tolerance) + " " + residual.unit +
                           (residual.where.empty() ? "" : " (" + residual.where + ")");
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
  const std::string verdict = VerdictText(report, style);
  const auto stated = std::ranges::count_if(
      report.residuals, [](const Residual& residual) { return !residual.tolerance; });
  const std::string rest = stated == 0 ? ""
                           : stated == 1
                               ? " 1 value has no tolerance."
                               : " " + std::to_string(stated) + " values have no tolerance.";
  return {SubjectText(report, style.width) + "\n" + verdict + RemarkText(report, style),
          TableOf(KindsOf(report.residuals), style), FailuresOf(report, style),
          WrappedText("girdle verify --full shows every residual." + rest, style.width) + "\n" +
              verdict};
}

std::string SummaryAsText(const ResidualReport& report, const TextStyle& style) {
  const SummaryParts parts = SummaryPartsOf(report, style);
  return parts.head + "\n" + parts.table + "\n" + parts.failures +
         (parts.failures.empty() ? "" : "\n") + parts.end;
}

}  // namespace girdle
