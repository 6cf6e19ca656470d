#include "soms/io/detail/gltf/gltf_features.h"

#include "soms/geometry/detail/counts.h"

#include <cmath>
#include <optional>
#include <utility>

namespace soms::detail {

namespace {

std::optional<JsonValue> feature_sets(const JsonValue& primitive) {
  const std::optional<JsonValue> extensions = primitive.find("extensions");
  const std::optional<JsonValue> features =
      extensions ? extensions->find("EXT_mesh_features") : std::nullopt;
  return features ? std::optional(features->at("featureIds")) : std::nullopt;
}

/// The number of a feature as it is stored; floats must be whole.
std::uint64_t feature_number(const char* at, const GltfAccessor& accessor, std::uint64_t position) {
  const double value = gltf_number(at, accessor.elements.type);
  if (!(value >= 0) || value >= kNoFeature || std::floor(value) != value) {
    accessor.json.fail("element " + std::to_string(position) +
                       " is not a whole number from 0 to the last feature");
  }
  return static_cast<std::uint64_t>(value);
}

}  // namespace

GltfFeatures::GltfFeatures(Source& source, const JsonValue& root, GltfBuffers& buffers,
                           GltfAccessors& accessors, const BatchTable* batches,
                           MeshBuilder& builder)
    : source_(source),
      accessors_(accessors),
      batches_(batches),
      builder_(builder),
      metadata_(root, buffers) {
}

std::optional<GltfFeatures::Place> GltfFeatures::batch_place(const JsonValue& primitive) const {
  const JsonValue attributes = primitive.at("attributes");
  for (const char* const name : {"_BATCHID", "BATCHID"}) {
    if (const auto accessor = attributes.find(name)) {
      return Place{*accessor, std::nullopt, kNoFeature};
    }
  }
  return std::nullopt;
}

/// The first set of ids that stand in an attribute and name features of a table.
std::optional<GltfFeatures::Place> GltfFeatures::feature_place(const JsonValue& primitive) const {
  const std::optional<JsonValue> sets = feature_sets(primitive);
  for (std::size_t i = 0; sets && i < sets->size() && metadata_.has_tables(); ++i) {
    const JsonValue set = sets->at(i);
    const std::optional<JsonValue> attribute = set.find("attribute");
    const std::optional<JsonValue> table = set.find("propertyTable");
    if (attribute && table) {
      const std::string name = "_FEATURE_ID_" + std::to_string(attribute->whole());
      const std::optional<JsonValue> none = set.find("nullFeatureId");
      return Place{primitive.at("attributes").at(name), *table,
                   none ? none->whole() : std::uint64_t{kNoFeature}};
    }
  }
  return std::nullopt;
}

std::optional<GltfFeatures::Place> GltfFeatures::place_of(const JsonValue& primitive) const {
  return batches_ != nullptr && batches_->length() > 0 ? batch_place(primitive)
                                                       : feature_place(primitive);
}

bool GltfFeatures::has(const JsonValue& primitive) const {
  return place_of(primitive).has_value();
}

void GltfFeatures::count_unread(const JsonValue& primitive) {
  const auto place = [&] { return "in " + primitive.path(); };
  if (batches_ != nullptr && batches_->length() > 0) {
    without_ids_.add(place, batch_place(primitive) ? 0 : 1);
    return;
  }
  const std::optional<JsonValue> sets = feature_sets(primitive);
  for (std::size_t i = 0; sets && i < sets->size(); ++i) {
    const bool by_attribute = sets->at(i).find("attribute").has_value();
    unread_sets_.add(place, by_attribute || !sets->at(i).find("propertyTable") ? 0 : 1);
  }
}

void GltfFeatures::begin(const JsonValue& primitive, std::uint64_t positions) {
  count_unread(primitive);
  primitive_ = primitive;
  const std::optional<Place> place = place_of(primitive);
  active_ = place.has_value();
  if (active_) {
    read(*place, positions);
  }
}

void GltfFeatures::read(const Place& place, std::uint64_t positions) {
  ids_.table = place.table ? &metadata_.table(*place.table) : nullptr;
  const std::uint64_t count = place.table ? ids_.table->count() : batches_->length();
  const GltfAccessor& accessor = accessors_.features(place.accessor);
  if (accessor.count != positions) {
    accessor.json.fail(std::to_string(accessor.count) + " feature ids, but " +
                       std::to_string(positions) + " positions");
  }
  const std::uint64_t bytes = positions * sizeof(std::uint32_t);
  if (!source_.budget.take(bytes)) {
    source_.fail_memory(bytes);
  }
  ids_.of.clear();
  ids_.of.reserve(static_cast<std::size_t>(positions));
  GltfCursor cursor(accessor);
  for (std::uint64_t i = 0; i < positions; ++i) {
    if (i % kRowsPerTick == 0) {
      check(source_.limits);
    }
    const std::uint64_t number = feature_number(cursor.next(), accessor, i);
    if (number >= count && number != place.none) {
      accessor.json.fail(
          index_fault("element " + std::to_string(i) + " is feature " + std::to_string(number),
                      "features", count));
    }
    ids_.of.push_back(number == place.none ? kNoFeature : static_cast<std::uint32_t>(number));
  }
}

void GltfFeatures::enter_feature(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  std::uint32_t feature = ids_.of[a];
  if (ids_.of[b] != feature || ids_.of[c] != feature) [[unlikely]] {
    mixed_.add([&] { return "in " + primitive_->path(); });
    feature = kNoFeature;
  }
  if (feature != opened_) {
    if (opened_ != kNoFeature) {
      builder_.close_part();
    }
    opened_ = feature;
    if (feature != kNoFeature) {
      open(feature);
    }
  }
}

void GltfFeatures::open(std::uint32_t feature) {
  auto& runs = first_runs_[ids_.table];
  const auto known = runs.find(feature);
  if (known != runs.end()) {
    builder_.continue_part(known->second);
    return;
  }
  constexpr std::uint64_t kBytesPerRun = 64;
  if (!source_.budget.take(kBytesPerRun)) {
    source_.fail_memory(kBytesPerRun);
  }
  Feature described =
      ids_.table != nullptr ? ids_.table->feature(feature) : batches_->feature(feature);
  builder_.open_part(described.name);
  builder_.describe_part(described.id, described.type, std::move(described.attributes));
  runs.emplace(feature, builder_.opened_part());
}

void GltfFeatures::end() {
  if (opened_ != kNoFeature) {
    builder_.close_part();
    opened_ = kNoFeature;
  }
  if (active_) {
    source_.budget.give_back(ids_.of.size() * sizeof(std::uint32_t));
    active_ = false;
  }
}

void GltfFeatures::add_notes(std::vector<std::string>& notes) const {
  add_note(notes, mixed_, "triangles between features, in no part of a feature");
  add_note(notes, without_ids_, "primitives without batch ids, in no part of a batch");
  add_note(notes, unread_sets_, "feature ids in textures or by position, not read");
  metadata_.add_notes(notes);
}

}  // namespace soms::detail
