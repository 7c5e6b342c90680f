// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/xml_element.h"

#include <array>

#include "text/number_text.h"

namespace girdle {
namespace {

// Indents by two spaces per level, as the models of MuJoCo Menagerie.
class Printer : public tinyxml2::XMLPrinter {
 protected:
  void PrintSpace(int depth) override {
    for (int level = 0; level < depth; ++level) {
      Write("  ");
    }
  }
};

}  // namespace

XmlElement XmlElement::Add(const char* name) {
  return XmlElement(element_->InsertNewChildElement(name));
}

void XmlElement::AddComment(const std::string& text) {
  element_->InsertNewComment((" " + text + " ").c_str());
}

XmlElement& XmlElement::Set(const char* attribute, std::string_view text) {
  element_->SetAttribute(attribute, std::string(text).c_str());
  return *this;
}

XmlElement& XmlElement::Set(const char* attribute, double number) {
  return Set(attribute, std::span<const double>(&number, 1));
}

XmlElement& XmlElement::Set(const char* attribute, const Vector3& vector) {
  return Set(attribute, std::array{vector.x, vector.y, vector.z});
}

XmlElement& XmlElement::Set(const char* attribute, const Quaternion& quaternion) {
  return Set(attribute, std::array{quaternion.w, quaternion.x, quaternion.y, quaternion.z});
}

XmlElement& XmlElement::Set(const char* attribute, std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) {
      text += ' ';
    }
    // Adding zero turns -0 into 0.
    AppendNumber(text, number + 0.0);
  }
  element_->SetAttribute(attribute, text.c_str());
  return *this;
}

XmlFile::XmlFile(const char* root_name) : root_(document_.NewElement(root_name)) {
  document_.InsertEndChild(root_.element_);
}

std::string XmlFile::Text() const {
  Printer printer;
  document_.Print(&printer);
  return printer.CStr();
}

}  // namespace girdle
