// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// OpenGL without a screen.
///
/// The libraries are opened when the first context is made, so that all else works on a machine
/// without them. MuJoCo takes its OpenGL functions once in a process, from the library that it
/// finds among the process's global symbols. All contexts of a process therefore use one platform,
/// and only the chosen library is made global. The platforms are tried in this order: EGL on a
/// device (a graphics card, or Mesa's software renderer), EGL on Mesa's surfaceless platform,
/// OSMesa.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace girdle {

/// Environment variable that chooses the platform: one of these words, or empty or not set for the
/// first platform that works.
inline constexpr const char* kGlVariable = "GIRDLE_GL";
inline constexpr std::array<std::string_view, 3> kGlWords = {"egl", "osmesa", "none"};

class GlLibrary;

/// An OpenGL context that is current until another one is made current.
class GlContext {
 public:
  /// Throws InputError if this machine cannot draw without a screen, with the reason and the
  /// packages to install, or if kGlVariable does not hold one of kGlWords.
  GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  ~GlContext();

  /// Makes the context current. Returns whether this succeeded.
  [[nodiscard]] bool MakeCurrent() const noexcept;

  /// Returns a text for people: `EGL device, llvmpipe (LLVM 15.0.6, 256 bits)`. Makes the context
  /// current.
  [[nodiscard]] std::string Description() const;

 private:
  GlLibrary& library_;
  void* context_;
};

}  // namespace girdle
