// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Elements of a model, found by names that a person wrote.
#pragma once

#include <mujoco/mujoco.h>

#include <cstddef>
#include <string>
#include <vector>

namespace girdle {

/// Returns up to `count` of `names` that are most similar to `wanted`, the most similar first. The
/// measure is the number of letters that are changed, added or left out. Equally similar names keep
/// their order.
[[nodiscard]] std::vector<std::string> NearestNames(const std::string& wanted,
                                                    const std::vector<std::string>& names,
                                                    std::size_t count);

/// Returns the names of all bodies but the world, or of all sites, joints or actuators, in the
/// order of their ids; nothing for another type. Elements without a name are left out.
[[nodiscard]] std::vector<std::string> ElementNames(const mjModel& model, mjtObj type);

/// Returns the id of a body, site, joint or actuator. Throws InputError at file and line if it does
/// not exist. The message names the most similar elements of the model.
[[nodiscard]] int FindElement(const mjModel& model, mjtObj type, const std::string& name,
                              const std::string& file, std::size_t line);

}  // namespace girdle
