// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/named_elements.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "text/input_error.h"

namespace girdle {
namespace {

constexpr std::size_t kNamesShown = 3;

// Levenshtein's distance, row by row.
std::size_t LettersChanged(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

int CountOf(const mjModel& model, mjtObj type) {
  switch (type) {
    case mjOBJ_BODY:
      return static_cast<int>(model.nbody);
    case mjOBJ_SITE:
      return static_cast<int>(model.nsite);
    case mjOBJ_JOINT:
      return static_cast<int>(model.njnt);
    case mjOBJ_ACTUATOR:
      return static_cast<int>(model.nactuator);
    default:
      return 0;
  }
}

}  // namespace

std::vector<std::string> NearestNames(const std::string& wanted,
                                      const std::vector<std::string>& names, std::size_t count) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  ranked.reserve(names.size());
  for (const std::string& name : names) {
    ranked.emplace_back(LettersChanged(wanted, name), name);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> nearest;
  for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) {
    nearest.push_back(ranked[i].second);
  }
  return nearest;
}

std::vector<std::string> ElementNames(const mjModel& model, mjtObj type) {
  std::vector<std::string> names;
  for (int i = 0; i < CountOf(model, type); ++i) {
    const char* name = mj_id2name(&model, type, i);
    // The world is not a bone.
    if (name != nullptr && !(type == mjOBJ_BODY && i == 0)) {
      names.emplace_back(name);
    }
  }
  return names;
}

int FindElement(const mjModel& model, mjtObj type, const std::string& name, const std::string& file,
                std::size_t line) {
  const int id = mj_name2id(&model, type, name.c_str());
  if (id >= 0) {
    return id;
  }
  const std::vector<std::string> names = ElementNames(model, type);
  const std::string kind = mju_type2Str(type);
  std::string message = "the model has no " + kind + " '" + name + "'";
  if (names.empty()) {
    message += " and none with a name";
  } else {
    message += ". The nearest are: ";
    bool first = true;
    for (const std::string& near : NearestNames(name, names, kNamesShown)) {
      message += (first ? "" : ", ") + near;
      first = false;
    }
  }
  throw InputError(file, line, message);
}

}  // namespace girdle
