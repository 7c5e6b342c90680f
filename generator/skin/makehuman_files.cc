// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/makehuman_files.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "skin/json_fault.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

// Reads the lines of a text file and the words of each line.
class WordLines {
 public:
  WordLines(std::istream& in, const std::string& name) : in_(in), name_(name) {}

  // Goes to the next line that is neither empty nor a comment. Returns false at the end.
  bool Next() {
    while (std::getline(in_, line_)) {
      ++line_number_;
      words_.clear();
      std::string_view rest(line_);
      for (;;) {
        const std::size_t begin = rest.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) break;
        rest.remove_prefix(begin);
        const std::size_t length = std::min(rest.find_first_of(" \t\r"), rest.size());
        words_.push_back(rest.substr(0, length));
        rest.remove_prefix(length);
      }
      if (!words_.empty() && words_[0].front() != '#') return true;
    }
    if (in_.bad()) throw InputError(name_ + ": cannot be read");
    return false;
  }

  [[nodiscard]] std::string_view word(std::size_t i) const { return words_[i]; }

  void ExpectWords(std::size_t count, const std::string& what) const {
    if (words_.size() != count) Fail("expected " + what);
  }
  [[nodiscard]] double Number(std::size_t i) const {
    const std::optional<double> number = FiniteNumber(words_[i]);
    if (!number) Fail("'" + ShortText(words_[i]) + "' is not a finite number");
    return *number;
  }
  // Returns the number of a vertex, below `count`. The file counts vertices from `first`.
  [[nodiscard]] int Vertex(std::string_view word, std::size_t count, int first) const {
    int number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || number < first ||
        number - first >= static_cast<int>(count)) {
      Fail("'" + ShortText(word) + "' is none of the " + std::to_string(count) + " vertices");
    }
    return number - first;
  }
  [[noreturn]] void Fail(const std::string& message) const {
    throw InputError(name_, line_number_, message);
  }

 private:
  std::istream& in_;
  const std::string& name_;
  std::string line_;
  std::vector<std::string_view> words_;
  std::size_t line_number_ = 0;
};

}  // namespace

MakeHumanMesh ReadMakeHumanMesh(std::istream& in, const std::string& name) {
  MakeHumanMesh mesh;
  std::vector<Quad>* group = nullptr;
  WordLines lines(in, name);
  while (lines.Next()) {
    const std::string_view kind = lines.word(0);
    if (kind == "v") {
      lines.ExpectWords(4, "'v x y z'");
      mesh.vertices_dm.emplace_back(lines.Number(1), lines.Number(2), lines.Number(3));
    } else if (kind == "f") {
      lines.ExpectWords(5, "a face of four corners, 'f 1/1 2/2 3/3 4/4'");
      if (group == nullptr) lines.Fail("a face that is in no group. Begin one above, 'g body'");
      Quad quad{};
      for (std::size_t corner = 0; corner < quad.size(); ++corner) {
        const std::string_view word = lines.word(corner + 1);
        quad[corner] = lines.Vertex(word.substr(0, word.find('/')), mesh.vertices_dm.size(), 1);
      }
      group->push_back(quad);
    } else if (kind == "g") {
      lines.ExpectWords(2, "'g name'");
      group = &mesh.groups[std::string(lines.word(1))];
    } else if (kind != "vt" && kind != "s") {
      lines.Fail("'" + ShortText(kind) + "' is not known, expected v, vt, f, g or s");
    }
  }
  return mesh;
}

void AddMakeHumanTarget(std::istream& in, const std::string& name, double share,
                        std::vector<Vector3>& vertices_dm) {
  WordLines lines(in, name);
  while (lines.Next()) {
    lines.ExpectWords(4, "a vertex and how far it moves, '0 x y z'");
    const int vertex = lines.Vertex(lines.word(0), vertices_dm.size(), 0);
    vertices_dm[static_cast<std::size_t>(vertex)] +=
        share * Vector3{lines.Number(1), lines.Number(2), lines.Number(3)};
  }
}

MakeHumanWeights ReadMakeHumanWeights(std::istream& in, const std::string& name,
                                      std::size_t vertex_count) {
  MakeHumanWeights weights;
  try {
    const nlohmann::json json = nlohmann::json::parse(in);
    for (const auto& [bone, shares] : json.at("weights").items()) {
      for (const nlohmann::json& pair : shares) {
        // A conversion of a number that is not whole may be undefined.
        if (pair.at(0).is_number_float()) {
          throw InputError(name + ": bone '" + ShortText(bone) + "' has vertex " +
                           pair.at(0).dump() + ", which is no whole number");
        }
        const auto vertex = pair.at(0).get<std::int64_t>();
        const auto share = pair.at(1).get<double>();
        if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertex_count)) {
          throw InputError(name + ": bone '" + ShortText(bone) + "' has vertex " +
                           std::to_string(vertex) + ", which is none of the " +
                           std::to_string(vertex_count));
        }
        if (!(share >= 0 && share <= 1)) {
          throw InputError(name + ": bone '" + ShortText(bone) + "' has a share of " +
                           NumberText(share) + " in vertex " + std::to_string(vertex) +
                           ", expected 0 to 1");
        }
        weights[bone].emplace_back(static_cast<int>(vertex), share);
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError(name + ": not the weights of a rig: " + JsonFault(error));
  }
  return weights;
}

}  // namespace girdle
