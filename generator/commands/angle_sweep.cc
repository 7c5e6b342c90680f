// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/angle_sweep.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include "text/input_error.h"
#include "text/number_text.h"
#include "text/split.h"

namespace girdle {
namespace {

[[noreturn]] void Fail(const SweptAngle& angle, const std::string& text,
                       const std::string& reason) {
  throw InputError(std::string(angle.option) + " '" + text + "': " + reason);
}

double NumberOf(const SweptAngle& angle, const std::string& text, const std::string& part) {
  const std::optional<double> number = FiniteNumber(part);
  if (!number) {
    Fail(angle, text,
         "'" + part + "' is not a finite number. Give degrees such as " +
             std::string(angle.example));
  }
  return *number;
}

}  // namespace

bool IsSweep(const std::string& text) { return text.find(':') != std::string::npos; }

std::vector<double> SweepValues_deg(const SweptAngle& angle, const std::string& text,
                                    std::uint64_t most) {
  const std::vector<std::string> parts = Split(text, ":");
  if (parts.size() != 3) {
    Fail(angle, text, "expected FROM:TO:STEP in degrees, such as " + std::string(angle.example));
  }
  const double from_deg = NumberOf(angle, text, parts[0]);
  const double to_deg = NumberOf(angle, text, parts[1]);
  const double step_deg = NumberOf(angle, text, parts[2]);
  for (const double end_deg : {from_deg, to_deg}) {
    if (end_deg < angle.lower_deg || end_deg > angle.upper_deg) {
      Fail(angle, text,
           NumberText(end_deg) + " is outside " + NumberText(angle.lower_deg) + " to " +
               NumberText(angle.upper_deg) + " degrees" + std::string(angle.because) +
               ". Give ends within");
    }
  }
  if (to_deg < from_deg) {
    Fail(angle, text, "goes downwards. Give the smaller end first");
  }
  if (step_deg <= 0) {
    Fail(angle, text, "the step is " + NumberText(step_deg) + ". Give a positive one");
  }
  const double steps = (to_deg - from_deg) / step_deg;
  if (steps >= static_cast<double>(most)) {
    Fail(angle, text, "more than " + std::to_string(most) + " positions. Give a larger step");
  }
  // Largest rounding error, in steps: decimals such as 0.1 are not exact.
  constexpr double kWholeSteps = 1e-6;
  if (std::abs(steps - std::round(steps)) > kWholeSteps) {
    Fail(angle, text,
         "steps of " + NumberText(step_deg) + " from " + NumberText(from_deg) + " do not meet " +
             NumberText(to_deg) + ". End at " +
             NumberText(from_deg + std::floor(steps) * step_deg) + " or change the step");
  }
  const auto count = static_cast<std::size_t>(std::round(steps)) + 1;
  std::vector<double> values_deg;
  values_deg.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // Rounding gives the decimals as typed, so that values of the table are met exactly.
    constexpr int kDecimals = 9;
    const double value_deg = from_deg + static_cast<double>(i) * step_deg;
    values_deg.push_back(*FiniteNumber(RoundedText(value_deg, kDecimals)));
  }
  return values_deg;
}

}  // namespace girdle
