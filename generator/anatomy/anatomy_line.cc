// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/anatomy_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "kinematics/assembly.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/split.h"

namespace girdle {
namespace {

constexpr std::string_view kBetweenRows = "; ";

// A row of the line: its name, and the numbers of the anatomy that it holds. `AnyAnatomy` is
// Anatomy or const Anatomy.
template <typename AnyAnatomy>
struct Row {
  using Number = std::conditional_t<std::is_const_v<AnyAnatomy>, const double, double>;
  std::string name;
  std::vector<Number*> numbers;
};

// Returns the rows of an anatomy in their order.
template <typename AnyAnatomy>
std::vector<Row<AnyAnatomy>> RowsOf(AnyAnatomy& anatomy) {
  using Number = typename Row<AnyAnatomy>::Number;
  std::vector<Row<AnyAnatomy>> rows;
  const auto add = [&rows](std::string_view name, std::vector<Number*> numbers) {
    rows.push_back({std::string(name), std::move(numbers)});
  };
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    auto& p_m = anatomy.landmarks_m[i];
    add(kLandmarks[i].name, {&p_m.x, &p_m.y, &p_m.z});
  }
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    auto& segment = anatomy.segments[i];
    auto& c_m = segment.center_of_mass_m;
    auto& inertia = segment.inertia_kg_m2;
    add(kSegmentNames[i],
        {&segment.mass_kg, &c_m.x, &c_m.y, &c_m.z, &inertia.x, &inertia.y, &inertia.z});
  }
  for (std::size_t i = 0; i < kCoordinateCount; ++i) {
    add(kCoordinateNames[i], {&anatomy.ranges[i].lower_rad, &anatomy.ranges[i].upper_rad});
  }
  for (std::size_t i = 0; i < kScapulothoracicNames.size(); ++i) {
    auto& range = anatomy.scapulothoracic_ranges[i];
    add(kScapulothoracicNames[i], {&range.lower_rad, &range.upper_rad});
  }
  const auto add_ellipsoid = [&add](std::string_view name, auto& ellipsoid) {
    auto& c_m = ellipsoid.center_m;
    auto& r_m = ellipsoid.radii_m;
    add(name, {&c_m.x, &c_m.y, &c_m.z, &r_m.x, &r_m.y, &r_m.z});
  };
  add_ellipsoid("ribcage", anatomy.ribcage);
  add_ellipsoid("gliding", anatomy.gliding);
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    auto& ligament = anatomy.ligaments[i];
    auto& clavicle_m = ligament.clavicle_m;
    auto& scapula_m = ligament.scapula_m;
    add(kLigamentNames[i],
        {&clavicle_m.x, &clavicle_m.y, &clavicle_m.z, &scapula_m.x, &scapula_m.y, &scapula_m.z,
         &ligament.slack_m, &ligament.stiffness_N_per_m, &ligament.failure_elongation_m,
         &ligament.published_m, &ligament.published_sd_m});
  }
  add("jugular_notch_height", {&anatomy.jugular_notch_height_m});
  return rows;
}

constexpr std::string_view kProportionsName = "adult_proportions";

