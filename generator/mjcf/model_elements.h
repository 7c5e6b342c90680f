// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Walks through the XML of a model and of the files that it includes or attaches.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace tinyxml2 {
class XMLElement;
}

namespace girdle {

/// Receives an element and the file that it is in.
using ElementVisitor =
    std::function<void(const tinyxml2::XMLElement& element, const std::filesystem::path& file)>;

/// Calls `visit` for each element of the MJCF file `model`, in their order, and for those of the
/// files that it includes or attaches. Each file is read once. An included file is looked for in
/// the folder of the model and in the folder of the file that names it. Files that are not there or
/// not XML are left out.
void VisitElements(const std::string& model, const ElementVisitor& visit);

}  // namespace girdle
