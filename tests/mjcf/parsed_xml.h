// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// XML read back with tinyxml2: elements by tag and name, attributes as numbers.
#pragma once

#include <tinyxml2.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinematics/rotation.h"

namespace girdle {

class ParsedXml {
 public:
  explicit ParsedXml(const std::string& text) {
    if (document_.Parse(text.c_str()) != tinyxml2::XML_SUCCESS) {
      throw std::runtime_error(std::string("not XML: ") + document_.ErrorStr());
    }
  }

  [[nodiscard]] const tinyxml2::XMLElement& root() const { return *document_.RootElement(); }

  /// All elements below `element` with this tag, in the order of the file; all if the tag is empty.
  [[nodiscard]] static std::vector<const tinyxml2::XMLElement*> All(
      const tinyxml2::XMLElement& element, const std::string& tag) {
    std::vector<const tinyxml2::XMLElement*> found;
    for (const auto* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (tag.empty() || tag == child->Name()) found.push_back(child);
      const auto below = All(*child, tag);
      found.insert(found.end(), below.begin(), below.end());
    }
    return found;
  }

  [[nodiscard]] std::vector<const tinyxml2::XMLElement*> All(const std::string& tag) const {
    return All(root(), tag);
  }

  /// All elements with this tag that are parts of the model, and not defaults for them.
  [[nodiscard]] std::vector<const tinyxml2::XMLElement*> Parts(const std::string& tag) const {
    const auto defaults = All(Child("default"), tag);
    auto parts = All(tag);
    std::erase_if(parts, [&](const auto* element) {
      return std::find(defaults.begin(), defaults.end(), element) != defaults.end();
    });
    return parts;
  }

  /// The one element with this tag and name.
  [[nodiscard]] const tinyxml2::XMLElement& Named(const std::string& tag,
                                                  const std::string& name) const {
    const tinyxml2::XMLElement* found = nullptr;
    for (const auto* element : All(tag)) {
      const char* const own = element->Attribute("name");
      if (own == nullptr || name != own) continue;
      if (found != nullptr) throw std::runtime_error("two <" + tag + "> are named " + name);
      found = element;
    }
    if (found == nullptr) throw std::runtime_error("no <" + tag + "> is named " + name);
    return *found;
  }

  /// The one child with this tag.
  [[nodiscard]] const tinyxml2::XMLElement& Child(const std::string& tag) const {
    const auto* child = root().FirstChildElement(tag.c_str());
    if (child == nullptr) throw std::runtime_error("no <" + tag + ">");
    return *child;
  }

 private:
  tinyxml2::XMLDocument document_;
};

inline std::string TextOf(const tinyxml2::XMLElement& element, const char* attribute) {
  const char* const text = element.Attribute(attribute);
  if (text == nullptr) {
    throw std::runtime_error(std::string("<") + element.Name() + "> has no " + attribute);
  }
  return text;
}

inline std::vector<std::string> Words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

inline std::vector<double> NumbersOf(const tinyxml2::XMLElement& element, const char* attribute) {
  std::vector<double> numbers;
  for (const std::string& word : Words(TextOf(element, attribute))) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0') throw std::runtime_error(word + " in " + attribute + " is no number");
  }
  return numbers;
}

inline double NumberOf(const tinyxml2::XMLElement& element, const char* attribute) {
  return NumbersOf(element, attribute).at(0);
}

inline Vector3 VectorIn(const tinyxml2::XMLElement& element, const char* attribute) {
  const std::vector<double> numbers = NumbersOf(element, attribute);
  if (numbers.size() != 3) throw std::runtime_error(std::string(attribute) + " has not 3 numbers");
  return {numbers[0], numbers[1], numbers[2]};
}

/// MuJoCo's order, w x y z.
inline Quaternion QuaternionIn(const tinyxml2::XMLElement& element, const char* attribute) {
  const std::vector<double> numbers = NumbersOf(element, attribute);
  if (numbers.size() != 4) throw std::runtime_error(std::string(attribute) + " has not 4 numbers");
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

/// Words that no attribute of a model may hold: not finite, or zero with a minus.
inline std::vector<std::string> BadNumbers(const ParsedXml& xml) {
  std::vector<std::string> bad;
  for (const auto* element : xml.All("")) {
    for (const auto* attribute = element->FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      for (const std::string& word : Words(attribute->Value())) {
        char* end = nullptr;
        const double number = std::strtod(word.c_str(), &end);
        const bool is_number = *end == '\0';
        // -1, but not -0 or -0.0, has a digit above 0 before any exponent.
        const bool is_minus_zero = is_number && number == 0 && word.front() == '-';
        if (is_number && (!(number - number == 0) || is_minus_zero)) {
          bad.push_back(std::string(element->Name()) + " " + attribute->Name() + " " + word);
        }
      }
    }
  }
  return bad;
}

}  // namespace girdle
