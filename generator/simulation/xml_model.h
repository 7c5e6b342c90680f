// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A check of a model in XML (MJCF) before MuJoCo loads it.
#pragma once

#include <functional>
#include <string>

namespace girdle {

/// Throws InputError if loading the model at `path` would take more memory or time than there is
/// room for, or would crash. MuJoCo itself takes all memory of the machine if a size is large.
///
/// The numbers that MuJoCo multiplies with others are within limits: the message about one has its
/// file, line, element, attribute and value. Then a copy of this process calls `load`, which loads
/// the model, with at most 1 GB and 60 s, because repeated bodies, meshes and pictures may be large
/// too. Throws InputError also if `load` throws it there. Call this only while this process has one
/// thread.
void ExpectLoadableXml(const std::string& path, const std::function<void()>& load);

/// Most memory of the arena in which MuJoCo holds contacts and constraints of a model [bytes].
/// MuJoCo reserves all of it at once, and uses it when it is needed.
inline constexpr double kMostArena = 4.0 * (1 << 30);
inline constexpr const char* kMostArenaText = "4G";  ///< as an attribute

}  // namespace girdle
