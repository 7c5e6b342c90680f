# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
#
# Writes a C++ file that defines the text of data files as constants of girdle::built_in_files.
#   cmake -DOUTPUT=FILE.cc -DHEADER=room/built_in_files.h -DNAMES="kOne;kTwo" -DFILES="one.csv;two.csv" -P EmbedText.cmake
set(code "// Made from data/ by the build.\n#include \"${HEADER}\"\n\n")
string(APPEND code "namespace girdle::built_in_files {\n\n")
foreach(name file IN ZIP_LISTS NAMES FILES)
  file(READ "${file}" text)
  string(APPEND code "const std::string_view ${name} = R\"girdle(${text})girdle\";\n\n")
endforeach()
string(APPEND code "}  // namespace girdle::built_in_files\n")
file(WRITE "${OUTPUT}" "${code}")
