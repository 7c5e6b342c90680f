// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_rows.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <fstream>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <unordered_set>
#include <utility>
#include <vector>

#include "commands/output_file.h"
#include "commands/progress.h"
#include "commands/shoulder_points.h"
#include "kinematics/solve_many.h"
#include "motions/angle_span.h"
#include "motions/arm_angles.h"
#include "motions/arm_path.h"
#include "motions/command_columns.h"
#include "motions/command_tally.h"
#include "text/csv.h"
#include "text/csv_dialect.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/shown_text.h"
#include "text/text_file.h"

namespace girdle {
namespace {

// An option that gives one value for all rows in place of a column.
struct ColumnOption {
  const char* column;
  const char* option;
  double ArmCommand::*angle_rad;
  std::optional<double> RowOptions::*angle_deg;
};

// Names for the message about a missing header.
constexpr std::array<std::string_view, 2> kExamplePose = {kElevationColumn, kPlaneColumn};

constexpr std::array<ColumnOption, 3> kColumnOptions = {{
    {kAxialColumn, "--axial", &ArmCommand::axial_rad, &RowOptions::axial_deg},
    {kShrugColumn, "--shrug", &ArmCommand::shrug_rad, &RowOptions::shrug_deg},
    {kProtractionColumn, "--protraction", &ArmCommand::protraction_rad,
     &RowOptions::protraction_deg},
}};

// Where the command of a row is from.
enum class CommandSource : unsigned char { kInput, kBridge, kNone };

// Rows that are solved together. `lines` are the input rows that begin the output rows.
struct Rows {
  std::vector<std::string_view> lines;
  std::vector<ArmCommand> commands;
  std::vector<CommandSource> sources;
  AngleSpan span;  // of the numbers, if the user did not give the unit

  void Add(std::string_view line, const ArmCommand& command, CommandSource source) {
    lines.push_back(line);
    commands.push_back(command);
    sources.push_back(source);
  }

  void Clear() noexcept {
    lines.clear();
    commands.clear();
    sources.clear();
    span = {};
  }
};

// Returns the values of a row for which it has no columns.
ArmCommand CommandOf(const RowOptions& options) noexcept {
  ArmCommand command;
  for (const ColumnOption& option : kColumnOptions) {
    if (options.*option.angle_deg) {
      command.*option.angle_rad = RadiansFromDegrees(*(options.*option.angle_deg));
    }
  }
  if (options.axial_deg) {
    command.axial_from = options.reading.axial_from;
  }
  return command;
}

// Returns the zero that an option's axial turn of all rows counts from, if there is such an option.
std::optional<AxialFrom> AxialFromOfAll(const RowOptions& options) noexcept {
  return options.axial_deg ? std::optional(options.reading.axial_from) : std::nullopt;
}

// Writes the columns that follow each row. Immutable, because threads share it.
class RowAnswers {
 public:
  // `rhythm` and `options` must outlive it. `dialect` is that of the rows.
  RowAnswers(const ShoulderRhythm& rhythm, const RowOptions& options, const CsvDialect& dialect)
      : rhythm_(rhythm),
        output_(options.output),
        separator_(dialect.separator),
        columns_(SolveColumns(output_, dialect)) {}

  // Returns the header of the added columns, to follow the input's header, with a line end.
  [[nodiscard]] std::string HeaderText() const { return separator_ + columns_.Header() + "\n"; }

  // Results for rows. Each thread keeps one, so that memory is allocated once.
  struct Solved {
    std::vector<ShoulderPose> poses;
    std::vector<JointAngles> angles_rad;
    std::vector<ArmCommand> used;
    std::vector<Origin> origins;
    std::vector<double> distances_rad;
  };

  [[nodiscard]] Range range() const noexcept { return *rhythm_.options().range; }

  // The origin of the hanging arm that rotations are counted from, if they are.
  [[nodiscard]] std::optional<Origin> hanging() const noexcept {
    return output_.since ? std::optional(output_.since_origin) : std::nullopt;
  }

