// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A simulation as a CSV table with one row for each state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/shoulder_simulation.h"

namespace girdle {

/// Returns the header of an assembly's trace. Its columns are, in this order: `time_s`; the command
/// as the model receives it, `elevation_deg plane_deg axial_deg shrug_deg protraction_deg`; the
/// direction that was followed, `used_elevation_deg used_plane_deg`; `distance_deg` from measured
/// directions; the axial turn of the command used, `used_axial_deg` counted from the rhythm's own
/// and `used_axial_isb_deg` as ISB's third angle; its offsets, `used_shrug_deg
/// used_protraction_deg`; nine `target_*_deg`; nine `*_deg`; world quaternions `clavicle_qw ...
/// humerus_qz`; world positions `IJ_x_m ...` of all sites.
[[nodiscard]] std::string TraceHeader(Assembly assembly);

/// Returns the command [rad] nearest to `command` that the degrees of a trace give back exactly. It
/// differs by at most a few units in the last place. So a model that is driven from a trace repeats
/// the run to the last bit.
[[nodiscard]] ArmCommand ReplayableCommand(const ArmCommand& command) noexcept;

/// Returns the approximate size in bytes of so many rows under a header. The estimate is rather too
/// large than too small.
[[nodiscard]] std::uintmax_t SizeOfRows(const std::string& header, std::uintmax_t rows) noexcept;

/// Appends one row. Numbers are the shortest decimals that read back exactly.
void AppendTraceRow(std::string& text, const ShoulderState& state);

/// The control signal of position servos as a CSV table: the header, and one row. The header has
/// `time_s` and the names of the actuators with `_rad`, or with `_m` for slides.
[[nodiscard]] std::string ControlsHeader(const std::vector<std::string>& actuators);
void AppendControlsRow(std::string& text, double time_s, const std::vector<double>& targets);

}  // namespace girdle
