#include "soms/io/detail/ply/ply_binary.h"

#include "soms/base/portable.h"
#include "soms/geometry/detail/counts.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace soms::detail {

namespace {

template <std::size_t Size>
using Bits = std::conditional_t<
    Size == 1, std::uint8_t,
    std::conditional_t<Size == 2, std::uint16_t,
                       std::conditional_t<Size == 4, std::uint32_t, std::uint64_t>>>;

constexpr std::uint8_t swapped(std::uint8_t v) {
  return v;
}

constexpr std::uint16_t swapped(std::uint16_t v) {
  return static_cast<std::uint16_t>(v << 8 | v >> 8);
}

constexpr std::uint32_t swapped(std::uint32_t v) {
  return __builtin_bswap32(v);
}

constexpr std::uint64_t swapped(std::uint64_t v) {
  return __builtin_bswap64(v);
}

/// The value at `p`, of the file's byte order.
template <class T, bool Swap>
T load(const char* p) {
  Bits<sizeof(T)> bits{};
  std::memcpy(&bits, p, sizeof(T));
  if constexpr (Swap) {
    bits = swapped(bits);
  }
  return bit_cast<T>(bits);
}

/// Calls `use` with a value of the C++ type of `type`.
template <class Use>
auto with_type(PlyType type, const Use& use) {
  switch (type) {
    case PlyType::int8:
      return use(std::int8_t{});
    case PlyType::uint8:
      return use(std::uint8_t{});
    case PlyType::int16:
      return use(std::int16_t{});
    case PlyType::uint16:
      return use(std::uint16_t{});
    case PlyType::int32:
      return use(std::int32_t{});
    case PlyType::uint32:
      return use(std::uint32_t{});
    case PlyType::float32:
      return use(float{});
    case PlyType::float64:
      break;
  }
  return use(double{});
}

template <bool Swap>
class PlyBinary final : public PlyBody {
 public:
  PlyBinary(Source& source, MeshBuilder& builder, std::size_t body)
      : PlyBody(source, builder), at_(body) {}

  [[nodiscard]] std::size_t position() const override { return at_; }

  void go_to(std::size_t position) override { at_ = position; }

  void skip(const PlyElement& element) override;
  void read_vertices(const PlyElement& element, const VertexColumns& columns) override;
  void read_faces(const PlyElement& element, std::size_t column) override;
  void finish() override;

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& what) const {
    source_.fail_byte(at, ErrorKind::bad_file, what, "get the complete file, or repair it");
  }

  [[nodiscard]] std::size_t left() const { return source_.bytes.size() - at_; }

  [[nodiscard]] const char* here() const { return source_.bytes.data() + at_; }

  void begin_element(const PlyElement& element) override;
  void read_row(const PlyElement& element, std::size_t column, std::int64_t least) override;

  /// Passes the property, or fails where the file ends. A list's length and first byte.
  struct List {
    std::uint64_t length = 0;
    std::size_t begin = 0;
  };

  List pass_list(const PlyProperty& property);
  void pass(const PlyProperty& property);
  void add_vertex(const Vec3& v, std::size_t at);
  template <class T>
  void read_even_vertices(const PlyElement& element, const std::array<std::size_t, 3>& offsets);
  void read_plain_faces(const PlyElement& element);
  void read_corners(const PlyProperty& property, const List& list, std::int64_t least);

  std::size_t at_;
  std::vector<std::uint32_t> face_;
};

/// The whole element must fit into what is left before anything is allocated for it.
template <bool Swap>
void PlyBinary<Swap>::begin_element(const PlyElement& element) {
  const std::uint64_t row = element.least_row();
  if (row > 0 && element.count > left() / row) {
    fail(at_, std::to_string(element.count) + " rows of element " + in_quotes(element.name) +
                  " do not fit into the remaining " + std::to_string(left()) + " bytes");
  }
}

template <bool Swap>
auto PlyBinary<Swap>::pass_list(const PlyProperty& property) -> List {
  const std::size_t begin = at_;
  const std::size_t count_size = size_of(property.count_type);
  if (left() < count_size) {
    fail(begin, "the file ends before the length of list " + in_quotes(property.name));
  }
  const std::int64_t length = with_type(property.count_type, [&](auto type) {
    return static_cast<std::int64_t>(load<decltype(type), Swap>(here()));
  });
  at_ += count_size;
  if (length < 0 || static_cast<std::uint64_t>(length) > left() / size_of(property.type)) {
    fail(begin, "list " + in_quotes(property.name) + " of length " + std::to_string(length) +
                    " does not fit into the remaining " + std::to_string(left()) + " bytes");
  }
  const List list{static_cast<std::uint64_t>(length), at_};
  at_ += list.length * size_of(property.type);
  return list;
}

template <bool Swap>
void PlyBinary<Swap>::pass(const PlyProperty& property) {
  if (property.is_list) {
    pass_list(property);
    return;
  }
  const std::size_t size = size_of(property.type);
  if (left() < size) {
    fail(at_, "the file ends before property " + in_quotes(property.name));
  }
  at_ += size;
}

template <bool Swap>
void PlyBinary<Swap>::skip(const PlyElement& element) {
  begin_element(element);
  if (element.properties.empty()) {
    return;
  }
  if (!element.has_lists()) {
    at_ += element.count * element.least_row();
    return;
  }
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(at_);
    }
    for (const PlyProperty& property : element.properties) {
      pass(property);
    }
  }
}

template <bool Swap>
void PlyBinary<Swap>::add_vertex(const Vec3& v, std::size_t at) {
  if (!fit_for_mesh(v)) [[unlikely]] {
    const CoordinateFault fault = describe_fault(v);
    source_.fail_byte(at, fault.kind,
                      "vertex " + std::to_string(builder_.vertices().size()) + ": " + fault.what,
                      fault.remedy);
  }
  builder_.add_vertex(v);
}

