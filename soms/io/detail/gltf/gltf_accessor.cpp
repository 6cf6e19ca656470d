#include "soms/io/detail/gltf/gltf_accessor.h"

#include "soms/geometry/mesh.h"
#include "soms/io/detail/numbers/little_endian.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace soms::detail {

namespace {

constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

/// What an accessor without a view holds.
constexpr std::array<char, 12> kZeros{};

GltfComponent component_of(const JsonValue& holder) {
  const JsonValue number = holder.at("componentType");
  switch (number.whole()) {
    case 5120:
      return GltfComponent::int8;
    case 5121:
      return GltfComponent::uint8;
    case 5122:
      return GltfComponent::int16;
    case 5123:
      return GltfComponent::uint16;
    case 5125:
      return GltfComponent::uint32;
    case 5126:
      return GltfComponent::float32;
    default:
      number.fail(std::to_string(number.whole()) + " is not a component type");
  }
}

bool is_index(GltfComponent type) {
  return type == GltfComponent::uint8 || type == GltfComponent::uint16 ||
         type == GltfComponent::uint32;
}

void check_index(const JsonValue& holder, GltfComponent type) {
  if (!is_index(type)) {
    holder.at("componentType").fail("the component type of indices must be 5121, 5123 or 5125");
  }
}

template <class T>
T value_at(const char* at, std::size_t i) {
  const std::string_view bytes(at + i * sizeof(T), sizeof(T));
  if constexpr (sizeof(T) == 1) {
    return static_cast<T>(bytes[0]);
  } else {
    return little_endian<T>(bytes, 0);
  }
}

template <class T>
Vec3 vector_at(const char* at, bool normalized) {
  const auto component = [&](std::size_t i) {
    const auto value = static_cast<double>(value_at<T>(at, i));
    return normalized ? std::max(value / std::numeric_limits<T>::max(), -1.0) : value;
  };
  return {component(0), component(1), component(2)};
}

}  // namespace

std::size_t size_of(GltfComponent type) {
  switch (type) {
    case GltfComponent::int8:
    case GltfComponent::uint8:
      return 1;
    case GltfComponent::int16:
    case GltfComponent::uint16:
      return 2;
    case GltfComponent::uint32:
    case GltfComponent::float32:
      return 4;
  }
  return 0;
}

std::uint32_t gltf_index(const char* at, GltfComponent type) {
  switch (type) {
    case GltfComponent::uint8:
      return value_at<std::uint8_t>(at, 0);
    case GltfComponent::uint16:
      return value_at<std::uint16_t>(at, 0);
    default:
      return value_at<std::uint32_t>(at, 0);
  }
}

double gltf_number(const char* at, GltfComponent type) {
  switch (type) {
    case GltfComponent::int8:
      return value_at<std::int8_t>(at, 0);
    case GltfComponent::int16:
      return value_at<std::int16_t>(at, 0);
    case GltfComponent::float32: {
      const auto value = value_at<float>(at, 0);
      return value;
    }
    default:
      return gltf_index(at, type);
  }
}

Vec3 gltf_vector(const char* at, const GltfAccessor& accessor) {
  switch (accessor.elements.type) {
    case GltfComponent::int8:
      return vector_at<std::int8_t>(at, accessor.normalized);
    case GltfComponent::uint8:
      return vector_at<std::uint8_t>(at, accessor.normalized);
    case GltfComponent::int16:
      return vector_at<std::int16_t>(at, accessor.normalized);
    case GltfComponent::uint16:
      return vector_at<std::uint16_t>(at, accessor.normalized);
    default:
      return vector_at<float>(at, false);
  }
}

void GltfCursor::find_replaced() {
  if (sparse_ == accessor_.sparse_count) {
    replaced_ = kNever;
    return;
  }
  const GltfRun& indices = accessor_.sparse_indices;
  const std::uint64_t index = gltf_index(indices.data + sparse_ * indices.stride, indices.type);
  if (index >= accessor_.count || (sparse_ > 0 && index <= replaced_)) {
    accessor_.json.at("sparse").at("indices").fail(
        "index " + std::to_string(sparse_) + " is " + std::to_string(index) +
        "; sparse indices must ascend and be below " + std::to_string(accessor_.count));
  }
  replaced_ = index;
}

const char* GltfCursor::next_replacement() {
  const GltfRun& elements = accessor_.sparse_elements;
  const char* const at = elements.data + sparse_ * elements.stride;
  ++sparse_;
  find_replaced();
  return at;
}

