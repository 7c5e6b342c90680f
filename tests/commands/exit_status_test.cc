// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/exit_status.h"

#include <gtest/gtest.h>

#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "text/input_error.h"

namespace girdle::exit_status_test {
namespace {

struct Ending {
  int exit_status;
  std::string text;
};

Ending EndingOf(const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    std::ostringstream out;
    const int exit_status = ReportException(std::current_exception(), out);
    return {exit_status, out.str()};
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

TEST(ReportException, ShowsControlCharactersOfAnInputByTheirNumbers) {
  EXPECT_EQ(EndingOf([] { throw InputError("t.csv:2: '\x1b[31m'\nSee --help"); }).text,
            "girdle: t.csv:2: '\\x1b[31m'\nSee --help\n");
}

TEST(ReportException, SaysOfBadInputItsMessageAlone) {
  const Ending ending = EndingOf([] { throw InputError("a.csv", 7, "too few fields"); });
  EXPECT_EQ(ending.exit_status, 2);
  EXPECT_EQ(ending.text, "girdle: a.csv:7: too few fields\n");
}

TEST(ReportException, CountsAPathThatTheSystemRefusesAsInput) {
  const Ending ending =
      EndingOf([] { static_cast<void>(std::filesystem::is_directory(std::string(5000, 'a'))); });
  EXPECT_EQ(ending.exit_status, 2);
  EXPECT_NE(ending.text.find("File name too long"), std::string::npos) << ending.text;
  EXPECT_EQ(ending.text.find("fault"), std::string::npos) << ending.text;
}

TEST(ExitStatus, OfMemoryThatIsUsedUpIsItsOwn) {
  const Ending ending = EndingOf([] { throw std::bad_alloc(); });
  EXPECT_EQ(ending.exit_status, 4);
  EXPECT_EQ(ending.text,
            "girdle: the memory is used up. Give less at once, end other programs, or allow more "
            "(ulimit -v)\n");
}

struct FaultCase {
  const char* name;
  std::function<void()> work;
  const char* what;  ///< has to stand in the message
};

void PrintTo(const FaultCase& fault, std::ostream* out) { *out << fault.name; }

class Fault : public testing::TestWithParam<FaultCase> {};

TEST_P(Fault, IsSaidToBeOneOfGirdle) {
  const Ending ending = EndingOf(GetParam().work);
  EXPECT_EQ(ending.exit_status, 3);
  EXPECT_EQ(ending.text.rfind("girdle: ", 0), 0U) << ending.text;
  EXPECT_NE(ending.text.find("this is a fault of Girdle"), std::string::npos) << ending.text;
  EXPECT_NE(ending.text.find("Please report it"), std::string::npos) << ending.text;
  EXPECT_NE(ending.text.find("girdle 1.2.3"), std::string::npos) << ending.text;
  EXPECT_NE(ending.text.find(GetParam().what), std::string::npos) << ending.text;
  EXPECT_EQ(ending.text.back(), '\n');
}

INSTANTIATE_TEST_SUITE_P(
    Exceptions, Fault,
    testing::Values(FaultCase{"of a container", [] { std::vector<int>().at(1) = 1; },
                              "std::out_of_range: vector"},
                    // What rooms throw of values that are not files: whoever took them from a file
                    // or an option makes it an InputError.
                    FaultCase{"of a room", [] { throw std::invalid_argument("2 knots given"); },
                              "std::invalid_argument: 2 knots given"},
                    FaultCase{"of the base of InputError", [] { throw std::runtime_error("no"); },
                              "std::runtime_error: no"},
                    FaultCase{
                        "of the system",
                        [] { throw std::system_error(std::make_error_code(std::errc::io_error)); },
                        "std::system_error: Input/output error"},
                    FaultCase{"of no type", [] { throw 1; }, "an exception of no known type"}));

}  // namespace
}  // namespace girdle::exit_status_test
