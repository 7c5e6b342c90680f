// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/text_columns.h"

#include <gtest/gtest.h>

namespace girdle::text_columns_test {
namespace {

TEST(TextColumns, AlignsInAColumn) {
  EXPECT_EQ(AlignedLeft("SC", 4), "SC  ");
  EXPECT_EQ(AlignedRight("SC", 4), "  SC");
}

TEST(TextColumns, LeavesAWiderTextAsItIs) {
  EXPECT_EQ(AlignedLeft("clavicle", 4), "clavicle");
  EXPECT_EQ(AlignedRight("clavicle", 4), "clavicle");
}

TEST(TextColumns, AreAsWideAsTheirWidestText) {
  EXPECT_EQ(
      ColumnsText({{"bone", "mm"}, {"clavicle", "1.25"}}, {Alignment::kLeft, Alignment::kRight}),
      "bone        mm\n"
      "clavicle  1.25\n");
}

TEST(TextColumns, AlignTheRestAsTheLast) {
  EXPECT_EQ(ColumnsText({{"SC", "AC", "GH"}, {"a", "1.25", "12.5"}},
                        {Alignment::kLeft, Alignment::kRight}),
            "SC    AC    GH\n"
            "a   1.25  12.5\n");
}

TEST(TextColumns, EndNoLineInBlanks) {
  EXPECT_EQ(ColumnsText({{"mm", "where"}, {"1.25", ""}}, {Alignment::kRight, Alignment::kLeft}),
            "  mm  where\n"
            "1.25\n");
}

TEST(WrappedText, BreaksLinesAtBlanks) {
  EXPECT_EQ(WrappedText("a shoulder moves as measured", 12), "a shoulder\nmoves as\nmeasured");
  EXPECT_EQ(WrappedText("a shoulder moves", 12, 2), "a shoulder\n  moves");
}

TEST(WrappedText, KeepsLineEnds) { EXPECT_EQ(WrappedText("one\n\ntwo", 12), "one\n\ntwo"); }

TEST(WrappedText, BreaksExamplesBeforeAnOption) {
  EXPECT_EQ(WrappedText("Example:\n  girdle solve --in poses.csv --out angles.csv", 34),
            "Example:\n  girdle solve --in poses.csv \\\n      --out angles.csv");
  EXPECT_EQ(WrappedText("  girdle solve --in poses.csv", 80), "  girdle solve --in poses.csv");
}

TEST(WrappedText, KeepsAWordThatIsWiderThanALine) {
  EXPECT_EQ(WrappedText("of glenohumeral joints", 6), "of\nglenohumeral\njoints");
}

TEST(LabelledText, PutsTheTextInItsColumn) {
  EXPECT_EQ(LabelledText("--plane", "plane of elevation", 2, 12, 24),
            "  --plane   plane of\n"
            "            elevation\n");
}

TEST(LabelledText, PutsALongLabelOnALineOfItsOwn) {
  EXPECT_EQ(LabelledText("--elevation DEG", "humeral", 2, 12, 24),
            "  --elevation DEG\n"
            "            humeral\n");
}

}  // namespace
}  // namespace girdle::text_columns_test
