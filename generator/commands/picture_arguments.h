// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options of the verbs that draw pictures.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "pictures/view.h"

namespace girdle {

/// What every verb that draws says of it in its help.
extern const char* const kPicturesHelp;

/// `--camera`, `--size`, `--show` as given; empty where not given.
struct ViewArguments {
  std::string camera;
  std::string size;
  std::string show;

  [[nodiscard]] bool empty() const { return camera.empty() && size.empty() && show.empty(); }
};

void AddViewArguments(CLI::App& verb, ViewArguments& arguments);

/// Returns the view chosen, defaults where nothing was given. Throws InputError if the size is not
/// WIDTHxHEIGHT within the limits of a picture, or for an unknown word.
[[nodiscard]] View ChosenView(const ViewArguments& arguments);

/// Throws InputError unless the file's name ends in `suffix`, in letters of either case.
void ExpectSuffix(const std::string& option, const std::string& file, std::string_view suffix);

}  // namespace girdle