  // Solves rows and appends each with its answer to `text`. Returns their tally.
  CommandTally Append(std::string& text, const Rows& rows, Solved& solved) const {
    const std::size_t count = rows.commands.size();
    solved.poses.resize(count);
    solved.angles_rad.resize(count);
    solved.used.resize(count);
    solved.origins.resize(count);
    solved.distances_rad.resize(count);
    SolveMany(rhythm_, rows.commands,
              {solved.poses, solved.angles_rad, solved.used, solved.origins, solved.distances_rad});
    CommandTally tally;
    for (std::size_t i = 0; i < count; ++i) {
      if (rows.sources[i] == CommandSource::kNone) {
        text += rows.lines[i];
        text.append(columns_.names().size(), separator_);
        text += '\n';
        ++tally.rows;
        ++tally.gaps;
        continue;
      }
      tally.bridged += rows.sources[i] == CommandSource::kBridge ? 1 : 0;
      tally.Add(rhythm_, rows.commands[i], solved.used[i], solved.origins[i],
                solved.distances_rad[i]);
      SolvedRow row{{},
                    {},
                    rhythm_.IsClamped(rows.commands[i], solved.used[i]),
                    solved.used[i],
                    solved.distances_rad[i],
                    solved.origins[i],
                    rhythm_.AxialOf(AxialFrom::kIsb, solved.poses[i], solved.used[i]),
                    std::nullopt,
                    {},
                    rows.sources[i] == CommandSource::kBridge};
      AddRotations(row, solved.poses[i], solved.angles_rad[i]);
      if (output_.derivatives) {
        row.rates = rhythm_.SolveRates(rows.commands[i]);
      }
      if (output_.points_of) {
        row.points = ShoulderPoints(*output_.points_of, solved.poses[i]);
      }
      text += rows.lines[i];
      text += separator_;
      columns_.Append(text, row);
      text += '\n';
    }
    return tally;
  }

 private:
  // The angles of the joints are known, and taking them is faster than computing them again.
  void AddRotations(SolvedRow& row, const ShoulderPose& pose, const JointAngles& joints_rad) const {
    if (output_.form == RotationForm::kQuaternions) {
      row.rotations = RotationsOf(pose, output_.since);
    } else if (output_.since) {
      row.angles_rad = AnglesOf(RotationsOf(pose, output_.since));
    } else {
      row.angles_rad = WithScapulothoracic(joints_rad, pose.q_TS());
    }
  }

  const ShoulderRhythm& rhythm_;
  const SolveOutput& output_;
  char separator_;
  WrittenColumns<SolvedRow, RoundedNumbers> columns_;
};

// Throws InputError at the header if a column would be twice in the output.
void ExpectNoAnswersIn(const CsvReader& csv, const SolveOutput& output) {
  const std::unordered_set<std::string_view> given(csv.columns().begin(), csv.columns().end());
  const auto columns = SolveColumns(output);
  for (const std::string& name : columns.names()) {
    if (given.contains(name)) {
      csv.Fail("column '" + name + "' would be there twice in the output. Rename it in the input");
    }
  }
}

// Rows of a CSV. One thread at a time takes a block; all threads read their blocks at once. If gaps
// are bridged, the thread that takes a block reads it, too, because a gap may begin in another
// block. Most of the time is spent on solving in either case.
class CsvInput {
 public:
  // A row of a block that is read when the block is taken.
  struct ReadRow {
    std::size_t begin;  // in the block's text
    std::size_t size;
    ArmCommand command;
    CommandSource source;
  };
  struct Block {
    CsvBlock csv;
    std::vector<ReadRow> rows;  // if gaps are bridged
    AngleSpan span;             // of `rows`
  };

  // Throws InputError at the header if a column is missing, or if it is given beside the option
  // that replaces it. The reader must outlive it.
  CsvInput(CsvReader& csv, std::uintmax_t bytes, const RowOptions& options)
      : csv_(csv),
        bytes_(bytes),
        gaps_(options.gaps),
        unless_given_(CommandOf(options)),
        axial_from_of_all_(AxialFromOfAll(options)),
        columns_(csv, options.reading, options.columns),
        bridged_row_(csv.header()) {
    for (const ColumnOption& option : kColumnOptions) {
      const std::optional<std::size_t> column = columns_.names().Find(option.column);
      if (column && options.*option.angle_deg) {
        csv.Fail("the column " + ShortText(csv.columns()[*column]) + " and " + option.option +
                 " exclude each other. Remove one");
      }
    }
  }

