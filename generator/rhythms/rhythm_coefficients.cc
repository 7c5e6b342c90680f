// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythms/rhythm_coefficients.h"

#include <algorithm>
#include <sstream>

#include "kinematics/rotation.h"
#include "rhythms/built_in_files.h"
#include "text/csv.h"
#include "text/near_names.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

// No bone of the girdle rotates faster than the arm that moves it.
constexpr double kLargestFactor = 1;

}  // namespace

RhythmCoefficients ReadRhythmCoefficients(std::istream& in, const std::string& name) {
  CsvReader csv(in, name);
  csv.ExpectOnlyColumns(
      {"rhythm", "angle", "rest_deg", "rest_factor", "constant_deg", "per_elevation", "per_plane"});
  const std::size_t rhythm = csv.Column("rhythm");
  const std::size_t angle = csv.Column("angle");
  const std::size_t rest = csv.Column("rest_deg");
  const std::size_t rest_factor = csv.Column("rest_factor");
  const std::size_t constant = csv.Column("constant_deg");
  const std::size_t per_elevation = csv.Column("per_elevation");
  const std::size_t per_plane = csv.Column("per_plane");
  const auto angle_rad = [&csv](std::size_t column) {
    return RadiansFromDegrees(csv.NumberWithin(column, -kHalfCircle_deg, kHalfCircle_deg));
  };
  const auto factor = [&csv](std::size_t column) {
    return csv.NumberWithin(column, -kLargestFactor, kLargestFactor);
  };
  RhythmCoefficients coefficients;
  while (csv.Next()) {
    const auto known =
        std::find(kGirdleAngleNames.begin(), kGirdleAngleNames.end(), csv.Field(angle));
    if (known == kGirdleAngleNames.end()) {
      csv.Fail("angle '" + ShortText(csv.Field(angle)) + "' is not known. " +
               DidYouMean(csv.Field(angle), kGirdleAngleNames) + "Correct the name");
    }
    std::optional<LinearAngle>& place =
        coefficients[std::string(csv.Field(rhythm))]
                    [static_cast<std::size_t>(known - kGirdleAngleNames.begin())];
    if (place) {
      csv.Fail(std::string(*known) + " of " + ShortText(csv.Field(rhythm)) +
               " is given twice. Remove one of the rows");
    }
    place = LinearAngle{angle_rad(rest), factor(rest_factor), angle_rad(constant),
                        factor(per_elevation), factor(per_plane)};
  }
  return coefficients;
}

RhythmCoefficients BuiltInRhythmCoefficients() {
  std::istringstream in{std::string(built_in_files::kPublishedRhythms)};
  return ReadRhythmCoefficients(in, "data/published_rhythms.csv");
}

}  // namespace girdle
