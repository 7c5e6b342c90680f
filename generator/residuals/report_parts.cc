// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/report_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string_view>

#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

// A path that is too long without its beginning.
std::string EndOf(const std::string& path, std::size_t width) {
  constexpr std::string_view kCut = "...";
  if (path.size() <= width || width <= kCut.size()) {
    return path;
  }
  return std::string(kCut) + path.substr(path.size() - (width - kCut.size()));
}

std::string Verdict(const ResidualReport& report) {
  const auto checked = std::ranges::count_if(
      report.residuals, [](const Residual& residual) { return residual.tolerance.has_value(); });
  const auto failed = std::ranges::count_if(
      report.residuals, [](const Residual& residual) { return !residual.passed(); });
  if (failed == 0 && checked == 1) {
    return "PASS: 1 residual checked, within its tolerance";
  }
  if (failed == 0) {
    return "PASS: " + CountText(static_cast<std::uintmax_t>(checked), "residual") +
           " checked, all within their tolerances";
  }
  return "FAIL: " + std::to_string(failed) + " of " +
         CountText(static_cast<std::uintmax_t>(checked), "residual") + " outside " +
         (failed == 1 ? "its tolerance" : "their tolerances");
}

}  // namespace

std::string SubjectText(const ResidualReport& report, std::size_t width) {
  constexpr std::size_t kLabelWidth = 8;
  const auto line = [width](const char* label, const std::string& text) {
    return LabelledText(label, text, 0, kLabelWidth, width);
  };
  // Not wrapped, so that it can be copied.
  return AlignedLeft("model", kLabelWidth) +
         EndOf(report.model, width - std::min(width, kLabelWidth)) + "\n" +
         line("kind", report.kind) + line("rhythm", report.rhythm) +
         line("engine", "MuJoCo " + report.engine);
}

std::string VerdictText(const ResidualReport& report, const TextStyle& style) {
  return Coloured(WrappedText(Verdict(report), style.width),
                  report.passed() ? Colour::kGreen : Colour::kRed, style) +
         "\n";
}

std::string RemarkText(const ResidualReport& report, const TextStyle& style) {
  return report.remark.empty() ? "" : WrappedText(report.remark, style.width) + "\n";
}

std::string ValueText(double value) {
  constexpr int kDigits = 3;
  if (std::isnan(value)) {
    return "nan";
  }
  return std::isinf(value) ? (value > 0 ? "inf" : "-inf") : SignificantText(value, kDigits);
}

std::string ToleranceText(const Residual& residual) {
  if (!residual.tolerance) {
    return "-";
  }
  return (residual.bound == Bound::kMoreThan ? "> " : "") + ValueText(*residual.tolerance);
}

std::size_t WidestLine(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) {
    widest = std::max(widest, line.size());
  }
  return widest;
}

}  // namespace girdle
