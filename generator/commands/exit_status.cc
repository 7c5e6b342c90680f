// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/exit_status.h"

#include <cxxabi.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <new>
#include <typeinfo>

#include "text/input_error.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

constexpr const char* kWhatToReport =
    "Please report it with this message, the command line, the files that it reads and the "
    "version, girdle " GIRDLE_VERSION ".\n";

// Prints the type of an exception under its name in C++.
void PrintType(const std::exception& exception, std::ostream& out) {
  const char* const mangled = typeid(exception).name();
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(mangled, nullptr, nullptr, &status), &std::free);
  out << (status == 0 ? name.get() : mangled);
}

}  // namespace

int ReportException(const std::exception_ptr& exception, std::ostream& out) {
  // Pieces are written one by one: joining them needs memory, which may be exhausted.
  out << "girdle: ";
  try {
    std::rethrow_exception(exception);
  } catch (const InputError& error) {
    WritePrintable(out, error.what());
    out << "\n";
    return kBadInput;
  } catch (const std::filesystem::filesystem_error& error) {
    WritePrintable(out, error.what());
    out << "\n";
    return kBadInput;
  } catch (const std::bad_alloc&) {
    out << "the memory is used up. Give less at once, end other programs, or allow more (ulimit "
           "-v)\n";
    return kOutOfMemory;
  } catch (const std::exception& error) {
    out << "this is a fault of Girdle, not of the input: ";
    PrintType(error, out);
    out << ": ";
    WritePrintable(out, error.what());
    out << "\n" << kWhatToReport;
  } catch (...) {
    out << "this is a fault of Girdle, not of the input: an exception of no known type\n"
        << kWhatToReport;
  }
  return kFaultOfGirdle;
}

}  // namespace girdle
