// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The program `girdle`: verbs first, errors on standard error, exit status 0 fine, 1 a residual
/// above its tolerance, 2 bad usage or input.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

#include "commands/generate_command.h"
#include "commands/output_file.h"
#include "commands/simulate_command.h"
#include "commands/solve_command.h"
#include "commands/verify_command.h"
#include "tables/input_error.h"

namespace girdle {
namespace {

constexpr int kBadInput = 2;

// CLI11 would call an unknown verb an unexpected argument.
void CheckVerb(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    return;
  }
  std::string known;
  for (const CLI::App* verb : program.get_subcommands({})) {
    if (verb->get_name() == argv[1]) {
      return;
    }
    known += " " + verb->get_name();
  }
  throw InputError("'" + std::string(argv[1]) + "' is not a verb. Verbs are:" + known);
}

int Run(int argc, char** argv) {
  CLI::App program("A human shoulder for MuJoCo that moves as measured.", "girdle");
  program.set_version_flag("--version", "girdle " GIRDLE_VERSION);
  program.require_subcommand(1);
  int residual_status = 0;
  AddSolveCommand(program);
  AddGenerateCommand(program);
  AddSimulateCommand(program);
  AddVerifyCommand(program, residual_status);
  program.footer("girdle VERB --help tells more, with examples.");
  CheckVerb(program, argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    program.exit(help, text, text);
    Print(text.str());
    return 0;
  } catch (const CLI::ParseError& error) {
    throw InputError(std::string(error.what()) + "\nSee girdle --help");
  }
  return residual_status;
}

}  // namespace
}  // namespace girdle

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  try {
    return girdle::Run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "girdle: " << error.what() << "\n";
    return girdle::kBadInput;
  }
}
