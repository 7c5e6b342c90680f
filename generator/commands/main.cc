// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The program `girdle`: verbs first, errors on standard error, exit statuses as in exit_status.h.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "commands/compare_command.h"
#include "commands/doctor_command.h"
#include "commands/exit_status.h"
#include "commands/fit_thorax_command.h"
#include "commands/generate_command.h"
#include "commands/help_formatter.h"
#include "commands/output_file.h"
#include "commands/render_command.h"
#include "commands/simulate_command.h"
#include "commands/smooth_table_command.h"
#include "commands/smoothness_command.h"
#include "commands/solve_command.h"
#include "commands/terminal.h"
#include "commands/typed_words.h"
#include "commands/verify_command.h"
#include "text/input_error.h"

namespace girdle {
namespace {

constexpr const char* kSeeHelp = "See girdle --help";

// `girdle help VERB` means `girdle VERB --help`, and `girdle help` means `girdle --help`.
std::vector<std::string> TypedWords(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    if (words.size() == 1 && (words.front() == "-h" || words.front() == "--help")) {
      return words;
    }
    if (words.size() > 1 || (words.size() == 1 && words.front().starts_with('-'))) {
      throw InputError("girdle help takes one verb, such as girdle help solve");
    }
    words.emplace_back("--help");
  }
  return words;
}

int Run(int argc, char** argv) {
  CLI::App program("A human shoulder for MuJoCo that moves as measured.", "girdle");
  program.formatter(std::make_shared<HelpFormatter>(StyleOfStandardOutput().width));
  program.set_version_flag("--version", "girdle " GIRDLE_VERSION);
  program.require_subcommand(0, 1);
  int residual_status = kFine;
  AddSolveCommand(program);
  AddGenerateCommand(program);
  AddSimulateCommand(program);
  AddRenderCommand(program);
  AddVerifyCommand(program, residual_status);
  AddCompareCommand(program);
  AddSmoothnessCommand(program, residual_status);
  AddSmoothTableCommand(program);
  AddDoctorCommand(program, residual_status);
  AddFitThoraxCommand(program);
  for (CLI::App* const verb : program.get_subcommands({})) {
    verb->group("Verbs");
  }
  program.footer(
      "Exit status: 0 all is well, 1 a residual or check is outside its tolerance, 2 the command "
      "line or a file cannot be used, 3 a fault of Girdle, 4 the memory is used up.\n"
      "girdle help VERB tells more, with examples.");
  std::vector<std::string> words = TypedWords(argc, argv);
  ExpectKnownWords(program, words);
  if (AsksForHelp(words)) {
    words.resize(1);  // the verb, or what asks
    words.emplace_back("--help");
  }
  const std::string command =
      words.empty() || words.front().starts_with('-') ? "girdle" : "girdle " + words.front();
  try {
    std::ranges::reverse(words);  // CLI11 takes the last one first
    program.parse(std::move(words));
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    program.exit(help, text, text);
    Print(text.str());
    return kFine;
  } catch (const CLI::ParseError& error) {
    throw InputError(std::string(error.what()) + "\nSee " + command + " --help");
  }
  if (program.get_subcommands().empty()) {
    throw InputError("no verb. Give one, such as girdle solve --elevation 90 --plane 40\n" +
                     std::string(kSeeHelp));
  }
  return residual_status;
}

}  // namespace
}  // namespace girdle

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  // A file that grows beyond the limit of the system (ulimit -f) is an error of its write.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return girdle::Run(argc, argv);
  } catch (...) {
    return girdle::ReportException(std::current_exception(), std::cerr);
  }
}
