// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The reason why a text is not the JSON that it should be.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace girdle {

/// Returns the reason of an exception that nlohmann's JSON threw, as a short text: the library
/// repeats a word that it does not understand, however long it is.
[[nodiscard]] std::string JsonFault(const nlohmann::json::exception& error);

}  // namespace girdle