  // Name in messages.
  [[nodiscard]] const std::string& name() const noexcept { return csv_.name(); }
  // The header as it stands, behind the line that names the separator if there is one.
  [[nodiscard]] std::string header_line() const {
    const std::string& separator_line = csv_.header().dialect.separator_line;
    return separator_line.empty() ? csv_.header_line() : separator_line + "\n" + csv_.header_line();
  }
  // The zero that axial turns count from; nothing if there are none.
  [[nodiscard]] std::optional<AxialFrom> axial_from() const noexcept {
    return axial_from_of_all_ ? axial_from_of_all_ : columns_.axial_from();
  }
  // Names that are read as known columns; empty if there are none.
  [[nodiscard]] std::string NamesNote() const { return columns_.names().Note(); }
  // Total of SizeOf over all blocks; 0 if not known.
  [[nodiscard]] std::uintmax_t size() const noexcept { return bytes_ / csv_.bytes_per_unit(); }
  [[nodiscard]] static std::uintmax_t SizeOf(const Block& block) noexcept {
    return block.csv.text.size();
  }
  [[nodiscard]] bool HasRowsAtHand() { return csv_.HasLinesAtHand(); }
  [[nodiscard]] bool Take(Block& block) {
    return gaps_.bridged_rows > 0 ? TakeBridged(block) : csv_.TakeBlock(block.csv);
  }

  // Reads the rows of one block after the other, in one thread. The rows refer to the block.
  class Reader {
   public:
    explicit Reader(const CsvInput& input) : input_(input), row_(input.csv_.header()) {}

    void Read(const Block& block, Rows& rows) {
      if (input_.gaps_.bridged_rows > 0) {
        for (const ReadRow& row : block.rows) {
          rows.Add(std::string_view(block.csv.text).substr(row.begin, row.size), row.command,
                   row.source);
        }
        rows.span = block.span;
        return;
      }
      row_.Start(block.csv);
      while (row_.Next()) {
        const std::optional<ArmCommand> command =
            input_.columns_.Read(row_, input_.unless_given_, rows.span);
        if (!command && input_.gaps_.rule == GapRule::kRefuse) {
          row_.Fail(input_.columns_.GapText(row_) + ". " + kGapMend);
        }
        rows.Add(row_.line(), command.value_or(input_.unless_given_),
                 command ? CommandSource::kInput : CommandSource::kNone);
      }
    }

   private:
    const CsvInput& input_;
    CsvRows row_;
  };

 private:
  static constexpr const char* kGapMend = "Fill it, or give --bridge-gaps ROWS or --gaps keep";

  // Takes the next rows and bridges the gaps in them. Rows of a gap that may end in the next block
  // are held back.
  [[nodiscard]] bool TakeBridged(Block& block) {
    CsvBlock next;
    const bool has_more = csv_.TakeBlock(next);
    if (!has_more && held_.text.empty()) {
      return false;
    }
    block.csv.first_line_number =
        held_.text.empty() ? next.first_line_number : held_.first_line_number;
    block.csv.text = std::exchange(held_.text, {}) + next.text;
    block.rows.clear();
    block.span = {};
    bridged_row_.Start(block.csv);
    while (bridged_row_.Next()) {
      const std::string_view line = bridged_row_.line();
      const std::optional<ArmCommand> command =
          columns_.Read(bridged_row_, unless_given_, block.span);
      block.rows.push_back({static_cast<std::size_t>(line.data() - block.csv.text.data()),
                            line.size(), command.value_or(unless_given_),
                            command ? CommandSource::kInput : CommandSource::kNone});
    }
    BridgeGaps(block, has_more);
    return true;
  }

  void BridgeGaps(Block& block, bool has_more) {
    std::vector<ReadRow>& rows = block.rows;
    for (std::size_t i = 0; i < rows.size();) {
      if (rows[i].source == CommandSource::kInput) {
        before_ = rows[i++].command;
        continue;
      }
      std::size_t end = i;
      while (end < rows.size() && rows[end].source == CommandSource::kNone) {
        ++end;
      }
      const bool is_short = before_ && end - i <= gaps_.bridged_rows;
      if (is_short && end == rows.size() && has_more) {
        held_.text = block.csv.text.substr(rows[i].begin);
        held_.first_line_number = block.csv.first_line_number + i;
        block.csv.text.resize(rows[i].begin);
        rows.resize(i);
        return;
      }
      if (is_short && end < rows.size()) {
        Bridge(rows, i, end);
      } else if (gaps_.rule == GapRule::kRefuse) {
        throw InputError(name(), block.csv.first_line_number + i,
                         "a gap that --bridge-gaps " + std::to_string(gaps_.bridged_rows) +
                             " does not bridge: it is longer, or at an end of the file. Fill it, "
                             "or give more rows or --gaps keep");
      } else if (end == rows.size()) {
        before_.reset();  // the gap is too long, whatever follows
      }
      i = end;
    }
  }

