#include "soms/io/detail/cityjson/cityjson.h"

#include "soms/base/arithmetic.h"
#include "soms/io/crs.h"
#include "soms/io/detail/cityjson/cityjson_geometry.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::string_view kType = "\"type\"";
constexpr std::string_view kCityJson = "\"CityJSON\"";
constexpr std::string_view kFeature = "\"CityJSONFeature\"";

/// True if `text` ends with a name and a colon.
bool ends_with_name(std::string_view text, std::string_view name) {
  const auto trim = [&] {
    while (!text.empty() && is_space(text.back())) {
      text.remove_suffix(1);
    }
  };
  trim();
  if (!text.ends_with(':')) {
    return false;
  }
  text.remove_suffix(1);
  trim();
  return text.ends_with(name);
}

/// Where the value of a type stands; npos if it stands nowhere.
std::size_t find_type(std::string_view bytes, std::string_view value) {
  for (std::size_t at = bytes.find(value); at != std::string_view::npos;
       at = bytes.find(value, at + 1)) {
    if (ends_with_name(bytes.substr(0, at), kType)) {
      return at;
    }
  }
  return std::string_view::npos;
}

void check_cityjson_version(const JsonValue& root) {
  const JsonValue version = root.at("version");
  const std::string text = version.as_text();
  if (text != "1.0" && text != "1.1" && !text.starts_with("2.")) {
    version.fail(ErrorKind::unsupported,
                 "version " + in_quotes(text) + " is not read, only 1.0, 1.1 and 2.x",
                 "convert it by cjio, or save it as CityJSON 2.0");
  }
}

/// Adds one document after the other to a mesh.
class CityReader {
 public:
  explicit CityReader(Source& source) : source_(source), builder_(source) {}

  /// The reference system of all documents.
  void read_reference_system(const JsonValue& root);

  void add(const JsonValue& root, const CityTransform& transform);

  [[nodiscard]] Mesh finish();

 private:
  using Objects = std::unordered_map<std::string_view, JsonValue>;

  void open(std::string_view key, const JsonValue& object, CityGeometries& geometries);
  void add_tree(std::string_view key, const JsonValue& object, const Objects& objects,
                CityGeometries& geometries);
  [[nodiscard]] static std::vector<JsonValue> children_of(const JsonValue& object);

  Source& source_;
  MeshBuilder builder_;
  CityLeftOut left_out_;
  std::string crs_;
  std::unordered_set<std::string_view> opened_;  ///< objects of the document
};

std::vector<JsonValue> CityReader::children_of(const JsonValue& object) {
  std::vector<JsonValue> children;
  if (const std::optional<JsonValue> list = object.find("children")) {
    for (std::size_t i = list->size(); i-- > 0;) {
      children.push_back(list->at(i));
    }
  }
  return children;
}

/// Opens the part of an object, and adds its own triangles.
void CityReader::open(std::string_view key, const JsonValue& object, CityGeometries& geometries) {
  std::vector<Attribute> attributes;
  if (const std::optional<JsonValue> stated = object.find("attributes")) {
    for (const auto& [name, value] : stated->members()) {
      attributes.push_back({std::string(name), value.as_text()});
    }
  }
  builder_.open_part(key);
  builder_.describe_part(key, object.at("type").text(), std::move(attributes));
  geometries.add(object);
}

/// Adds an object and all that are parts of it, from the outside in.
void CityReader::add_tree(std::string_view key, const JsonValue& object, const Objects& objects,
                          CityGeometries& geometries) {
  std::vector<std::vector<JsonValue>> left;  // children of the open objects, the last one next
  opened_.insert(key);
  open(key, object, geometries);
  left.push_back(children_of(object));
  while (!left.empty()) {
    std::vector<JsonValue>& children = left.back();
    if (children.empty()) {
      builder_.close_part();
      left.pop_back();
      continue;
    }
    const JsonValue child = children.back();
    children.pop_back();
    const auto found = objects.find(child.text());
    if (found == objects.end()) {
      child.fail("there is no object " + in_quotes(child.text()));
    }
    const std::optional<JsonValue> parents = found->second.find("parents");
    if ((!parents || parents->size() == 0) && found->first != key) {
      child.fail("the object " + in_quotes(child.text()) +
                 " has no \"parents\", where this one must be named");
    }
    if (!opened_.insert(found->first).second) {
      child.fail("this object is a part of itself, or of two others");
    }
    open(found->first, found->second, geometries);
    left.push_back(children_of(found->second));
  }
}