/// Rows of one size with coordinates of one type: what nearly every file has.
template <bool Swap>
template <class T>
void PlyBinary<Swap>::read_even_vertices(const PlyElement& element,
                                         const std::array<std::size_t, 3>& offsets) {
  const std::size_t stride = element.least_row();
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(at_);
    }
    const char* p = here();
    add_vertex({static_cast<double>(load<T, Swap>(p + offsets[0])),
                static_cast<double>(load<T, Swap>(p + offsets[1])),
                static_cast<double>(load<T, Swap>(p + offsets[2]))},
               at_);
    at_ += stride;
  }
}

template <bool Swap>
void PlyBinary<Swap>::read_vertices(const PlyElement& element, const VertexColumns& columns) {
  begin_element(element);
  builder_.reserve_vertices(element.count);
  const std::vector<PlyProperty>& properties = element.properties;
  const PlyType type = properties[columns[0]].type;
  if (!element.has_lists() && properties[columns[1]].type == type &&
      properties[columns[2]].type == type) {
    std::array<std::size_t, 3> offsets{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < columns[axis]; ++i) {
        offsets[axis] += size_of(properties[i].type);
      }
    }
    with_type(type, [&](auto value) { read_even_vertices<decltype(value)>(element, offsets); });
    return;
  }
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(at_);
    }
    const std::size_t begin = at_;
    Vec3 v;
    for (std::size_t i = 0; i < properties.size(); ++i) {
      const char* p = here();
      pass(properties[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (columns[axis] == i) {
          v[axis] = with_type(properties[i].type, [&](auto value) {
            return static_cast<double>(load<decltype(value), Swap>(p));
          });
        }
      }
    }
    add_vertex(v, begin);
  }
}

/// Reads a list of vertex numbers, each at least `least` and below the number of vertices.
template <bool Swap>
void PlyBinary<Swap>::read_corners(const PlyProperty& property, const List& list,
                                   std::int64_t least) {
  corners_.clear();
  const auto vertices = static_cast<std::int64_t>(builder_.vertices().size());
  with_type(property.type, [&](auto type) {
    using T = decltype(type);
    for (std::uint64_t i = 0; i < list.length; ++i) {
      const std::size_t at = list.begin + i * sizeof(T);
      const T stored = load<T, Swap>(source_.bytes.data() + at);
      std::int64_t corner = -2;
      if constexpr (std::is_floating_point_v<T>) {
        if (std::trunc(stored) != stored) [[unlikely]] {
          fail(at, "vertex number " + std::to_string(stored) + " is not a whole number");
        }
        const bool whole = stored >= -1 && stored <= 0x1p31;
        corner = whole ? static_cast<std::int64_t>(stored) : -2;
      } else {
        // NOLINTNEXTLINE(bugprone-signed-char-misuse): a number, not a character
        corner = static_cast<std::int64_t>(stored);
      }
      if (corner < least || corner >= vertices) [[unlikely]] {
        fail(at, index_fault("vertex " + std::to_string(stored), "vertices",
                             builder_.vertices().size()));
      }
      corners_.push_back(corner);
    }
  });
}

/// Rows of `uchar` length and 32-bit numbers and nothing else.
template <bool Swap>
void PlyBinary<Swap>::read_plain_faces(const PlyElement& element) {
  const PlyProperty& property = element.properties[0];
  const std::size_t vertices = builder_.vertices().size();
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(at_);
    }
    const char* p = here();
    if (left() >= 13 && *p == 3) [[likely]] {
      const auto a = load<std::uint32_t, Swap>(p + 1);
      const auto b = load<std::uint32_t, Swap>(p + 5);
      const auto c = load<std::uint32_t, Swap>(p + 9);
      if (std::max({a, b, c}) < vertices) [[likely]] {
        builder_.add_triangle(a, b, c);
        at_ += 13;
        continue;
      }
    }
    read_corners(property, pass_list(property), 0);
    face_.assign(corners_.begin(), corners_.end());
    builder_.add_face(face_);
  }
}

template <bool Swap>
void PlyBinary<Swap>::read_row(const PlyElement& element, std::size_t column, std::int64_t least) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (i == column) {
      read_corners(element.properties[i], pass_list(element.properties[i]), least);
    } else {
      pass(element.properties[i]);
    }
  }
}

template <bool Swap>
void PlyBinary<Swap>::read_faces(const PlyElement& element, std::size_t column) {
  begin_element(element);
  builder_.reserve_triangles(std::min(element.count, std::uint64_t{left()} / 4));
  const PlyProperty& corners = element.properties[column];
  if (element.properties.size() == 1 && corners.count_type == PlyType::uint8 &&
      (corners.type == PlyType::int32 || corners.type == PlyType::uint32)) {
    read_plain_faces(element);
    return;
  }
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(at_);
    }
    read_row(element, column, 0);
    face_.assign(corners_.begin(), corners_.end());
    builder_.add_face(face_);
  }
}

template <bool Swap>
void PlyBinary<Swap>::finish() {
  LeftOut bytes;
  bytes.add([&] { return "at " + source_.byte_of(at_); }, left());
  builder_.note(bytes, "surplus bytes after the last declared row");
}

}  // namespace

std::unique_ptr<PlyBody> make_ply_binary(Source& source, MeshBuilder& builder,
                                         const PlyHeader& header) {
  const bool big = header.format == PlyFormat::big_endian;
  if (big == (std::endian::native == std::endian::big)) {
    return std::make_unique<PlyBinary<false>>(source, builder, header.body);
  }
  return std::make_unique<PlyBinary<true>>(source, builder, header.body);
}

}  // namespace soms::detail
