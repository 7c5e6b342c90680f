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
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "commands/output_file.h"
#include "commands/progress.h"
#include "commands/shoulder_points.h"
#include "kinematics/solve_many.h"
#include "names/model_names.h"
#include "text/csv.h"
#include "text/number_text.h"

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

// Rows that are solved together, as they stand in the output before their answers.
struct Rows {
  std::vector<std::string_view> lines;
  std::vector<ArmCommand> commands;

  void Clear() noexcept {
    lines.clear();
    commands.clear();
  }
};

// What a row asks where it has no column for it.
ArmCommand CommandOf(const RowOptions& options) noexcept {
  ArmCommand command;
  for (const CommandColumn& column : kCommandColumns) {
    if (column.option != nullptr && options.*column.option_deg) {
      command.*column.angle_rad = RadiansFromDegrees(*(options.*column.option_deg));
    }
  }
  if (options.axial_deg) {
    command.axial_from = options.axial_from;
  }
  return command;
}

// What is written behind rows. Immutable: threads share it.
class RowAnswers {
 public:
  // Rhythm and options have to outlive it.
  RowAnswers(const ShoulderRhythm& rhythm, const RowOptions& options)
      : rhythm_(rhythm), additions_(options.additions), columns_(SolveColumns(additions_)) {}

  // Throws InputError at the header if a column would stand twice in the output.
  void ExpectNoneIn(const CsvReader& csv) const {
    for (const std::string& name : columns_.names()) {
      if (csv.HasColumn(name)) {
        csv.Fail("column '" + name + "' would stand twice in the output. Rename it in the input");
      }
    }
  }

  // The header of the output behind that of the input, with a line end.
  [[nodiscard]] std::string HeaderText() const { return "," + columns_.Header() + "\n"; }

  // What is computed of rows; kept by each thread, so that memory is taken once.
  struct Solved {
    std::vector<ShoulderPose> poses;
    std::vector<JointAngles> angles_rad;
    std::vector<ArmCommand> used;
    std::vector<Origin> origins;
    std::vector<double> distances_rad;
  };

  // Solves rows and appends them, each with its answer, to `text`.
  void Append(std::string& text, const Rows& rows, Solved& solved) const {
    const std::size_t count = rows.commands.size();
    solved.poses.resize(count);
    solved.angles_rad.resize(count);
    solved.used.resize(count);
    solved.origins.resize(count);
    solved.distances_rad.resize(count);
    SolveMany(rhythm_, rows.commands,
              {solved.poses, solved.angles_rad, solved.used, solved.origins, solved.distances_rad});
    for (std::size_t i = 0; i < count; ++i) {
      SolvedRow row{solved.angles_rad[i],
                    rhythm_.IsClamped(rows.commands[i], solved.used[i]),
                    solved.distances_rad[i],
                    solved.origins[i],
                    solved.used[i].axial_rad,
                    rhythm_.AxialOf(AxialFrom::kIsb, solved.poses[i], solved.used[i]),
                    std::nullopt,
                    {}};
      if (additions_.rates) {
        row.rates = rhythm_.SolveRates(rows.commands[i]);
      }
      if (additions_.points_of) {
        row.points = ShoulderPoints(*additions_.points_of, solved.poses[i]);
      }
      text += rows.lines[i];
      text += ',';
      columns_.Append(text, row);
      text += '\n';
    }
  }

 private:
  const ShoulderRhythm& rhythm_;
  const SolveAdditions& additions_;
  WrittenColumns<SolvedRow, AppendRounded> columns_;
};

// Rows of a CSV. One thread at a time takes a block, and reads it while others take theirs.
class CsvInput {
 public:
  using Block = CsvBlock;

