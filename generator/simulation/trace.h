// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A simulation as a CSV table, one row a state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/shoulder_simulation.h"

namespace girdle {

/// Returns the header of an assembly's trace: `time_s`, the commands `elevation_deg plane_deg
/// axial_deg shrug_deg protraction_deg` as the model is given them, the direction followed,
/// `used_elevation_deg used_plane_deg`, `distance_deg` from measured data, the axial turn of the
/// command used, `used_axial_deg` counted from the rhythm's own and `used_axial_isb_deg`, ISB's
/// third angle, and its offsets, `used_shrug_deg used_protraction_deg`; nine `target_*_deg`, nine
/// `*_deg`, world quaternions `clavicle_qw ... humerus_qz`, world positions `IJ_x_m ...` of all
/// sites.
[[nodiscard]] std::string TraceHeader(Assembly assembly);

/// Returns the command [rad] nearest to `command`, a few units in the last place away at most, that
/// the degrees of a trace give back exactly: whoever drives a model from a trace repeats the run to
/// the last bit.
[[nodiscard]] ArmCommand ReplayableCommand(const ArmCommand& command) noexcept;

/// Returns about how many bytes so many rows below a header take, somewhat more rather than less.
[[nodiscard]] std::uintmax_t SizeOfRows(const std::string& header, std::uintmax_t rows) noexcept;

/// Appends one row, shortest decimals that read back exactly.
void AppendTraceRow(std::string& text, const ShoulderState& state);

/// The control signal of position servos as a CSV table: `time_s` and the targets of actuators by
/// their names, `_rad` or, of slides, `_m` behind them; and one row of it.
[[nodiscard]] std::string ControlsHeader(const std::vector<std::string>& actuators);
void AppendControlsRow(std::string& text, double time_s, const std::vector<double>& targets);

}  // namespace girdle
