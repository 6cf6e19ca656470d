#include "soms/io/detail/import/import.h"

#include "soms/base/portable.h"
#include "soms/geometry/detail/counts.h"
#include "soms/io/crs.h"
#include "soms/io/detail/file_extension.h"
#include "soms/io/detail/import/import_child.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/numbers/little_endian.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// Sorted. Of what Assimp 5.2 lists, those that soms reads itself, that hold no meshes or that need
/// a second file are left out.
constexpr auto kExtensions = std::to_array<std::string_view>({
    ".3d",  ".3mf",  ".ac",   ".ac3d", ".acc",     ".amf", ".ase", ".ask",  ".b3d",     ".blend",
    ".cob", ".dxf",  ".enff", ".fbx",  ".hmp",     ".ifc", ".iqm", ".irr",  ".irrmesh", ".lwo",
    ".lws", ".lxo",  ".md2",  ".md3",  ".md5mesh", ".mdc", ".mdl", ".mesh", ".ms3d",    ".ndo",
    ".nff", ".ogex", ".pmx",  ".q3o",  ".q3s",     ".scn", ".sib", ".smd",  ".step",    ".stp",
    ".ter", ".x",    ".x3d",  ".x3db", ".xgl",     ".zgl",
});

constexpr std::string_view kMagic = "soms-import 1\n";

/// The answer: the magic, then records that begin with a letter, little-endian.
///   v  3 doubles                 a vertex
///   f  count, vertices (u32)     a face of vertices so far, from 0
///   b  length, name (u32)        a part begins; parts nest
///   d  id, type, count (u32), as many names and values: what the file states about the part that
///      was opened last, each text as its length (u32) and its bytes
///   e                            it ends
///   n  length, text (u32)        a note
///   u  1 double                  meters a unit
///   a  x, y or z                 the axis that is up
///   g  reference system, vertical datum, 0 or 1 (u32), then for 1 the 10 doubles of a
///      MapConversion, in its order
///   .                            the end
class ImportReader {
 public:
  ImportReader(Source& source, std::string_view answer)
      : source_(source), answer_(answer), builder_(source) {}

  Mesh read();

 private:
  [[noreturn]] void fail(const std::string& what) const;
  std::string_view take(std::size_t size);
  std::uint32_t take_number();
  double take_double();
  void read_vertex();
  void read_face();
  void read_unit();
  void read_axis();
  void read_georeference();

  std::string_view take_text() { return take(take_number()); }

  void describe();
  Mesh finish();

  Source& source_;
  std::string_view answer_;
  std::size_t at_ = 0;
  MeshBuilder builder_;
  std::size_t open_parts_ = 0;
  std::vector<std::uint32_t> corners_;
  double unit_ = 0;
  UpAxis up_ = UpAxis::unknown;
  Georeference georeference_;
};

void ImportReader::fail(const std::string& what) const {
  source_.fail(ErrorKind::bad_file,
               "soms-import gave an invalid answer at byte " + std::to_string(at_) + ": " + what,
               "convert the model to one of the formats that soms reads itself");
}

std::string_view ImportReader::take(std::size_t size) {
  if (size > answer_.size() - at_) {
    fail("it is cut off");
  }
  at_ += size;
  return answer_.substr(at_ - size, size);
}

std::uint32_t ImportReader::take_number() {
  return little_endian<std::uint32_t>(take(sizeof(std::uint32_t)), 0);
}

double ImportReader::take_double() {
  const std::uint64_t low = take_number();
  return bit_cast<double>(low | std::uint64_t{take_number()} << 32);
}

void ImportReader::read_vertex() {
  Vec3 v;
  v.x = take_double();
  v.y = take_double();
  v.z = take_double();
  if (!fit_for_mesh(v)) {
    const CoordinateFault fault = describe_fault(v);
    source_.fail(fault.kind,
                 "vertex " + std::to_string(builder_.vertices().size()) + ": " + fault.what,
                 fault.remedy);
  }
  builder_.add_vertex(v);
}

void ImportReader::read_face() {
  const auto count = take_number();
  if (count > (answer_.size() - at_) / sizeof(std::uint32_t)) {
    fail("it is cut off");
  }
  if (count > corners_.capacity()) {
    const std::uint64_t bytes = std::uint64_t{count} * sizeof(std::uint32_t);
    if (!source_.budget.take(bytes)) {
      source_.fail_memory(bytes);
    }
  }
  corners_.resize(count);
  for (std::uint32_t& corner : corners_) {
    corner = take_number();
    if (corner >= builder_.vertices().size()) {
      fail(index_fault("vertex " + std::to_string(corner), "vertices", builder_.vertices().size()));
    }
  }
  builder_.add_face(corners_);
}