  // Gives commands to the rows of a gap, [begin, end).
  void Bridge(std::vector<ReadRow>& rows, std::size_t begin, std::size_t end) const {
    std::vector<ArmCommand> commands(end - begin);
    BridgeCommands(*before_, rows[end].command, commands);
    for (std::size_t i = begin; i < end; ++i) {
      rows[i].command = commands[i - begin];
      rows[i].source = CommandSource::kBridge;
    }
  }

  CsvReader& csv_;
  std::uintmax_t bytes_;
  GapReading gaps_;
  ArmCommand unless_given_;
  std::optional<AxialFrom> axial_from_of_all_;
  CommandColumns columns_;
  CsvRows bridged_row_;  // of the block that is taken, if gaps are bridged
  CsvBlock held_;        // rows of a gap at the end of the block before
  // The command of the row before a gap; nothing if there is none near enough.
  std::optional<ArmCommand> before_;
};

// All positions of a sweep, those of the first plane first.
class SweepInput {
 public:
  // As many positions as a thread takes at a time, about as many as a block of a CSV has.
  static constexpr std::size_t kBlock = 1024;
  struct Block {
    std::size_t first = 0;
    std::size_t count = 0;
  };

  // `sweep` must outlive it.
  SweepInput(const SweptPositions& sweep, const RowOptions& options)
      : sweep_(sweep),
        unless_given_(CommandOf(options)),
        axial_from_(AxialFromOfAll(options)),
        header_line_(std::string(kElevationColumn) + "," + kPlaneColumn) {
    for (const double elevation_deg : sweep.elevations_deg) {
      elevations_rad_.push_back(
          RadiansFromDegrees(ElevationRead_deg(elevation_deg, options.reading.convention)));
    }
    for (const ColumnOption& option : kColumnOptions) {
      if (const std::optional<double>& angle_deg = options.*option.angle_deg) {
        header_line_ += "," + std::string(option.column);
        behind_directions_ += "," + NumberText(*angle_deg);
      }
    }
  }

  [[nodiscard]] static std::string name() { return "--elevation, --plane"; }
  [[nodiscard]] static std::string NamesNote() { return {}; }
  [[nodiscard]] const std::string& header_line() const noexcept { return header_line_; }
  [[nodiscard]] std::optional<AxialFrom> axial_from() const noexcept { return axial_from_; }
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
      const std::size_t elevations = input_.elevations_rad_.size();
      text_.clear();
      ends_.clear();
      commands_.clear();
      for (std::size_t i = block.first; i < block.first + block.count; ++i) {
        const double plane_deg = input_.sweep_.planes_deg[i / elevations];
        ArmCommand command = input_.unless_given_;
        command.elevation_rad = input_.elevations_rad_[i % elevations];
        command.plane_rad = RadiansFromDegrees(PlaneRead_deg(plane_deg));
        commands_.push_back(command);
        AppendNumber(text_, input_.sweep_.elevations_deg[i % elevations]);
        text_ += ',';
        AppendNumber(text_, plane_deg);
        text_ += input_.behind_directions_;
        ends_.push_back(text_.size());
      }
      std::size_t start = 0;
      for (std::size_t i = 0; i < ends_.size(); ++i) {
        rows.Add(std::string_view(text_).substr(start, ends_[i] - start), commands_[i],
                 CommandSource::kInput);
        start = ends_[i];
      }
    }

   private:
    const SweepInput& input_;
    std::string text_;
    std::vector<std::size_t> ends_;  // of rows in text_
    std::vector<ArmCommand> commands_;
  };

 private:
  const SweptPositions& sweep_;
  std::vector<double> elevations_rad_;  // with Girdle's sign
  ArmCommand unless_given_;
  std::optional<AxialFrom> axial_from_;
  std::string header_line_;
  std::string behind_directions_;  // columns that options give to every row
  std::size_t taken_ = 0;
};

// Workers that each take a block of rows, answer it, and write it after all earlier blocks.
template <typename Input>
class RowWorkers {
 public:
  RowWorkers(Input& input, const RowAnswers& answers, OutputFile& out, TerminalProgress& progress)
      : answers_(answers),
        input_(input),
        out_(out),
        progress_(progress),
        unwritten_header_(input.header_line() + answers.HeaderText()) {}

