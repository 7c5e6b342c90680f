// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/picture_arguments.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "commands/option_group.h"
#include "commands/word_argument.h"
#include "text/input_error.h"
#include "text/small_letters.h"

namespace girdle {
namespace {

// Returns a number of pixels within the limits; nothing for any other text.
std::optional<int> PixelsFrom(std::string_view text) {
  int pixels = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, pixels);
  return error == std::errc() && stop == end && pixels >= kSmallestPicture &&
                 pixels <= kLargestPicture
             ? std::optional(pixels)
             : std::nullopt;
}

PictureSize SizeFrom(const std::string& text) {
  const std::size_t cross = std::min(text.find('x'), text.size());
  const std::optional<int> width = PixelsFrom(std::string_view(text).substr(0, cross));
  const std::optional<int> height =
      PixelsFrom(std::string_view(text).substr(std::min(cross + 1, text.size())));
  if (!width || !height) {
    throw InputError("--size " + text + ": expected WIDTHxHEIGHT in pixels, each " +
                     std::to_string(kSmallestPicture) + " to " + std::to_string(kLargestPicture) +
                     ", such as 640x480");
  }
  return {*width, *height};
}

}  // namespace

const char* const kPicturesHelp =
    "\nPictures need no screen: EGL draws them, or else OSMesa. The environment variable "
    "GIRDLE_GL=egl, osmesa or none chooses; girdle doctor shows what this machine has.\n";

void AddViewArguments(CLI::App& verb, ViewArguments& arguments) {
  const OptionGroup group(verb, "Pictures");
  verb.add_option("--camera", arguments.camera,
                  "Where a picture looks from: a camera of the model, or front, back, above, "
                  "oblique (default)")
      ->type_name("WORD");
  verb.add_option("--size", arguments.size, "Size of a picture in pixels (default 640x480)")
      ->type_name("WxH");
  verb.add_option("--show", arguments.show,
                  "skin (default of a model that has one), bones, or both: bones in translucent "
                  "skin")
      ->type_name("WORD");
}

View ChosenView(const ViewArguments& arguments) {
  View view;
  if (!arguments.camera.empty()) {
    view.camera = arguments.camera;
  }
  if (!arguments.size.empty()) {
    view.size = SizeFrom(arguments.size);
  }
  if (!arguments.show.empty()) {
    ChooseWord("--show", arguments.show, view.show.emplace());
  }
  return view;
}

void ExpectSuffix(const std::string& option, const std::string& file, std::string_view suffix) {
  if (InSmallLetters(std::filesystem::path(file).extension().string()) != suffix) {
    throw InputError(option + " " + file + ": the name does not end in " + std::string(suffix) +
                     ", which is what is written. Name it " +
                     std::filesystem::path(file).replace_extension(suffix).string());
  }
}

}  // namespace girdle
