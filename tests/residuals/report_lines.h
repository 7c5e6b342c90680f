// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The lines that the residual report has of each kind of model, and the models themselves.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "kinematics/words.h"
#include "mjcf/shoulder_model.h"
#include "residuals/residual.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle {

/// Kinds of models whose reports have different lines.
enum class ModelKind {
  kTree,
  kPublished,  ///< a tree with squad and closure table
  kLoop,       ///< the clavicle leads
  kScapulaLeads,
  kContact,  ///< a tree with thorax contact
  kLoopContact,
  kSmallContact,  ///< a tree with thorax contact, of a person of kSmallStature_m
};
inline constexpr std::array kModelKinds = {
    ModelKind::kTree,    ModelKind::kPublished,   ModelKind::kLoop,        ModelKind::kScapulaLeads,
    ModelKind::kContact, ModelKind::kLoopContact, ModelKind::kSmallContact};
inline constexpr std::array<std::string_view, kModelKinds.size()> kModelKindNames = {
    "Tree", "Published", "Loop", "LoopScapulaLeads", "Contact", "LoopContact", "SmallContact"};

inline constexpr double kSmallStature_m = 1.5;

constexpr const auto& WordsOf(ModelKind /*which*/) noexcept { return kModelKindNames; }
[[nodiscard]] inline bool IsLoop(ModelKind kind) {
  return kind == ModelKind::kLoop || kind == ModelKind::kScapulaLeads ||
         kind == ModelKind::kLoopContact;
}
[[nodiscard]] inline bool HasContact(ModelKind kind) {
  return kind == ModelKind::kContact || kind == ModelKind::kLoopContact ||
         kind == ModelKind::kSmallContact;
}
[[nodiscard]] inline Anatomy AnatomyOf(ModelKind kind) {
  return kind == ModelKind::kSmallContact
             ? ScaledAnatomy(BuiltInAnatomy(), {.stature_m = kSmallStature_m})
             : BuiltInAnatomy();
}

[[nodiscard]] inline ShoulderModelOptions ModelOptionsOf(ModelKind kind) {
  ShoulderModelOptions options;
  options.assembly = IsLoop(kind) ? Assembly::kLoop : Assembly::kTree;
  options.lead = kind == ModelKind::kScapulaLeads ? Lead::kScapula : Lead::kClavicle;
  options.has_thorax_contact = HasContact(kind);
  options.table = std::nullopt;
  return options;
}
[[nodiscard]] inline RhythmOptions RhythmOptionsOf(ModelKind kind) {
  return kind == ModelKind::kPublished
             ? RhythmOptions{Interpolation::kSquad, Closure::kTable, Range::kClamp}
             : RhythmOptions{};
}

/// How a line is judged.
struct ReportLine {
  std::string name;  ///< group and item
  std::string unit;
  std::string judged;  ///< "<= 1e-06", "> 8", "stated", "follows"

  bool operator==(const ReportLine&) const = default;
  [[nodiscard]] bool is_checked() const { return judged != "stated" && judged != "follows"; }
};

[[nodiscard]] std::string LineName(const Residual& residual);
[[nodiscard]] ReportLine LineOf(const Residual& residual);
[[nodiscard]] std::string TextOf(const std::vector<ReportLine>& lines);

/// On how hard the thorax pushes, of a kind with thorax contact.
inline constexpr const char* kContactStiffnessLine = "thorax contact: stiffness against the bones'";
/// Returns the lines of a kind of model, in their order. Those of a skin come after them.
[[nodiscard]] std::vector<ReportLine> LinesOf(ModelKind kind);

}  // namespace girdle