  // Answers all rows with `threads` threads and returns their tally. Throws the first error in the
  // order of the rows.
  CommandTally Run(std::size_t threads) {
    std::vector<std::jthread> workers;
    // If there are several workers, this thread is none of them: the memory that it writes is next
    // to memory that all workers read, and they would wait for each other's caches.
    for (std::size_t i = 0; threads > 1 && i < threads; ++i) {
      try {
        workers.emplace_back([this] { Work(); });
      } catch (const std::system_error&) {
        break;  // the system gives no more threads; those that run suffice
      }
    }
    if (workers.empty()) {
      Work();
    }
    workers.clear();  // waits for them
    if (error_) {
      std::rethrow_exception(error_);
    }
    span_.ExpectKnownUnit(input_.name());
    out_.Write(unwritten_header_);
    return tally_;
  }

 private:
  // A number of successive rows on their way from the input to the output.
  struct Portion {
    std::size_t turn;  // from 0, in the order of the input
    typename Input::Block block;
    std::string answer;
    CommandTally tally;
    AngleSpan span;
    std::exception_ptr error;
  };

  // Memory that a worker keeps from one portion to the next.
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

  // Takes the next rows, or the error in their place. Returns false if no rows are left. Before it
  // waits for input, it waits until all answers are written or an error has occurred.
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
      portion.tally = answers_.Append(portion.answer, workplace.rows, workplace.solved);
      portion.span = workplace.rows.span;
    } catch (...) {
      portion.error = std::current_exception();
    }
  }

  // Writes the answer when its turn comes. After an error nothing more is written.
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
        tally_.Add(portion.tally);
        span_.Add(portion.span);
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

  // Is locked before writing_ where both are locked.
  std::mutex reading_;
  Input& input_;
  std::size_t turns_taken_ = 0;

  std::mutex writing_;
  std::condition_variable written_;  // a portion was written, or an error has occurred
  OutputFile& out_;
  TerminalProgress& progress_;
  std::uintmax_t size_done_ = 0;
  CommandTally tally_;  // of the rows that are written
  AngleSpan span_;
  std::string unwritten_header_;  // empty after it was written with the first rows
  std::size_t turns_written_ = 0;
  std::exception_ptr error_;  // the first in the order of the rows
  // Whether error_ is set, for threads that do not lock writing_, which is locked during a write.
  std::atomic<bool> is_stopped_ = false;
};

template <typename Input>
void SolveInput(Input& input, const RowAnswers& answers, const std::string& out,
                std::size_t threads) {
  OutputFile file(out);
  TerminalProgress progress("solving", out != "-");
  const CommandTally tally = RowWorkers(input, answers, file, progress).Run(threads);
  file.Commit();
  progress.Clear();
  if (const std::string note = input.NamesNote(); !note.empty()) {
    PrintNote(input.name() + ": " + note);
  }
  const std::string content = TallyText(
      tally,
      {.range = answers.range(), .axial_from = input.axial_from(), .hanging = answers.hanging()});
  if (out == "-") {
    PrintNote(input.name() + ": " + content);
  } else {
    NoteWritten(out, content);
  }
}

}  // namespace

void SolveRows(const RowSource& source, const std::string& out, const ShoulderRhythm& rhythm,
               const RowOptions& options) {
  CsvReader csv(source.in, source.name, kExamplePose);
  CsvInput input(csv, source.bytes, options);
  ExpectNoAnswersIn(csv, options.output);
  csv.FindDecimalMark();
  SolveInput(input, RowAnswers(rhythm, options, csv.header().dialect), out, options.threads);
}

void ExpectKnownUnit(const std::string& path, const AngleReading& reading,
                     const std::vector<NamedColumn>& names) {
  if (reading.unit) {
    return;
  }
  std::ifstream in = OpenTextFile(path);
  CsvReader csv(in, path, kExamplePose);
  const CommandColumns columns(csv, reading, names);
  AngleSpan span;
  while (span.IsWithinRadians() && csv.Next()) {
    static_cast<void>(columns.Read(csv.row(), {}, span));
  }
  span.ExpectKnownUnit(path);
}

void SolveSweep(const SweptPositions& sweep, const std::string& out, const ShoulderRhythm& rhythm,
                const RowOptions& options) {
  SweepInput input(sweep, options);
  SolveInput(input, RowAnswers(rhythm, options, {}), out, options.threads);
}

}  // namespace girdle
