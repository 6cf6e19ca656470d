#include "apps/import/model.h"

#include <assimp/scene.h>
#include <assimp/version.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace soms::import_program {

namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 20;

constexpr std::uint32_t kNoVertex = 0xffffffffU;

/// Three rows of four.
using Affine = std::array<double, 12>;

Affine affine_of(const aiMatrix4x4& m) {
  return {m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4};
}

/// First `b`, then `a`.
Affine product(const Affine& a, const Affine& b) {
  Affine result{};
  for (std::size_t i = 0; i < 12; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      result[i + k] =
          a[i] * b[k] + a[i + 1] * b[k + 4] + a[i + 2] * b[k + 8] + (k == 3 ? a[i + 3] : 0);
    }
  }
  return result;
}

bool mirrors(const Affine& m) {
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
             m[2] * (m[4] * m[9] - m[5] * m[8]) <
         0;
}

/// A node whose children are to come. Nodes may nest as deep as a file has bytes: no recursion.
struct Frame {
  const aiNode* node = nullptr;
  unsigned next = 0;
  Affine transform{};
  bool named = false;
};

/// True if a transform makes z, and nothing else, y: Assimp's turn of what stands on its xy plane.
bool turns_z_to_y(const Affine& m) {
  constexpr double kRounding = 1e-6;
  return m[6] > 0 && std::abs(m[4]) + std::abs(m[5]) <= kRounding * m[6];
}

/// Turned back: y becomes z, z becomes -y.
Affine turned_back(const Affine& m) {
  return {m[0],     m[1],     m[2],      m[3],  //
          0 - m[8], 0 - m[9], 0 - m[10], 0 - m[11], m[4], m[5], m[6], m[7]};
}

template <std::size_t N>
bool is_among(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Formats whose root node is Assimp's own and may turn them.
constexpr std::array<std::string_view, 13> kOwnRoot = {
    ".ase", ".ask",     ".blend", ".dxf", ".hmp",  ".ifc", ".md2",
    ".md3", ".md5mesh", ".mdc",   ".mdl", ".step", ".stp"};
/// IFC: lengths are made meters, z is up.
constexpr std::array<std::string_view, 3> kBuildings = {".ifc", ".step", ".stp"};
/// Formats whose axes are left-handed; Assimp negates z.
constexpr std::array<std::string_view, 3> kLeftHanded = {".lwo", ".lxo", ".x"};
/// Formats whose files may state a unit that Assimp does not give.
constexpr std::array<std::string_view, 3> kUnitNotRead = {".3mf", ".amf", ".dxf"};

/// What a file says that a float was read from: 0.1, not 0.100000001490116.
double shortest_decimal(float number) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), number);
  double decimal = number;
  std::from_chars(text.data(), written.ptr, decimal);
  return decimal;
}

class SceneWriter {
 public:
  SceneWriter(const aiScene& scene, std::string_view extension, Answer& answer)
      : scene_(scene), extension_(extension), answer_(answer) {}

  void write();

 private:
  void enter(const aiNode& node);
  void tell_axes(bool turned);
  std::string tell_settings();
  void write_mesh(const aiMesh& mesh, const Affine& transform);

  const aiScene& scene_;
  std::string_view extension_;
  Answer& answer_;
  std::vector<Frame> stack_;
  std::uint32_t vertices_ = 0;
  std::uint64_t thin_ = 0;
  std::vector<std::uint32_t> corners_;
};

void SceneWriter::write_mesh(const aiMesh& mesh, const Affine& m) {
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& v = mesh.mVertices[i];
    const double x = v.x;
    const double y = v.y;
    const double z = v.z;
    answer_.vertex(m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7],
                   m[8] * x + m[9] * y + m[10] * z + m[11]);
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    corners_.assign(face.mIndices, face.mIndices + face.mNumIndices);
    if (corners_.size() < 3) {
      ++thin_;
      continue;
    }
    for (std::uint32_t& corner : corners_) {
      // One that does not exist is named so that it cannot be taken for one that does.
      corner = corner < mesh.mNumVertices ? corner + vertices_ : kNoVertex;
    }
    if (mirrors(m)) {
      std::reverse(corners_.begin() + 1, corners_.end());
    }
    answer_.face(corners_);
  }
  vertices_ += mesh.mNumVertices;
}

void SceneWriter::tell_axes(bool turned) {
  const bool building = is_among(extension_, kBuildings);
  std::string note = "read by Assimp " + std::to_string(aiGetVersionMajor()) + "." +
                     std::to_string(aiGetVersionMinor()) + "." +
                     std::to_string(aiGetVersionPatch()) + ": coordinates are floats, ";
  if (building) {
    answer_.unit(1);
    note += "lengths became meters, ";
  }
  if (turned) {
    note += "its rotation from z up to y up was undone";
  }
  if (turned && building) {
    answer_.up('z');
  }
  if (!turned && is_among(extension_, kLeftHanded)) {
    note += "z is negated, since the format's axes are left-handed";
  } else if (!turned) {
    note += extension_ == ".fbx" ? tell_settings() : "axes and unit as it gives them";
  }
  if (is_among(extension_, kUnitNotRead)) {
    note += "; the unit is not read, even if the file states one";
  }
  if (extension_ == ".ifc") {
    note +=
        "; names are Assimp's: GUIDs, types and storeys are read where web-ifc is "
        "installed (npm install -g web-ifc)";
  }
  answer_.note(note);
}

