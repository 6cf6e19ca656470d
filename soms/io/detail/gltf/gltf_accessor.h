/// \file
/// Accessors of glTF: numbers in a buffer, with every bound checked before one is read.
#pragma once

#include "soms/base/vector.h"
#include "soms/io/detail/gltf/gltf_buffers.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace soms::detail {

/// Types of a component, by the numbers that glTF gives them.
enum class GltfComponent : std::uint16_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126,
};

[[nodiscard]] std::size_t size_of(GltfComponent type);

/// Elements at equal distances. \invariant All of them exist.
struct GltfRun {
  const char* data = nullptr;
  std::uint64_t stride = 0;
  GltfComponent type = GltfComponent::float32;
};

/// An accessor whose elements all exist, and whose sparse indices are read with care.
struct GltfAccessor {
  JsonValue json;
  std::uint64_t count = 0;
  GltfRun elements = {};
  bool normalized = false;
  std::uint64_t sparse_count = 0;  ///< elements that others replace
  GltfRun sparse_indices = {};
  GltfRun sparse_elements = {};
};

/// The unsigned integer at `at`.
[[nodiscard]] std::uint32_t gltf_index(const char* at, GltfComponent type);

/// The number at `at`, of any type.
[[nodiscard]] double gltf_number(const char* at, GltfComponent type);

/// The three numbers at `at`, as doubles; `normalized` integers are divided by their largest value.
[[nodiscard]] Vec3 gltf_vector(const char* at, const GltfAccessor& accessor);

/// Traverses the elements of an accessor in order.
class GltfCursor {
 public:
  explicit GltfCursor(const GltfAccessor& accessor) : accessor_(accessor) { find_replaced(); }

  /// Bytes of the next element. \pre One is left.
  /// \errors ErrorKind::bad_file: sparse indices that do not ascend, or beyond the accessor.
  [[nodiscard]] const char* next() {
    const std::uint64_t at = next_++;
    if (at == replaced_) [[unlikely]] {
      return next_replacement();
    }
    return accessor_.elements.data + at * accessor_.elements.stride;
  }

 private:
  void find_replaced();
  [[nodiscard]] const char* next_replacement();

  const GltfAccessor& accessor_;
  std::uint64_t next_ = 0;
  std::uint64_t sparse_ = 0;
  std::uint64_t replaced_ = 0;  ///< the next element that another replaces; else never reached
};

/// Accessors of a document, each checked when it is first needed.
class GltfAccessors {
 public:
  /// `quantized`: positions may be integers (KHR_mesh_quantization).
  GltfAccessors(Source& source, GltfBuffers& buffers, bool quantized)
      : source_(source), buffers_(buffers), quantized_(quantized) {}

  /// The positions that a number of the document names; valid as long as this.
  /// \errors ErrorKind::bad_file, and those of GltfBuffers::view.
  [[nodiscard]] const GltfAccessor& positions(const JsonValue& reference);

  /// The indices that a number of the document names; valid as long as this. \errors As above.
  [[nodiscard]] const GltfAccessor& indices(const JsonValue& reference);

  /// The feature ids that a number of the document names; valid as long as this. \errors As above.
  [[nodiscard]] const GltfAccessor& features(const JsonValue& reference);

 private:
  /// What elements are: only those at vertices may have others between them.
  enum class Elements { vectors, indices, features };

  [[nodiscard]] const GltfAccessor& load(const JsonValue& reference, Elements elements);
  [[nodiscard]] GltfRun run(const JsonValue& holder, GltfComponent type, Elements elements,
                            std::uint64_t count);
  void load_sparse(GltfAccessor& accessor, const JsonValue& sparse, Elements elements);

  Source& source_;
  GltfBuffers& buffers_;
  bool quantized_;
  std::unordered_map<std::uint64_t, GltfAccessor> loaded_;
};

}  // namespace soms::detail
