// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// View of a picture: camera, size, and the layers of the body that are drawn. Needs no MuJoCo, so
/// that the command line can read it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace girdle {

/// Width and height [pixels].
struct PictureSize {
  int width = 640;
  int height = 480;

  [[nodiscard]] bool operator==(const PictureSize&) const noexcept = default;
};

/// Smallest and largest width or height of a picture [pixels]. Every present renderer can draw the
/// largest, with four samples per pixel in a few hundred megabytes of memory.
inline constexpr int kSmallestPicture = 16;
inline constexpr int kLargestPicture = 4096;

/// Slowest and fastest video [frames/s].
inline constexpr int kSlowestVideo_per_s = 1;
inline constexpr int kFastestVideo_per_s = 240;

/// Words for cameras: from the person's front, from the back, from above with the front at the top
/// of the picture, and from above in front of the right arm (of the left arm if there is no right
/// one).
inline constexpr std::array<std::string_view, 4> kCameraWords = {"front", "back", "above",
                                                                 "oblique"};

/// Which layers of a body are drawn.
enum class Show {
  kSkin,   ///< the skin, without the parts that move it
  kBones,  ///< bones, without the skin
  kBoth,   ///< bones in a translucent skin
};
/// Words for them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kShowNames = {"skin", "bones", "both"};
constexpr const auto& WordsOf(Show /*which*/) noexcept { return kShowNames; }

struct View {
  /// A camera of the model, or a word of kCameraWords.
  std::string camera = "oblique";
  PictureSize size;
  /// If empty: the skin, or the bones of a model without skin.
  std::optional<Show> show = std::nullopt;
};

}  // namespace girdle