/// What an FBX file says of its unit, in centimeters, and its axes; Assimp applies neither.
std::string SceneWriter::tell_settings() {
  const char* const unknown = "axes and unit as it gives them";
  const aiMetadata* const said = scene_.mMetaData;
  if (said == nullptr) {
    return unknown;
  }
  double unit = 0;
  float rough = 0;
  if (!said->Get("UnitScaleFactor", unit) && said->Get("UnitScaleFactor", rough)) {
    unit = shortest_decimal(rough);
  }
  if (unit > 0) {
    answer_.unit(unit / 100);
  }
  std::int32_t up = -1;
  std::int32_t sign = 0;
  if (!said->Get("UpAxis", up) || !said->Get("UpAxisSign", sign) || up < 0 || up > 2) {
    return unknown;
  }
  const char axis = "xyz"[up];
  if (sign != 1) {
    // There is no record for it: the axis stays unknown.
    return std::string("axes are the file's, which declares that ") + axis +
           " points down; so the up axis is unknown";
  }
  answer_.up(axis);
  return unit > 0 ? "unit and axes are the file's" : "axes are the file's";
}

void SceneWriter::enter(const aiNode& node) {
  Frame frame{&node, 0, affine_of(node.mTransformation), false};
  if (!stack_.empty()) {
    frame.transform = product(stack_.back().transform, frame.transform);
    frame.named = node.mName.length > 0;
  } else if (is_among(extension_, kOwnRoot)) {
    const bool turned = turns_z_to_y(frame.transform);
    frame.transform = turned ? turned_back(frame.transform) : frame.transform;
    tell_axes(turned);
  } else {
    tell_axes(false);
  }
  if (frame.named) {
    answer_.begin_part(node.mName.C_Str());
  }
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
    const bool named = mesh.mName.length > 0 && (node.mNumMeshes > 1 || !frame.named);
    if (named) {
      answer_.begin_part(mesh.mName.C_Str());
    }
    write_mesh(mesh, frame.transform);
    if (named) {
      answer_.end_part();
    }
  }
  stack_.push_back(frame);
}

void SceneWriter::write() {
  enter(*scene_.mRootNode);
  while (!stack_.empty()) {
    Frame& frame = stack_.back();
    if (frame.next < frame.node->mNumChildren) {
      const aiNode& child = *frame.node->mChildren[frame.next++];
      enter(child);
      continue;
    }
    if (frame.named) {
      answer_.end_part();
    }
    stack_.pop_back();
  }
  if (thin_ > 0) {
    answer_.note("points and lines, which are not triangles: " + std::to_string(thin_));
  }
}

}  // namespace

Answer::Answer() {
  bytes_.reserve(kBuffer + 64);
  bytes_ = "soms-import 1\n";
}

void Answer::flush() {
  whole_ = whole_ && std::fwrite(bytes_.data(), 1, bytes_.size(), stdout) == bytes_.size();
  bytes_.clear();
}

void Answer::number(std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes_ += static_cast<char>(value >> shift & 0xffU);
  }
}

void Answer::coordinate(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  number(static_cast<std::uint32_t>(bits));
  number(static_cast<std::uint32_t>(bits >> 32));
}

void Answer::text(char kind, std::string_view words) {
  bytes_ += kind;
  number(static_cast<std::uint32_t>(words.size()));
  bytes_ += words;
}

void Answer::vertex(double x, double y, double z) {
  bytes_ += 'v';
  coordinate(x);
  coordinate(y);
  coordinate(z);
  if (bytes_.size() >= kBuffer) {
    flush();
  }
}

void Answer::face(std::span<const std::uint32_t> corners) {
  bytes_ += 'f';
  number(static_cast<std::uint32_t>(corners.size()));
  for (const std::uint32_t corner : corners) {
    number(corner);
  }
  if (bytes_.size() >= kBuffer) {
    flush();
  }
}

void Answer::begin_part(std::string_view name) {
  text('b', name);
}

void Answer::end_part() {
  bytes_ += 'e';
}

void Answer::note(std::string_view words) {
  text('n', words);
}

void Answer::unit(double meters) {
  bytes_ += 'u';
  coordinate(meters);
}

void Answer::up(char axis) {
  bytes_ += 'a';
  bytes_ += axis;
}

bool Answer::finish() {
  bytes_ += '.';
  flush();
  return whole_ && std::fflush(stdout) == 0;
}

void write_scene(const aiScene& scene, std::string_view extension, Answer& answer) {
  SceneWriter(scene, extension, answer).write();
}

}  // namespace soms::import_program