  // Throws InputError at the header if a column is missing or stands there beside the option that
  // replaces it. The reader has to outlive it.
  CsvInput(CsvReader& csv, std::uintmax_t bytes, const RowOptions& options)
      : csv_(csv), bytes_(bytes), unless_given_(CommandOf(options)) {
    for (const CommandColumn& column : kCommandColumns) {
      if (column.option != nullptr && !csv.HasColumn(column.name)) {
        continue;
      }
      columns_.push_back({csv.Column(column.name), column.angle_rad,
                          TypedDegrees(column.bounds.lower_rad),
                          TypedDegrees(column.bounds.upper_rad)});
      if (column.option != nullptr && options.*column.option_deg) {
        csv.Fail("the column " + std::string(column.name) + " and " + column.option +
                 " exclude each other. Remove one");
      }
    }
    if (csv.HasColumn(kAxialColumn)) {
      unless_given_.axial_from = options.axial_from;
    } else if (options.axial_from != AxialFrom::kRhythm && !options.axial_deg) {
      csv.Fail("--axial-from " + std::string(Name(options.axial_from)) +
               ": no axial turn is given. Add the column " + kAxialColumn +
               " or --axial, or leave --axial-from away");
    }
  }

  [[nodiscard]] const std::string& header_line() const noexcept { return csv_.header_line(); }
  // All there is of what SizeOf measures; 0 if that is not known.
  [[nodiscard]] std::uintmax_t size() const noexcept { return bytes_; }
  [[nodiscard]] static std::uintmax_t SizeOf(const Block& block) noexcept {
    return block.text.size();
  }
  [[nodiscard]] bool HasRowsAtHand() { return csv_.HasLinesAtHand(); }
  [[nodiscard]] bool Take(Block& block) { return csv_.TakeBlock(block); }

  // Reads the rows of one block after the other, in one thread. The rows refer to the block.
  class Reader {
   public:
    explicit Reader(const CsvInput& input) : input_(input), row_(input.csv_.header()) {}

    void Read(const Block& block, Rows& rows) {
      row_.Start(block);
      while (row_.Next()) {
        ArmCommand command = input_.unless_given_;
        for (const ReadColumn& column : input_.columns_) {
          command.*column.angle_rad = RadiansFromDegrees(
              row_.NumberWithin(column.index, column.lower_deg, column.upper_deg));
        }
        rows.lines.push_back(row_.line());
        rows.commands.push_back(command);
      }
    }

   private:
    const CsvInput& input_;
    CsvRows row_;
  };

 private:
  struct ReadColumn {
    std::size_t index;
    double ArmCommand::*angle_rad;
    double lower_deg;
    double upper_deg;
  };

  CsvReader& csv_;
  std::uintmax_t bytes_;
  ArmCommand unless_given_;
  std::vector<ReadColumn> columns_;
};

// All positions of a sweep, those of the first plane first.
class SweepInput {
 public:
  // As many positions as a thread takes at a time: as a CSV has in a block.
  static constexpr std::size_t kBlock = 1024;
  struct Block {
    std::size_t first = 0;
    std::size_t count = 0;
  };

  // The sweep has to outlive it.
  SweepInput(const SweptPositions& sweep, const RowOptions& options)
      : sweep_(sweep), unless_given_(CommandOf(options)) {}

  [[nodiscard]] static std::string header_line() {
    return std::string(kElevationColumn) + "," + kPlaneColumn;
  }
  [[nodiscard]] std::uintmax_t size() const noexcept {
    return sweep_.elevations_deg.size() * sweep_.planes_deg.size();
  }
  [[nodiscard]] static std::uintmax_t SizeOf(const Block& block) noexcept { return block.count; }
  [[nodiscard]] static bool HasRowsAtHand() noexcept { return true; }
  [[nodiscard]] bool Take(Block& block) noexcept {
    block = {taken_, std::min<std::size_t>(kBlock, size() - taken_)};
    taken_ += block.count;
    return block.count > 0;
  }

  class Reader {
   public:
    explicit Reader(const SweepInput& input) : input_(input) {}

    void Read(const Block& block, Rows& rows) {
      const std::vector<double>& elevations_deg = input_.sweep_.elevations_deg;
      text_.clear();
      ends_.clear();
      for (std::size_t i = block.first; i < block.first + block.count; ++i) {
        const double elevation_deg = elevations_deg[i % elevations_deg.size()];
        const double plane_deg = input_.sweep_.planes_deg[i / elevations_deg.size()];
        ArmCommand command = input_.unless_given_;
        command.elevation_rad = RadiansFromDegrees(elevation_deg);
        command.plane_rad = RadiansFromDegrees(plane_deg);
        rows.commands.push_back(command);
        AppendNumber(text_, elevation_deg);
        text_ += ',';
        AppendNumber(text_, plane_deg);
        ends_.push_back(text_.size());
      }
      std::size_t start = 0;
      for (const std::size_t end : ends_) {
        rows.lines.push_back(std::string_view(text_).substr(start, end - start));
        start = end;
      }
    }

