// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// OpenGL without a screen.
///
/// The libraries are opened when the first context is made, so that a machine without them can do
/// everything else. MuJoCo takes its OpenGL functions once in a process, from the library that it
/// finds among the process's global symbols; so all contexts of a process are of one platform, and
/// only the library chosen is made global. Tried in turn: EGL on a device (a graphics card, or
/// Mesa's software renderer as one), EGL on Mesa's surfaceless platform, OSMesa.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace girdle {

/// Environment variable that chooses among them: empty or not set for the first that works, or one
/// of these words.
inline constexpr const char* kGlVariable = "GIRDLE_GL";
inline constexpr std::array<std::string_view, 3> kGlWords = {"egl", "osmesa", "none"};

class GlLibrary;

/// A context of its own, current until another one is made current.
class GlContext {
 public:
  /// Throws InputError that says why nothing here draws without a screen and what to install, or
  /// that kGlVariable does not hold one of kGlWords.
  GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  ~GlContext();

  /// Returns whether it is the current one now.
  [[nodiscard]] bool MakeCurrent() const noexcept;

  /// For people: `EGL device, llvmpipe (LLVM 15.0.6, 256 bits)`. Makes the context current.
  [[nodiscard]] std::string Description() const;

 private:
  GlLibrary& library_;
  void* context_;
};

}  // namespace girdle