void ImportReader::read_unit() {
  unit_ = take_double();
  if (!(unit_ > 0) || !std::isfinite(unit_)) {
    fail("the unit is not a positive number");
  }
}

void ImportReader::read_axis() {
  const std::size_t axis = std::string_view("xyz").find(take(1));
  if (axis == std::string_view::npos) {
    fail("the up axis must be x, y or z");
  }
  up_ = std::array{UpAxis::x, UpAxis::y, UpAxis::z}[axis];
}

void ImportReader::read_georeference() {
  georeference_ = {.crs = crs_name(take_text())};
  georeference_.vertical_datum = take_text();
  if (take_number() == 0) {
    return;
  }
  MapConversion& map = georeference_.map_conversion.emplace();
  for (double* const value :
       {&map.eastings, &map.northings, &map.height, &map.abscissa, &map.ordinate, &map.scale,
        &map.factors.x, &map.factors.y, &map.factors.z, &map.unit}) {
    *value = take_double();
    if (!std::isfinite(*value)) {
      fail("a number of the map conversion is not finite");
    }
  }
  if (map.unit <= 0) {
    map.unit = crs_axes(georeference_.crs).unit;
  }
}

void ImportReader::describe() {
  if (open_parts_ == 0) {
    fail("a part is described that has not begun");
  }
  const std::string_view id = take_text();
  const std::string_view type = take_text();
  const auto count = take_number();
  // A name and a value have four bytes of length each.
  if (count > (answer_.size() - at_) / (2 * sizeof(std::uint32_t))) {
    fail("it is cut off");
  }
  const std::uint64_t room = std::uint64_t{count} * sizeof(Attribute);
  if (!source_.budget.take(room)) {
    source_.fail_memory(room);
  }
  std::vector<Attribute> attributes;
  attributes.reserve(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::string_view name = take_text();
    attributes.push_back({std::string(name), std::string(take_text())});
  }
  source_.budget.give_back(room);
  builder_.describe_part(id, type, std::move(attributes));
}

Mesh ImportReader::finish() {
  if (open_parts_ > 0 || at_ != answer_.size()) {
    fail("it ends inside a part, or continues after its end");
  }
  Mesh mesh = builder_.finish();
  mesh.unit = unit_;
  mesh.up = up_;
  mesh.georeference = std::move(georeference_);
  return mesh;
}

Mesh ImportReader::read() {
  if (!answer_.starts_with(kMagic)) {
    fail("it does not begin with the expected signature");
  }
  at_ = kMagic.size();
  for (std::uint64_t record = 0;; ++record) {
    if (record % kRowsPerTick == 0) {
      check(source_.limits);
    }
    switch (take(1)[0]) {
      case 'v':
        read_vertex();
        break;
      case 'f':
        read_face();
        break;
      case 'b':
        builder_.open_part(take_text());
        ++open_parts_;
        break;
      case 'd':
        describe();
        break;
      case 'e':
        if (open_parts_ == 0) {
          fail("a part ends that has not begun");
        }
        builder_.close_part();
        --open_parts_;
        break;
      case 'n':
        builder_.note(printable(take_text()));
        break;
      case 'u':
        read_unit();
        break;
      case 'a':
        read_axis();
        break;
      case 'g':
        read_georeference();
        break;
      case '.':
        return finish();
      default:
        fail("it has a record of unknown kind");
    }
  }
}

/// True of an IFC file that has a line for it, or a set of properties.
bool states_map_conversion(std::string_view bytes) {
  constexpr std::array<std::string_view, 4> kWords{"IFCMAPCONVERSION", "IFCRIGIDOPERATION",
                                                   "ePset_MapConversion", "ePSet_MapConversion"};
  return bytes.starts_with("ISO-10303-21") &&
         std::any_of(kWords.begin(), kWords.end(), [bytes](std::string_view word) {
           return bytes.find(word) != std::string_view::npos;
         });
}

}  // namespace

std::span<const std::string_view> imported_extensions() {
  return kExtensions;
}

bool is_imported(std::string_view extension) {
  return std::binary_search(kExtensions.begin(), kExtensions.end(), extension);
}

Mesh read_import(Source& source) {
  const std::string answer = run_import(source, extension_of(source.name));
  Mesh mesh = ImportReader(source, answer).read();
  if (mesh.georeference.empty() && states_map_conversion(source.bytes)) {
    mesh.notes.emplace_back("the file states a map conversion, which Assimp does not read");
  }
  return mesh;
}

}  // namespace soms::detail
