// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The program `girdle`: verbs first, errors on standard error, exit statuses as in exit_status.h.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

#include "commands/compare_command.h"
#include "commands/continuity_command.h"
#include "commands/destep_command.h"
#include "commands/doctor_command.h"
#include "commands/exit_status.h"
#include "commands/generate_command.h"
#include "commands/output_file.h"
#include "commands/render_command.h"
#include "commands/simulate_command.h"
#include "commands/solve_command.h"
#include "commands/thorax_command.h"
#include "commands/verify_command.h"
#include "text/input_error.h"

namespace girdle {
namespace {

constexpr const char* kSeeHelp = "See girdle --help";

std::string VerbNames(const CLI::App& program) {
  std::string names;
  for (const CLI::App* verb : program.get_subcommands({})) {
    names += " " + verb->get_name();
  }
  return names;
}

// CLI11 would call an unknown verb an unexpected argument.
void CheckVerb(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    return;
  }
  for (const CLI::App* verb : program.get_subcommands({})) {
    if (verb->get_name() == argv[1]) {
      return;
    }
  }
  throw InputError("'" + std::string(argv[1]) + "' is not a verb. Verbs are:" + VerbNames(program) +
                   "\n" + kSeeHelp);
}

// An empty word is a shell variable that was not set, never a choice.
void RefuseEmptyWords(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.empty() || (word.starts_with("--") && word.ends_with("="))) {
      const std::string option = word.empty() ? argv[i - 1] : word.substr(0, word.size() - 1);
      throw InputError(option + " '': is empty. Give it a value or leave it away");
    }
  }
}

int Run(int argc, char** argv) {
  CLI::App program("A human shoulder for MuJoCo that moves as measured.", "girdle");
  program.set_version_flag("--version", "girdle " GIRDLE_VERSION);
  program.require_subcommand(0, 1);
  int residual_status = kFine;
  AddSolveCommand(program);
  AddGenerateCommand(program);
  AddSimulateCommand(program);
  AddRenderCommand(program);
  AddVerifyCommand(program, residual_status);
  AddCompareCommand(program);
  AddContinuityCommand(program, residual_status);
  AddDestepCommand(program);
  AddDoctorCommand(program, residual_status);
  AddThoraxCommand(program);
  program.footer(
      "Exit status: 0 all is well, 1 a residual or check is outside its tolerance, 2 the command "
      "line or a file cannot be used, 3 a fault of Girdle, 4 the memory is used up.\n"
      "girdle VERB --help tells more, with examples.");
  RefuseEmptyWords(argc, argv);
  CheckVerb(program, argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    program.exit(help, text, text);
    Print(text.str());
    return kFine;
  } catch (const CLI::ParseError& error) {
    throw InputError(std::string(error.what()) + "\n" + kSeeHelp);
  }
  if (program.get_subcommands().empty()) {
    throw InputError("no verb. Verbs are:" + VerbNames(program) + "\n" + kSeeHelp);
  }
  return residual_status;
}

}  // namespace
}  // namespace girdle

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  try {
    return girdle::Run(argc, argv);
  } catch (...) {
    return girdle::ReportException(std::current_exception(), std::cerr);
  }
}
