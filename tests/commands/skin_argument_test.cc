// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/skin_argument.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_tables.h"
#include "text/input_error.h"

namespace girdle::skin_argument_test {
namespace {

// A tetrahedron in the chest, and beside it a vertex of no triangle, which no heat reaches.
ChosenBody WithLooseVertex(const std::string& source) {
  ChosenBody chosen;
  chosen.body.surface = {{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}, {0.1, 0.1, 0.1}},
                         {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  chosen.body.anatomy = BuiltInAnatomy();
  chosen.body.pose = BuiltInRhythm().Solve({}).pose;
  chosen.source = source;
  return chosen;
}

const std::string kReason = "vertex 4 of the surface belongs to no triangle with an area";

TEST(SkinArgument, BlamesTheOptionForASurfaceThatTheUserGave) {
  try {
    static_cast<void>(BoundTo(WithLooseVertex("--skin person.obj"), {Side::kRight}));
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), "--skin person.obj: " + kReason);
  }
}

// A name that is longer than what a string holds without memory of its own.
TEST(SkinArgument, LeavesNothingBehindOfASkinThatIsNotMade) {
  EXPECT_THROW(static_cast<void>(SkinOf(WithLooseVertex("--skin person.obj"), {Side::kRight},
                                        "a_skin_with_a_name_that_is_long.skn")),
               InputError);
}

// Otherwise the program would tell people to mend what they never gave.
TEST(SkinArgument, DoesNotBlameTheUserForTheBuiltInSurface) {
  try {
    static_cast<void>(BoundTo(WithLooseVertex(""), {Side::kRight}));
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    FAIL() << error.what();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), kReason);
  }
}

}  // namespace
}  // namespace girdle::skin_argument_test
