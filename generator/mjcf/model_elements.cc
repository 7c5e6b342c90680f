// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_elements.h"

#include <tinyxml2.h>

#include <set>
#include <string_view>
#include <system_error>

namespace girdle {
namespace {

class Walk {
 public:
  Walk(const std::filesystem::path& model, const ElementVisitor& visit)
      : top_(model.parent_path()), visit_(visit) {
    Read(model);
  }

 private:
  void Read(const std::filesystem::path& file) {
    std::error_code unclear;
    tinyxml2::XMLDocument document;
    if (!std::filesystem::is_regular_file(file, unclear) ||
        !read_.insert(std::filesystem::weakly_canonical(file, unclear)).second ||
        document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) {
      return;
    }
    for (const auto* child = document.RootElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      ReadElement(*child, file);
    }
  }

  void ReadElement(const tinyxml2::XMLElement& element, const std::filesystem::path& file) {
    visit_(element, file);
    const std::string_view kind = element.Name();
    const char* const further = element.Attribute("file");
    if ((kind == "include" || kind == "model") && further != nullptr) {
      Read(top_ / further);
      Read(file.parent_path() / further);
    }
    for (const auto* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      ReadElement(*child, file);
    }
  }

  std::filesystem::path top_;
  const ElementVisitor& visit_;
  std::set<std::filesystem::path> read_;
};

}  // namespace

void VisitElements(const std::string& model, const ElementVisitor& visit) { Walk(model, visit); }

}  // namespace girdle
