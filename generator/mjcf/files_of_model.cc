// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/files_of_model.h"

#include <tinyxml2.h>

#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "mjcf/model_elements.h"

namespace girdle {
namespace {

namespace fs = std::filesystem;

// Names of files in the order of their file, and the folders in which they may be.
class FileSearch {
 public:
  explicit FileSearch(const std::string& model) {
    VisitElements(model, [this](const tinyxml2::XMLElement& element, const fs::path& file) {
      Read(element, file.parent_path());
    });
  }

  [[nodiscard]] std::vector<std::string> Found() const {
    std::set<std::string> found;
    for (const Name& name : names_) {
      for (const fs::path& folder : folders_) {
        AddThoseIn(folder, name.file, found);
        for (const fs::path& assets : asset_folders_) {
          AddThoseIn(folder / assets, name.file, found);
          // After the folders of assets, MuJoCo also tries the folder of the file that has the
          // name: as it was typed, or relative to the model's own folder.
          if (name.folder != folder && !name.folder.empty()) {
            AddThoseIn(folder / assets / name.folder, name.file, found);
            AddThoseIn(folder / assets / name.folder.lexically_relative(folder), name.file, found);
          }
        }
      }
    }
    return {found.begin(), found.end()};
  }

 private:
  struct Name {
    fs::path file;
    fs::path folder;  // of the file that has the name
  };

  void Read(const tinyxml2::XMLElement& element, const fs::path& folder) {
    folders_.insert(folder);
    const bool is_compiler = element.Name() == std::string_view("compiler");
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      const std::string_view name = attribute->Name();
      if (is_compiler && name.ends_with("dir")) {
        asset_folders_.insert(attribute->Value());
      } else if (name.starts_with("file")) {  // a cube texture has six: fileright, ...
        names_.push_back({attribute->Value(), folder});
      }
    }
  }

  // Adds existing files. With strippath, MuJoCo uses only the last part of a name.
  static void AddThoseIn(const fs::path& folder, const fs::path& file,
                         std::set<std::string>& found) {
    std::error_code unclear;
    for (const fs::path& place : {folder / file, folder / file.filename()}) {
      if (fs::is_regular_file(place, unclear)) {
        found.insert(place.string());
      }
    }
  }

  std::set<fs::path> folders_;  // of the model and of the files that it includes or attaches
  std::set<fs::path> asset_folders_;
  std::vector<Name> names_;
};

}  // namespace

std::vector<std::string> FilesOfModel(const std::string& model) {
  return FileSearch(model).Found();
}

}  // namespace girdle
