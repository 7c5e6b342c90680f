// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/measured_landmarks.h"

#include <algorithm>
#include <iterator>

#include "anatomy/person_landmarks.h"
#include "kinematics/lengths.h"
#include "text/input_error.h"
#include "text/near_names.h"
#include "text/number_text.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

// A landmark that belongs to two segments, because one hangs from the other.
struct BoneOrigin {
  Landmark landmark;
  Segment segment;  // the segment whose origin it is
};
constexpr BoneOrigin kOrigins[] = {{Landmark::kSC, Segment::kClavicle},
                                   {Landmark::kPAC, Segment::kScapula},
                                   {Landmark::kGH, Segment::kHumerus}};
constexpr Landmark kOptional[] = {Landmark::kACJ, Landmark::kGC, Landmark::kGH};

// ISB's name of PAC.
constexpr std::string_view kAc = "AC";
// Points of the humeral head are called HH1, HH2 and so on.
constexpr std::string_view kHead = "HH";

// Returns the landmark of a row; the name AC means PAC.
std::optional<Landmark> LandmarkOfRow(std::string_view name) {
  return name == kAc ? Landmark::kPAC : FromName<Landmark>(name);
}

bool IsHeadPoint(std::string_view name) {
  return name.size() > kHead.size() && name.substr(0, kHead.size()) == kHead &&
         std::all_of(name.begin() + kHead.size(), name.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::optional<Segment> SegmentFrom(Landmark origin) noexcept {
  for (const BoneOrigin& known : kOrigins) {
    if (known.landmark == origin) {
      return known.segment;
    }
  }
  return std::nullopt;
}

std::string MillimeterText(double length_m) {
  return RoundedText(kMillimetersPerMeter * length_m, 0) + " mm";
}

MeasuredLandmarks::MeasuredLandmarks(std::istream& in, const std::string& name) : csv_(in, name) {
  csv_.ExpectOnlyColumns({"landmark", "segment", "x_m", "y_m", "z_m"});
  const std::size_t landmark_column = csv_.Column("landmark");
  const std::size_t segment_column = csv_.Column("segment");
  const std::size_t columns[] = {csv_.Column("x_m"), csv_.Column("y_m"), csv_.Column("z_m")};
  while (csv_.Next()) {
    const std::string row_name(csv_.Field(landmark_column));
    const std::optional<Landmark> landmark =
        IsHeadPoint(row_name) ? std::nullopt : std::optional(KnownLandmark(row_name));
    const std::string frame(csv_.Field(segment_column));
    TakeFrame(row_name, landmark, frame);
    const Vector3 position_m{csv_.Number(columns[0]), csv_.Number(columns[1]),
                             csv_.Number(columns[2])};
    if (!landmark) {
      TakeHeadPoint(row_name, position_m);
      continue;
    }
    Row& row = RowIn(is_lab_ ? SegmentOf(*landmark) : FromName<Segment>(frame).value(), *landmark);
    if (row.line_number != 0) {
      csv_.Fail("'" + row_name + "' stands in line " + std::to_string(row.line_number) +
                " already" + (landmark == Landmark::kPAC ? ", AC and PAC being the same" : "") +
                ". Remove one of the rows; a file holds landmarks of one side");
    }
    row = {position_m, csv_.line_number()};
    says_ac_ = says_ac_ || row_name == kAc;
  }
  ExpectAll();
  ExpectOneGh();
}

bool MeasuredLandmarks::Has(Landmark landmark) const {
  return RowIn(SegmentOf(landmark), landmark).line_number != 0 ||
         (landmark == Landmark::kGH && has_added_gh_);
}

Vector3 MeasuredLandmarks::In_m(Segment segment, Landmark landmark) const {
  return RowIn(is_lab_ ? SegmentOf(landmark) : segment, landmark).position_m;
}

PlacedLandmarks MeasuredLandmarks::Places() const {
  PlacedLandmarks places;
  const auto put = [&](Segment segment, Landmark landmark) {
    const bool has_row = RowIn(is_lab_ ? SegmentOf(landmark) : segment, landmark).line_number != 0;
    places[static_cast<std::size_t>(segment)][static_cast<std::size_t>(landmark)] =
        PlacedLandmark{In_m(segment, landmark), has_row};
  };
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    if (Has(landmark)) {
      put(SegmentOf(landmark), landmark);
    }
  }
  for (const BoneOrigin& origin : kOrigins) {
    if (!is_lab_ || Has(origin.landmark)) {
      put(origin.segment, origin.landmark);
    }
  }
  return places;
}

void MeasuredLandmarks::AddGh(const Vector3& gh_m) {
  RowIn(Segment::kScapula, Landmark::kGH).position_m = gh_m;
  has_added_gh_ = true;
}

std::string MeasuredLandmarks::NameIn(Landmark landmark) const {
  return std::string(landmark == Landmark::kPAC && says_ac_ ? kAc : Name(landmark));
}

std::size_t MeasuredLandmarks::LineOf(Landmark landmark) const {
  return RowIn(SegmentOf(landmark), landmark).line_number;
}

void MeasuredLandmarks::Fail(Segment segment, Landmark landmark, const std::string& message) const {
  std::size_t line_number = RowIn(segment, landmark).line_number;
  if (line_number == 0) {
    line_number = RowIn(SegmentOf(landmark), landmark).line_number;
  }
  throw InputError(csv_.name(), line_number != 0 ? line_number : csv_.line_number(), message);
}

void MeasuredLandmarks::FailAtHead(const std::string& message) const {
  std::string names;
  for (std::size_t i = 0; i < head_names_.size(); ++i) {
    names += (i == 0 ? "" : " ") + head_names_[i];
  }
  throw InputError(csv_.name(), head_line_number_, names + ": " + message);
}

const MeasuredLandmarks::Row& MeasuredLandmarks::RowIn(Segment segment, Landmark landmark) const {
  return rows_[static_cast<std::size_t>(segment)][static_cast<std::size_t>(landmark)];
}

MeasuredLandmarks::Row& MeasuredLandmarks::RowIn(Segment segment, Landmark landmark) {
  return rows_[static_cast<std::size_t>(segment)][static_cast<std::size_t>(landmark)];
}

Landmark MeasuredLandmarks::KnownLandmark(std::string_view name) const {
  const std::optional<Landmark> landmark = LandmarkOfRow(name);
  if (!landmark) {
    std::string known;
    for (const LandmarkDefinition& definition : kLandmarks) {
      known += (known.empty() ? "" : " ") + std::string(definition.name);
    }
    csv_.Fail("'" + ShortText(name) + "' is not a landmark. " + DidYouMean(name, kLandmarkNames) +
              "Known are " + known +
              ", AC for PAC, and HH1 HH2 ... for points of the humeral head");
  }
  return *landmark;
}

// Throws unless a landmark, or a point of the humeral head, may be given in this frame. Throws too
// if it is given in another kind of frame than the rows before.
void MeasuredLandmarks::TakeFrame(std::string_view name, std::optional<Landmark> landmark,
                                  std::string_view frame) {
  const std::string shown = landmark ? std::string(Name(*landmark)) : std::string(name);
  const bool is_lab = frame == kLaboratory;
  if (!has_rows_) {
    is_lab_ = is_lab;
    has_rows_ = true;
  }
  if (is_lab != is_lab_) {
    csv_.Fail(shown + " is given in the frame '" + ShortText(frame) + "', the rows above " +
              (is_lab_ ? "in the laboratory's" : "each in that of its segment") +
              ". Give all landmarks in '" + std::string(kLaboratory) +
              "', or each in the frame of its segment");
  }
  if (is_lab) {
    return;
  }
  if (!landmark) {
    csv_.Fail(shown + " is given in the frame '" + ShortText(frame) +
              "': points of the humeral head serve where all landmarks stand in '" +
              std::string(kLaboratory) + "'. Give GH in the scapula's frame instead");
  }
  const std::string_view own = Name(SegmentOf(*landmark));
  const std::optional<Segment> child = SegmentFrom(*landmark);
  if (frame == own || (child && frame == Name(*child))) {
    return;
  }
  csv_.Fail(shown + " is given in the frame '" + ShortText(frame) + "', expected '" +
            std::string(own) + "'" +
            (child ? " (or '" + std::string(Name(*child)) + "', whose origin it is)" : "") +
            ", or '" + std::string(kLaboratory) + "' in every row");
}

void MeasuredLandmarks::TakeHeadPoint(std::string_view name, const Vector3& position_m) {
  if (std::find(head_names_.begin(), head_names_.end(), name) != head_names_.end()) {
    csv_.Fail("'" + std::string(name) + "' is given twice. Number the points of the humeral head");
  }
  head_names_.emplace_back(name);
  head_points_m_.push_back(position_m);
  head_line_number_ = csv_.line_number();
}

void MeasuredLandmarks::ExpectAll() const {
  std::string missing;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    const bool is_optional =
        std::find(std::begin(kOptional), std::end(kOptional), landmark) != std::end(kOptional);
    if (!is_optional && !Has(landmark)) {
      missing += (missing.empty() ? "" : ", ") + std::string(Name(landmark)) +
                 (landmark == Landmark::kPAC ? " (or AC)" : "") +
                 (is_lab_ ? "" : " in the frame '" + std::string(Name(SegmentOf(landmark))) + "'");
    }
  }
  if (!missing.empty()) {
    csv_.Fail("no row for " + missing + ". Add it; only ACJ, GC and GH may be left out");
  }
}

void MeasuredLandmarks::ExpectOneGh() const {
  if (Has(Landmark::kGH) && !head_points_m_.empty()) {
    FailAtHead("the sphere through these gives GH, which stands in line " +
               std::to_string(RowIn(Segment::kScapula, Landmark::kGH).line_number) +
               " already. Remove that row or these");
  }
}

}  // namespace girdle