   private:
    const SweepInput& input_;
    std::string text_;
    std::vector<std::size_t> ends_;
  };

 private:
  const SweptPositions& sweep_;
  ArmCommand unless_given_;
  std::size_t taken_ = 0;
};

// Workers that each take a block of rows, answer it, and write when all before it is written.
template <typename Input>
class RowWorkers {
 public:
  RowWorkers(Input& input, const RowAnswers& answers, OutputFile& out, TerminalProgress& progress)
      : answers_(answers),
        input_(input),
        out_(out),
        progress_(progress),
        unwritten_header_(input.header_line() + answers.HeaderText()) {}

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
  // A number of successive rows on their way from the input to the output.
  struct Portion {
    std::size_t turn;  // from 0, in the order of the input
    typename Input::Block block;
    std::string answer;
    std::exception_ptr error;
  };

  // What a worker needs and keeps from one portion to the next.
  struct Workplace {
    explicit Workplace(const Input& input) : reader(input) {}

    typename Input::Reader reader;
    Rows rows;
    RowAnswers::Solved solved;
  };

  void Work() {
    Workplace workplace(input_);
    Portion portion;
    while (Take(portion)) {
      if (!portion.error) {
        Answer(portion, workplace);
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
      if (!input_.HasRowsAtHand()) {
        std::unique_lock writing(writing_);
        written_.wait(writing, [this] { return turns_written_ == turns_taken_ || error_; });
        out_.Flush();
      }
      if (is_stopped_ || !input_.Take(portion.block)) {
        return false;
      }
    } catch (...) {
      portion.error = std::current_exception();
    }
    portion.turn = turns_taken_++;
    return true;
  }

  void Answer(Portion& portion, Workplace& workplace) const noexcept {
    portion.answer.clear();
    workplace.rows.Clear();
    try {
      workplace.reader.Read(portion.block, workplace.rows);
      answers_.Append(portion.answer, workplace.rows, workplace.solved);
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
        size_done_ += Input::SizeOf(portion.block);
        if (input_.size() > 0) {
          progress_(
              std::min(1.0, static_cast<double>(size_done_) / static_cast<double>(input_.size())));
        }
        ++turns_written_;
      } catch (...) {
        error_ = std::current_exception();
        is_stopped_ = true;
      }
    }
    written_.notify_all();
  }

  const RowAnswers& answers_;

  // Locked before writing_ where both are.
  std::mutex reading_;
  Input& input_;
  std::size_t turns_taken_ = 0;

  std::mutex writing_;
  std::condition_variable written_;  // or failed
  OutputFile& out_;
  TerminalProgress& progress_;
  std::uintmax_t size_done_ = 0;
  std::string unwritten_header_;  // empty when it is written, which is with the first rows
  std::size_t turns_written_ = 0;
  std::exception_ptr error_;  // the first in the order of the rows
  // As error_ says, for those who do not lock writing_: it is locked while a block is written.
  std::atomic<bool> is_stopped_ = false;
};

template <typename Input>
void SolveInput(Input& input, const RowAnswers& answers, const std::string& out,
                std::size_t threads) {
  OutputFile file(out);
  TerminalProgress progress("solving", out != "-");
  RowWorkers(input, answers, file, progress).Run(threads);
  file.Commit();
}

}  // namespace

void SolveRows(const RowSource& source, const std::string& out, const ShoulderRhythm& rhythm,
               const RowOptions& options) {
  CsvReader csv(source.in, source.name);
  CsvInput input(csv, source.bytes, options);
  const RowAnswers answers(rhythm, options);
  answers.ExpectNoneIn(csv);
  SolveInput(input, answers, out, options.threads);
}

void SolveSweep(const SweptPositions& sweep, const std::string& out, const ShoulderRhythm& rhythm,
                const RowOptions& options) {
  SweepInput input(sweep, options);
  SolveInput(input, RowAnswers(rhythm, options), out, options.threads);
}

}  // namespace girdle
