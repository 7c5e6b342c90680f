// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options of the verbs that draw pictures.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "pictures/view.h"

namespace girdle {

/// The paragraph about pictures in the help of every verb that draws.
extern const char* const kPicturesHelp;

/// `--camera`, `--size`, `--show` as given; empty where not given.
struct ViewArguments {
  std::string camera;
  std::string size;
  std::string show;

  [[nodiscard]] bool empty() const { return camera.empty() && size.empty() && show.empty(); }
};

void AddViewArguments(CLI::App& verb, ViewArguments& arguments);

/// Returns the chosen view, with defaults for options that are not given. Throws InputError for an
/// unknown word, and if the size is not WIDTHxHEIGHT within the limits of a picture.
[[nodiscard]] View ChosenView(const ViewArguments& arguments);

/// Throws InputError unless the file's name ends in `suffix`, in letters of either case.
void ExpectSuffix(const std::string& option, const std::string& file, std::string_view suffix);

}  // namespace girdle