// Returns the numbers of a row with this name and this many numbers; nothing for any other row.
std::optional<std::vector<double>> NumbersOf(const std::string& row, const std::string& name,
                                             std::size_t count) {
  const std::vector<std::string> words = Split(row, " ");
  if (words.size() != count + 1 || words.front() != name) {
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::optional<double> number = FiniteNumber(words[i]);
    if (!number) {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return numbers;
}

constexpr const char* kRemedy = "Generate the model again with girdle generate";

bool IsPositive(const Vector3& v) noexcept { return v.x > 0 && v.y > 0 && v.z > 0; }

// Throws InputError if no body can be so.
void ExpectPossible(const Anatomy& anatomy, const std::string& place) {
  const auto expect = [&place](bool is_possible, std::string_view what) {
    if (!is_possible) {
      throw InputError(place + ": " + std::string(what) + " cannot be. " + kRemedy);
    }
  };
  constexpr double kFarthest_m = 10;
  const auto is_near = [](const Vector3& p_m) { return glm::length(p_m) <= kFarthest_m; };
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    expect(is_near(anatomy.landmarks_m[i]), kLandmarks[i].name);
  }
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const SegmentInertia& segment = anatomy.segments[i];
    expect(segment.mass_kg > 0 && IsPositive(segment.inertia_kg_m2) &&
               is_near(segment.center_of_mass_m),
           kSegmentNames[i]);
  }
  for (const auto& [name, ellipsoid] :
       {std::pair("ribcage", anatomy.ribcage), std::pair("gliding", anatomy.gliding)}) {
    expect(
        IsPositive(ellipsoid.radii_m) && is_near(ellipsoid.radii_m) && is_near(ellipsoid.center_m),
        name);
  }
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    const Ligament& ligament = anatomy.ligaments[i];
    expect(ligament.slack_m > 0 && ligament.slack_m <= kFarthest_m &&
               ligament.stiffness_N_per_m > 0 && is_near(ligament.clavicle_m) &&
               is_near(ligament.scapula_m),
           kLigamentNames[i]);
  }
  expect(anatomy.jugular_notch_height_m > 0 && anatomy.jugular_notch_height_m <= kFarthest_m,
         "jugular_notch_height");
}

}  // namespace

std::string AnatomyAsLine(const Anatomy& anatomy) {
  std::string line;
  for (const Row<const Anatomy>& row : RowsOf(anatomy)) {
    line += row.name;
    for (const double* const number : row.numbers) {
      line += ' ';
      AppendNumber(line, *number);
    }
    line += kBetweenRows;
  }
  return line + std::string(kProportionsName) + (anatomy.has_adult_proportions ? " 1" : " 0");
}

Anatomy AnatomyFromLine(const std::string& line, const std::string& place) {
  constexpr std::size_t kLongestLine = 20'000;
  if (line.size() > kLongestLine) {
    throw InputError(place + ": is longer than any anatomy. " + kRemedy);
  }
  const auto fail = [&place](const std::string& name, std::size_t count) {
    throw InputError(place + ": expected " + name + " with " + CountText(count, "number") + ". " +
                     kRemedy);
  };
  Anatomy anatomy;
  const std::vector<Row<Anatomy>> rows = RowsOf(anatomy);
  const std::vector<std::string> texts = Split(line, kBetweenRows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t count = rows[i].numbers.size();
    const auto numbers = i < texts.size() ? NumbersOf(texts[i], rows[i].name, count) : std::nullopt;
    if (!numbers) {
      fail(rows[i].name, count);
    }
    for (std::size_t k = 0; k < count; ++k) {
      *rows[i].numbers[k] = (*numbers)[k];
    }
  }
  const auto adult = texts.size() == rows.size() + 1
                         ? NumbersOf(texts.back(), std::string(kProportionsName), 1)
                         : std::nullopt;
  if (!adult) {
    fail(std::string(kProportionsName), 1);
  }
  anatomy.has_adult_proportions = adult->front() != 0;
  ExpectPossible(anatomy, place);
  return anatomy;
}

bool IsSame(const Anatomy& a, const Anatomy& b) {
  constexpr double kRounding = 1e-9;
  const auto rows_a = RowsOf(a);
  const auto rows_b = RowsOf(b);
  for (std::size_t i = 0; i < rows_a.size(); ++i) {
    for (std::size_t k = 0; k < rows_a[i].numbers.size(); ++k) {
      const double number = *rows_a[i].numbers[k];
      if (!(std::abs(number - *rows_b[i].numbers[k]) <=
            kRounding * std::max(1.0, std::abs(number)))) {
        return false;
      }
    }
  }
  return a.has_adult_proportions == b.has_adult_proportions;
}

}  // namespace girdle
