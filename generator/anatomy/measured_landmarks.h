// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The rows of a file of one person's landmarks, stored by landmark and by the segment whose frame
/// they are in.
#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/landmark_places.h"
#include "text/csv.h"

namespace girdle {

/// Returns the segment in whose frame a landmark is given.
[[nodiscard]] constexpr Segment SegmentOf(Landmark landmark) noexcept {
  return DefinitionOf(landmark).segment;
}

/// Returns the segment that has its origin in a landmark, or nothing if there is none.
[[nodiscard]] std::optional<Segment> SegmentFrom(Landmark origin) noexcept;

/// Returns a length for messages, in whole millimeters.
[[nodiscard]] std::string MillimeterText(double length_m);

class MeasuredLandmarks {
 public:
  /// Reads the rows (person_landmarks.h). Throws InputError, with file and line, for an unknown,
  /// missing or repeated landmark, and for a landmark in the frame of another segment.
  MeasuredLandmarks(std::istream& in, const std::string& name);

  /// Whether all landmarks are in the laboratory's frame.
  [[nodiscard]] bool is_lab() const noexcept { return is_lab_; }

  /// Returns whether a landmark is known.
  [[nodiscard]] bool Has(Landmark landmark) const;

  /// Returns the position [m] in the frame that the file uses for `segment`, or in the laboratory's
  /// frame.
  [[nodiscard]] Vector3 In_m(Segment segment, Landmark landmark) const;

  /// Returns all known landmarks, in the frames that the file uses.
  [[nodiscard]] PlacedLandmarks Places() const;

  /// Points of the humeral head [m], in the laboratory's frame.
  [[nodiscard]] const std::vector<Vector3>& head_points_m() const noexcept {
    return head_points_m_;
  }

  /// Adds GH [m], which has no row. It is in the frame that the file uses for the scapula, or in
  /// the laboratory's frame.
  void AddGh(const Vector3& gh_m);

  /// Returns the file's name for a landmark. PAC may be AC there.
  [[nodiscard]] std::string NameIn(Landmark landmark) const;

  /// Returns the line of a landmark's row, in the frame of its own segment or in the laboratory's
  /// frame.
  [[nodiscard]] std::size_t LineOf(Landmark landmark) const;

  /// Throws InputError at the row of a landmark, in the frame of `segment` if there is such a row.
  /// GH without a row counts as the last row.
  [[noreturn]] void Fail(Segment segment, Landmark landmark, const std::string& message) const;
  /// Throws InputError at the last row of a point of the humeral head.
  [[noreturn]] void FailAtHead(const std::string& message) const;

 private:
  // A row of the file: one landmark in one segment's frame.
  struct Row {
    Vector3 position_m{0, 0, 0};
    std::size_t line_number = 0;  // 0 if there is no row
  };

  [[nodiscard]] const Row& RowIn(Segment segment, Landmark landmark) const;
  [[nodiscard]] Row& RowIn(Segment segment, Landmark landmark);
  [[nodiscard]] Landmark KnownLandmark(std::string_view name) const;
  void TakeFrame(std::string_view name, std::optional<Landmark> landmark, std::string_view frame);
  void TakeHeadPoint(std::string_view name, const Vector3& position_m);
  void ExpectAll() const;
  void ExpectOneGh() const;

  CsvReader csv_;
  bool has_rows_ = false;
  bool is_lab_ = false;
  bool says_ac_ = false;
  bool has_added_gh_ = false;
  std::array<std::array<Row, kLandmarkCount>, kSegmentCount> rows_{};
  std::vector<Vector3> head_points_m_;
  std::vector<std::string> head_names_;
  std::size_t head_line_number_ = 0;
};

}  // namespace girdle