void CityReader::read_reference_system(const JsonValue& root) {
  const std::optional<JsonValue> metadata = root.find("metadata");
  const std::optional<JsonValue> system =
      metadata && metadata->is_object() ? metadata->find("referenceSystem") : std::nullopt;
  if (!system || system->is_null()) {
    return;
  }
  if (!system->is_text()) {
    builder_.note("a reference system that is no text, not read");
    return;
  }
  crs_ = crs_name(system->text());
}

void CityReader::add(const JsonValue& root, const CityTransform& transform) {
  const JsonValue stated = root.at("CityObjects");
  CityGeometries geometries(source_, root, transform, builder_, left_out_);
  const auto members = stated.members();
  const Objects objects(members.begin(), members.end());
  opened_.clear();
  for (const auto& [key, object] : members) {
    const std::optional<JsonValue> parents = object.find("parents");
    if (!parents || parents->size() == 0) {
      add_tree(key, object, objects, geometries);
    }
  }
  if (opened_.size() < objects.size()) {
    stated.fail("objects are parts of others that do not have them as children");
  }
}

Mesh CityReader::finish() {
  if (source_.lod && left_out_.without.count() > 0 && builder_.triangle_count() == 0) {
    std::string levels;
    for (const std::string& level : left_out_.levels) {
      levels += (levels.empty() ? "" : ", ") + in_quotes(level);
    }
    source_.fail(ErrorKind::usage, "no object has the level of detail that is requested",
                 "request one of those that the file has: " + levels);
  }
  builder_.note(left_out_.others, "geometries of another level of detail, not read");
  builder_.note(left_out_.without,
                "objects without a geometry of the level of detail that is requested, not read");
  builder_.note(left_out_.not_areas, "points and lines, not read");
  Mesh mesh = builder_.finish();
  mesh.up = UpAxis::z;
  mesh.unit = crs_axes(crs_).unit;
  mesh.georeference.crs = crs_;
  return mesh;
}

/// A line of a sequence.
struct SequenceLine {
  std::size_t at = 0;      ///< its first byte
  std::size_t number = 0;  ///< from 1
  std::string_view text;
};

/// The lines that are not empty.
std::vector<SequenceLine> lines_of(std::string_view bytes) {
  std::vector<SequenceLine> lines;
  std::size_t number = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const std::string_view line = bytes.substr(at, end - at);
    ++number;
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) {
      lines.push_back({at, number, line});
    }
    at = end + 1;
  }
  return lines;
}

/// One document after the other, so that no more than one is in memory.
Mesh read_sequence(Source& source) {
  CityReader reader(source);
  CityTransform transform;
  bool first = true;
  for (const SequenceLine& line : lines_of(source.bytes)) {
    source.tick(line.at);
    const JsonDocument document(source, line.text, line.at, false,
                                "line " + std::to_string(line.number));
    const JsonValue type = document.root().at("type");
    if (type.text() != (first ? "CityJSON" : "CityJSONFeature")) {
      type.fail(in_quotes(type.text()) +
                (first ? " begins the sequence, not \"CityJSON\"" : " is no \"CityJSONFeature\""));
    }
    if (first) {
      check_cityjson_version(document.root());
      transform = city_transform(document.root());
      reader.read_reference_system(document.root());
    }
    first = false;
    reader.add(document.root(), transform);
  }
  return reader.finish();
}

}  // namespace

bool is_cityjson(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && bytes[begin] == '{' &&
         find_type(bytes, kCityJson) != std::string_view::npos;
}

Mesh read_cityjson(Source& source) {
  const PlainArithmetic plain;
  source.is_city = true;
  if (find_type(source.bytes, kFeature) != std::string_view::npos) {
    return read_sequence(source);
  }
  const JsonDocument document(source, source.bytes, 0, false);
  check_cityjson_version(document.root());
  CityReader reader(source);
  reader.read_reference_system(document.root());
  reader.add(document.root(), city_transform(document.root()));
  return reader.finish();
}

}  // namespace soms::detail
