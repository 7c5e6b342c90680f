// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The verb `render`: a picture of a model in a pose.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

void AddRenderCommand(CLI::App& program);

}  // namespace girdle
