// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/anatomy_arguments.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/person_landmarks.h"
#include "commands/option_group.h"
#include "fits/fitted_anatomy.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/shown_text.h"
#include "text/text_file.h"

namespace girdle {
namespace {

std::string OptionOf(const BodyMeasure& measure) { return "--" + std::string(measure.name); }

BodySize ChosenSize(const AnatomyArguments& arguments) {
  BodySize size;
  for (std::size_t i = 0; i < kBodyMeasures.size(); ++i) {
    const BodyMeasure& measure = kBodyMeasures[i];
    const std::string& text = arguments.measures[i];
    if (text.empty()) {
      continue;
    }
    size.*measure.value = FiniteNumber(text);
    if (!(size.*measure.value)) {
      throw InputError(OptionOf(measure) + " '" + text + "': not a finite number. Give " +
                       (measure.unit == "kg" ? "kilograms" : "meters") + " such as " +
                       OptionOf(measure) + " " + std::string(measure.example));
    }
  }
  try {
    CheckBodySize(size);
  } catch (const std::invalid_argument& error) {
    throw InputError("--" + std::string(error.what()));
  }
  return size;
}

Anatomy AnatomyOf(const std::string& file, const BodySize& size) {
  if (size.clavicle_length_m || size.scapula_length_m || size.humerus_length_m) {
    throw InputError("--anatomy " + file +
                     ": the lengths of the bones are those of its landmarks. Leave out "
                     "--clavicle-length, --scapula-length and --humerus-length");
  }
  const Anatomy adult = BuiltInAnatomy();
  std::ifstream in = OpenTextFile(file);
  Anatomy anatomy = ReadPersonAnatomy(in, file, adult);
  SayHowGhWasFound(file, anatomy);
  if (size.stature_m) {
    anatomy.jugular_notch_height_m = JugularNotchHeight_m(*size.stature_m);
  }
  return size.body_mass_kg ? WithBodyMass(anatomy, adult, *size.body_mass_kg) : anatomy;
}

void FitGlidingOrSay(Anatomy& anatomy) {
  try {
    FitGliding(anatomy);
  } catch (const std::invalid_argument& error) {
    throw InputError("this anatomy's scapula does not glide on a thorax: " +
                     std::string(error.what()) + ". Give one with --ellipsoids FILE");
  }
}

// Sets the ellipsoids of the file, or fits one to bones of other proportions.
void ChooseThorax(const AnatomyArguments& arguments, Anatomy& anatomy) {
  if (!anatomy.has_adult_proportions) {
    FitLigaments(anatomy);
  }
  if (!arguments.ellipsoids.empty()) {
    std::ifstream in = OpenTextFile(arguments.ellipsoids);
    ReadThoraxEllipsoids(in, arguments.ellipsoids, anatomy);
    anatomy.has_adult_proportions = false;
  } else if (!anatomy.has_adult_proportions) {
    FitGlidingOrSay(anatomy);
  }
}

}  // namespace

void AddAnatomyArguments(CLI::App& verb, AnatomyArguments& arguments) {
  const OptionGroup group(verb, "The person");
  verb.add_option("--anatomy", arguments.file,
                  "Landmarks of one person, a CSV in the format of data/landmarks.csv; in place of "
                  "the built-in adult")
      ->type_name("FILE");
  verb.add_option(
          "--ellipsoids", arguments.ellipsoids,
          "Ellipsoids of the thorax, a CSV as girdle fit-thorax --out writes it; in place of "
          "those that belong to the bones")
      ->type_name("FILE");
  for (std::size_t i = 0; i < kBodyMeasures.size(); ++i) {
    const BodyMeasure& measure = kBodyMeasures[i];
    verb.add_option(OptionOf(measure), arguments.measures[i], std::string(measure.meaning))
        ->type_name(measure.unit == "kg" ? "KG" : "M");
  }
}

Anatomy ChosenAnatomy(const AnatomyArguments& arguments) {
  const BodySize size = ChosenSize(arguments);
  Anatomy anatomy = arguments.file.empty() ? ScaledAnatomy(BuiltInAnatomy(), size)
                                           : AnatomyOf(arguments.file, size);
  ChooseThorax(arguments, anatomy);
  return anatomy;
}

void SayHowGhWasFound(const std::string& file, const Anatomy& anatomy) {
  if (!anatomy.gh_origin.empty()) {
    WritePrintable(std::cerr, file + ": GH is " + anatomy.gh_origin + ".\n");
  }
}

void FitTissues(Anatomy& anatomy) {
  FitLigaments(anatomy);
  FitGlidingOrSay(anatomy);
}

bool IsAnatomyChosen(const AnatomyArguments& arguments) noexcept {
  return !arguments.file.empty() || !arguments.ellipsoids.empty() ||
         std::any_of(arguments.measures.begin(), arguments.measures.end(),
                     [](const std::string& measure) { return !measure.empty(); });
}

}  // namespace girdle
