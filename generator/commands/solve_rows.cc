// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_rows.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "commands/output_file.h"
#include "commands/progress.h"
#include "names/model_names.h"
#include "text/csv.h"

namespace girdle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A column of the input that says what is asked. A further one is a line in kCommandColumns.
struct CommandColumn {
  const char* name;
  double ArmCommand::*angle_rad;
  // For a column that may be missing: what stands in its place for all rows.
  const char* option = nullptr;
  std::optional<double> RowOptions::*option_deg = nullptr;
  CoordinateRange bounds = {-kInfinity, kInfinity};
};

constexpr std::array<CommandColumn, 5> kCommandColumns = {{
    {kElevationColumn, &ArmCommand::elevation_rad},
    {kPlaneColumn, &ArmCommand::plane_rad},
    {kAxialColumn, &ArmCommand::axial_rad, "--axial", &RowOptions::axial_deg},
    {kShrugColumn, &ArmCommand::shrug_rad, "--shrug", &RowOptions::shrug_deg, kShrugRange},
    {kProtractionColumn, &ArmCommand::protraction_rad, "--protraction",
     &RowOptions::protraction_deg, kProtractionRange},
}};

// What is read from a row and what is written behind it. Immutable: threads share it.
class RowColumns {
 public:
  // Throws InputError at the header if a column is missing, stands there beside the option that
  // replaces it, or would stand twice in the output. The options have to outlive it.
  RowColumns(const CsvReader& csv, const RowOptions& options)
      : additions_(options.additions), answers_(SolveColumns(options.additions)) {
    for (const CommandColumn& column : kCommandColumns) {
      const std::optional<double> option_deg =
          column.option == nullptr ? std::nullopt : options.*column.option_deg;
      if (column.option == nullptr || csv.HasColumn(column.name)) {
        commands_.push_back({csv.Column(column.name), column.angle_rad,
                             TypedDegrees(column.bounds.lower_rad),
                             TypedDegrees(column.bounds.upper_rad)});
        if (option_deg) {
          csv.Fail("the column " + std::string(column.name) + " and " + column.option +
                   " exclude each other. Remove one");
        }
      } else if (option_deg) {
        unless_given_.*column.angle_rad = RadiansFromDegrees(*option_deg);
      }
    }
    for (const std::string& name : answers_.names()) {
      if (csv.HasColumn(name)) {
        csv.Fail("column '" + name + "' would stand twice in the output. Rename it in the input");
      }
    }
  }

  // The header of the output behind that of the input, with a line end.
  [[nodiscard]] std::string HeaderText() const { return "," + answers_.Header() + "\n"; }

  // Solves the current row and appends it, with its answer, to `text`.
  void Append(std::string& text, const CsvRows& row, const ShoulderRhythm& rhythm) const {
    ArmCommand command = unless_given_;
    for (const ReadColumn& column : commands_) {
      command.*column.angle_rad =
          RadiansFromDegrees(row.NumberWithin(column.index, column.lower_deg, column.upper_deg));
    }
    text += row.line();
    text += ',';
    const ShoulderSolution solution = rhythm.Solve(command);
    answers_.Append(text, SolvedRowOf(rhythm, command, solution, additions_));
    text += '\n';
  }

 private:
  struct ReadColumn {
    std::size_t index;
    double ArmCommand::*angle_rad;
    double lower_deg;
    double upper_deg;
  };

  const SolveAdditions& additions_;
  std::vector<ReadColumn> commands_;
  ArmCommand unless_given_;  ///< what a row without a column for it asks
  WrittenColumns<SolvedRow, AppendRounded> answers_;
};

// A number of successive rows on their way from the input to the output.
struct Portion {
  std::size_t turn;  // from 0, in the order of the input
  CsvBlock rows;
  std::string answer;
  std::exception_ptr error;
};

// Workers that each take a block of rows, answer it, and write when all before it is written.
class RowWorkers {
 public:
  RowWorkers(CsvReader& csv, const RowColumns& columns, const ShoulderRhythm& rhythm,
             OutputFile& out, TerminalProgress& progress, std::uintmax_t bytes)
      : columns_(columns),
        rhythm_(rhythm),
        csv_(csv),
        out_(out),
        progress_(progress),
        bytes_(bytes),
        unwritten_header_(csv.header_line() + columns.HeaderText()) {}

