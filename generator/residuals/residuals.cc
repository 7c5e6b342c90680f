// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/residuals.h"

#include <algorithm>
#include <string>
#include <utility>

#include "names/model_names.h"
#include "residuals/residual_groups.h"
#include "residuals/visits.h"
#include "simulation/model_skin.h"
#include "text/input_error.h"

namespace girdle {
namespace {

std::vector<Residual> MeasureShoulder(ShoulderSimulation& simulation, const AssembledRhythm& rhythm,
                                      const Anatomy& anatomy, GirdleMotion girdle,
                                      const ProgressSink& progress) {
  const MeasuredShoulder shoulder{simulation, rhythm, anatomy};
  const std::vector<ResidualGroupPointer> groups = MakeResidualGroups(simulation, shoulder, girdle);
  ShowVisits(simulation, shoulder, groups, progress);
  std::vector<Residual> lines;
  for (const ResidualGroupPointer& group : groups) {
    group->AddLines(lines);
  }
  return lines;
}

}  // namespace

bool ResidualReport::passed() const noexcept {
  return std::all_of(residuals.begin(), residuals.end(),
                     [](const Residual& residual) { return residual.passed(); });
}

ResidualReport MeasureResiduals(ShoulderSimulation& simulation, const AssembledRhythm& rhythm,
                                const Anatomy& anatomy, const ProgressSink& progress,
                                GirdleMotion girdle) {
  if (girdle == GirdleMotion::kFrozen && !HasSkin(simulation.model())) {
    throw InputError(simulation.name() +
                     ": has no skin, on which alone a frozen girdle is measured. Make a model that "
                     "has one with girdle generate --skin");
  }
  ResidualReport report{simulation.name(), "", "", mj_versionString(), "", {}};
  const std::size_t sides = simulation.shoulders().size();
  for (std::size_t i = 0; i < sides; ++i) {
    const Side side = simulation.shoulders()[i].side;
    simulation.Watch(side);
    std::vector<Residual> lines =
        MeasureShoulder(simulation, rhythm, anatomy, girdle, [&progress, i, sides](double done) {
          progress((static_cast<double>(i) + done) / static_cast<double>(sides));
        });
    for (Residual& line : lines) {
      if (sides > 1) {
        line.item += ", " + std::string(Name(side));
      }
      report.residuals.push_back(std::move(line));
    }
  }
  return report;
}

}  // namespace girdle