/// `count` elements in the view that `holder` names, at its offset.
GltfRun GltfAccessors::run(const JsonValue& holder, GltfComponent type, Elements elements,
                           std::uint64_t count) {
  const GltfView view = buffers_.view(holder.at("bufferView"));
  const std::uint64_t element = (elements == Elements::vectors ? 3 : 1) * size_of(type);
  const std::uint64_t stride = view.stride > 0 ? view.stride : element;
  if (stride < element || (elements == Elements::indices && stride != element)) {
    holder.at("bufferView")
        .fail("a stride of " + std::to_string(stride) + " bytes does not fit elements of " +
              std::to_string(element));
  }
  const std::optional<JsonValue> at = holder.find("byteOffset");
  const std::uint64_t offset = at ? at->whole() : 0;
  const std::uint64_t size = view.bytes.size();
  if (offset > size || element > size - offset || count - 1 > (size - offset - element) / stride) {
    holder.fail(std::to_string(count) + " elements of " + std::to_string(element) +
                " bytes from byte " + std::to_string(offset) + ", but the view has " +
                std::to_string(size) + " bytes");
  }
  return {view.bytes.data() + offset, stride, type};
}

void GltfAccessors::load_sparse(GltfAccessor& accessor, const JsonValue& sparse,
                                Elements elements) {
  accessor.sparse_count = sparse.at("count").whole();
  if (accessor.sparse_count < 1 || accessor.sparse_count > accessor.count) {
    sparse.at("count").fail(std::to_string(accessor.sparse_count) + " sparse elements of " +
                            std::to_string(accessor.count) +
                            "; there must be from 1 to all of them");
  }
  const JsonValue indices = sparse.at("indices");
  const GltfComponent type = component_of(indices);
  check_index(indices, type);
  accessor.sparse_indices = run(indices, type, Elements::indices, accessor.sparse_count);
  accessor.sparse_elements =
      run(sparse.at("values"), accessor.elements.type, elements, accessor.sparse_count);
}

const GltfAccessor& GltfAccessors::load(const JsonValue& reference, Elements elements) {
  const JsonValue json = reference.referred("accessors");
  const auto known = loaded_.find(reference.whole());
  if (known != loaded_.end()) {
    return known->second;
  }
  constexpr std::uint64_t kBytesPerAccessor = 2 * sizeof(GltfAccessor);
  if (!source_.budget.take(kBytesPerAccessor)) {
    source_.fail_memory(kBytesPerAccessor);
  }
  GltfAccessor accessor{.json = json, .count = json.at("count").whole()};
  if (accessor.count < 1 || accessor.count > kMaxPrimitives) {
    json.at("count").fail(std::to_string(accessor.count) +
                          " elements; the count must be from 1 to 2^31 - 1");
  }
  const GltfComponent type = component_of(json);
  accessor.elements = {kZeros.data(), 0, type};
  if (json.find("bufferView")) {
    accessor.elements = run(json, type, elements, accessor.count);
  }
  if (const auto sparse = json.find("sparse")) {
    load_sparse(accessor, *sparse, elements);
  }
  if (const auto normalized = json.find("normalized")) {
    accessor.normalized = normalized->boolean();
  }
  return loaded_.emplace(reference.whole(), accessor).first->second;
}

const GltfAccessor& GltfAccessors::positions(const JsonValue& reference) {
  const JsonValue json = reference.referred("accessors");
  const GltfComponent type = component_of(json);
  if (json.at("type").text() != "VEC3") {
    json.at("type").fail("positions must be VEC3");
  }
  if (type == GltfComponent::uint32 || (type != GltfComponent::float32 && !quantized_)) {
    json.at("componentType")
        .fail(
            "the component type of positions must be 5126 (float); small integers need "
            "KHR_mesh_quantization in "
            "\"extensionsUsed\"");
  }
  return load(reference, Elements::vectors);
}

const GltfAccessor& GltfAccessors::indices(const JsonValue& reference) {
  const JsonValue json = reference.referred("accessors");
  if (json.at("type").text() != "SCALAR") {
    json.at("type").fail("indices must be SCALAR");
  }
  check_index(json, component_of(json));
  return load(reference, Elements::indices);
}

const GltfAccessor& GltfAccessors::features(const JsonValue& reference) {
  const JsonValue json = reference.referred("accessors");
  if (json.at("type").text() != "SCALAR") {
    json.at("type").fail("feature ids must be SCALAR");
  }
  static_cast<void>(component_of(json));
  return load(reference, Elements::features);
}

}  // namespace soms::detail