  // Answers all rows with so many threads. Throws the first error in the order of the rows.
  void Run(std::size_t threads) {
    std::vector<std::jthread> workers;
    // Of several, none is this thread: what it writes lies beside what all of them read, and they
    // would wait for each other's caches.
    for (std::size_t i = 0; threads > 1 && i < threads; ++i) {
      try {
        workers.emplace_back([this] { Work(); });
      } catch (const std::system_error&) {
        break;  // no more threads are to be had: these will do
      }
    }
    if (workers.empty()) {
      Work();
    }
    workers.clear();  // waits for them
    if (error_) {
      std::rethrow_exception(error_);
    }
    out_.Write(unwritten_header_);
  }

 private:
  void Work() {
    CsvRows rows(csv_.header());
    Portion portion;
    while (Take(portion)) {
      if (!portion.error) {
        Answer(portion, rows);
      }
      Write(portion);
    }
  }

  // Takes the next rows, or the error in their place. Returns false if there is nothing left to do.
  // Nobody waits for input while an answer or an error is on its way.
  [[nodiscard]] bool Take(Portion& portion) {
    const std::lock_guard reading(reading_);
    portion.error = nullptr;
    try {
      if (!csv_.HasLinesAtHand()) {
        std::unique_lock writing(writing_);
        written_.wait(writing, [this] { return turns_written_ == turns_taken_ || error_; });
        out_.Flush();
      }
      if (is_stopped_ || !csv_.TakeBlock(portion.rows)) {
        return false;
      }
    } catch (...) {
      portion.error = std::current_exception();
    }
    portion.turn = turns_taken_++;
    return true;
  }

  void Answer(Portion& portion, CsvRows& rows) const noexcept {
    portion.answer.clear();
    try {
      rows.Start(portion.rows);
      while (rows.Next()) {
        columns_.Append(portion.answer, rows, rhythm_);
      }
    } catch (...) {
      portion.error = std::current_exception();
    }
  }

  // Writes the answer when it is its turn. After an error nothing is written any more.
  void Write(const Portion& portion) {
    std::unique_lock writing(writing_);
    written_.wait(writing, [&] { return turns_written_ == portion.turn || error_; });
    if (!error_) {
      try {
        if (portion.error) {
          std::rethrow_exception(portion.error);
        }
        out_.Write(unwritten_header_);
        unwritten_header_.clear();
        out_.Write(portion.answer);
        bytes_done_ += portion.rows.text.size();
        if (bytes_ > 0) {
          progress_(std::min(1.0, static_cast<double>(bytes_done_) / static_cast<double>(bytes_)));
        }
        ++turns_written_;
      } catch (...) {
        error_ = std::current_exception();
        is_stopped_ = true;
      }
    }
    written_.notify_all();
  }

  const RowColumns& columns_;
  const ShoulderRhythm& rhythm_;

  // Locked before writing_ where both are.
  std::mutex reading_;
  CsvReader& csv_;
  std::size_t turns_taken_ = 0;

  std::mutex writing_;
  std::condition_variable written_;  // or failed
  OutputFile& out_;
  TerminalProgress& progress_;
  std::uintmax_t bytes_;
  std::uintmax_t bytes_done_ = 0;
  std::string unwritten_header_;  // empty when it is written, which is with the first rows
  std::size_t turns_written_ = 0;
  std::exception_ptr error_;  // the first in the order of the rows
  // As error_ says, for those who do not lock writing_: it is locked while a block is written.
  std::atomic<bool> is_stopped_ = false;
};

}  // namespace

void SolveRows(const RowSource& source, const std::string& out, const ShoulderRhythm& rhythm,
               const RowOptions& options) {
  CsvReader csv(source.in, source.name);
  const RowColumns columns(csv, options);
  OutputFile file(out);
  TerminalProgress progress("solving", out != "-");
  RowWorkers(csv, columns, rhythm, file, progress, source.bytes).Run(options.threads);
  file.Commit();
}

}  // namespace girdle
