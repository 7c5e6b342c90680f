// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Elements of a model by the names that a person gave.
#pragma once

#include <mujoco/mujoco.h>

#include <cstddef>
#include <string>
#include <vector>

namespace girdle {

/// Returns up to `count` of `names` that are nearest to `wanted` in letters changed, added or left
/// out, nearest first; equally near ones as they stand.
[[nodiscard]] std::vector<std::string> NearestNames(const std::string& wanted,
                                                    const std::vector<std::string>& names,
                                                    std::size_t count);

/// Returns the id of a body, site, joint or actuator. Throws InputError at file and line, which
/// names the nearest ones of the model, if there is none.
[[nodiscard]] int FindElement(const mjModel& model, mjtObj type, const std::string& name,
                              const std::string& file, std::size_t line);

}  // namespace girdle
