// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Writes XML elements with attributes of MJCF's types.
#pragma once

#include <tinyxml2.h>

#include <span>
#include <string>
#include <string_view>

#include "kinematics/rotation.h"

namespace girdle {

/// An element of a tinyxml2 document, which owns it. Numbers are written as the shortest decimals
/// that read back exactly.
class XmlElement {
 public:
  explicit XmlElement(tinyxml2::XMLElement* element) : element_(element) {}

  /// Appends a child element.
  XmlElement Add(const char* name);
  /// Appends a comment.
  void AddComment(const std::string& text);

  XmlElement& Set(const char* attribute, std::string_view text);
  XmlElement& Set(const char* attribute, double number);
  XmlElement& Set(const char* attribute, const Vector3& vector);
  /// Writes w x y z, MuJoCo's order.
  XmlElement& Set(const char* attribute, const Quaternion& quaternion);
  XmlElement& Set(const char* attribute, std::span<const double> numbers);

 private:
  friend class XmlFile;
  tinyxml2::XMLElement* element_;
};

/// A document with one root element.
class XmlFile {
 public:
  explicit XmlFile(const char* root_name);

  [[nodiscard]] XmlElement root() { return root_; }
  [[nodiscard]] std::string Text() const;

 private:
  tinyxml2::XMLDocument document_;
  XmlElement root_;
};

}  // namespace girdle
