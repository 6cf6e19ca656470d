#include "soms/io/detail/ply/ply_text.h"

#include "soms/geometry/detail/counts.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

namespace {

struct Range {
  std::int64_t lower = 0;
  std::int64_t upper = 0;
};

template <class T>
constexpr Range range_of() {
  return {std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max()};
}

/// Values of a whole type.
Range range(PlyType type) {
  switch (type) {
    case PlyType::int8:
      return range_of<std::int8_t>();
    case PlyType::uint8:
      return range_of<std::uint8_t>();
    case PlyType::int16:
      return range_of<std::int16_t>();
    case PlyType::uint16:
      return range_of<std::uint16_t>();
    case PlyType::int32:
      return range_of<std::int32_t>();
    default:
      return range_of<std::uint32_t>();
  }
}

/// Values are parted by blanks. Each row is a line, so that one that lacks a number does not take
/// the first of the row behind it; but where the first line of an element holds two rows or more,
/// lines mean nothing in it.
class PlyText final : public PlyBody {
 public:
  PlyText(Source& source, MeshBuilder& builder, std::size_t body)
      : PlyBody(source, builder), scanner_(source, body), body_(body) {}

  [[nodiscard]] std::size_t position() const override { return scanner_.position(); }

  void go_to(std::size_t position) override { scanner_ = TextScanner(source_, position); }

  void skip(const PlyElement& element) override;
  void read_vertices(const PlyElement& element, const VertexColumns& columns) override;
  void read_faces(const PlyElement& element, std::size_t column) override;
  void finish() override;

 private:
  void begin_element(const PlyElement& element) override;
  void read_row(const PlyElement& element, std::size_t column, std::int64_t least) override;
  double read_number(const PlyProperty& property);
  std::int64_t read_integer(const PlyProperty& property, PlyType type);
  std::int64_t read_length(const PlyProperty& property);
  void read_corners(const PlyProperty& property, std::int64_t least);
  void pass(const PlyProperty& property);
  void pass_word(const PlyProperty& property);

  /// Where rows flow, the next value may stand in the next line; else it is missing.
  void begin_value() {
    if (flows_) [[unlikely]] {
      scanner_.skip_space();
    }
  }

  [[nodiscard]] static bool pass_row(TextScanner& scanner, const PlyElement& element);
  [[nodiscard]] bool flows(const PlyElement& element) const;
  void end_row();

  TextScanner scanner_;
  std::size_t body_;
  bool flows_ = false;  ///< rows of the element go on in the next line
  std::vector<std::uint32_t> face_;
};

/// Every value takes a character and, but for the last, a blank.
void PlyText::begin_element(const PlyElement& element) {
  const std::uint64_t row = 2 * std::uint64_t{element.properties.size()};
  if (row > 0 && element.count > (std::uint64_t{scanner_.left()} + 1) / row) {
    scanner_.fail(ErrorKind::bad_file,
                  std::to_string(element.count) + " rows of element " + in_quotes(element.name) +
                      " do not fit into the remaining " + std::to_string(scanner_.left()) +
                      " bytes",
                  "get the complete file, or repair it");
  }
  flows_ = flows(element);
}

/// Passes a row within a line, unless it does not end there.
bool PlyText::pass_row(TextScanner& scanner, const PlyElement& element) {
  for (const PlyProperty& property : element.properties) {
    std::uint64_t tokens = 1;
    if (property.is_list) {
      const std::string_view length = scanner.token_in_line();
      if (std::from_chars(length.data(), length.data() + length.size(), tokens).ec != std::errc()) {
        return false;
      }
    }
    for (; tokens > 0; --tokens) {
      if (scanner.token_in_line().empty()) {
        return false;
      }
    }
  }
  return true;
}

/// True if the first line of an element is shared: it holds rows of another one, or at least two.
bool PlyText::flows(const PlyElement& element) const {
  if (element.count == 0) {
    return false;
  }
  TextScanner scanner = scanner_;
  if (scanner.position() != body_ && !scanner.at_line_end()) {
    return true;
  }
  scanner.skip_space();
  return pass_row(scanner, element) && !scanner.at_line_end() &&
         (element.count == 1 || pass_row(scanner, element));
}

void PlyText::end_row() {
  if (!flows_ && !scanner_.at_line_end()) [[unlikely]] {
    scanner_.fail_surplus("the last value of the row",
                          "correct the row, or put each row on its own line");
  }
}

void PlyText::pass_word(const PlyProperty& property) {
  begin_value();
  if (scanner_.token_in_line().empty()) {
    scanner_.fail_missing(property.name);
  }
}

std::int64_t PlyText::read_integer(const PlyProperty& property, PlyType type) {
  begin_value();
  const TextScanner before = scanner_;
  const std::int64_t value = scanner_.integer(property.name);
  const Range allowed = range(type);
  if (value < allowed.lower || value > allowed.upper) {
    before.fail(
        ErrorKind::bad_file,
        in_quotes(property.name) + " is " + std::to_string(value) + ", out of range for its type",
        "repair the file");
  }
  return value;
}

double PlyText::read_number(const PlyProperty& property) {
  if (!is_floating(property.type)) {
    return static_cast<double>(read_integer(property, property.type));
  }
  begin_value();
  return scanner_.number(
      property.type == PlyType::float32 ? Precision::as_float : Precision::as_double,
      property.name);
}

std::int64_t PlyText::read_length(const PlyProperty& property) {
  begin_value();
  const TextScanner before = scanner_;
  const std::int64_t length = read_integer(property, property.count_type);
  if (length < 0 || static_cast<std::uint64_t>(length) > (scanner_.left() + 1) / 2) {
    before.fail(ErrorKind::bad_file,
                "list " + in_quotes(property.name) + " of length " + std::to_string(length) +
                    " does not fit into the remaining " + std::to_string(scanner_.left()) +
                    " bytes",
                "get the complete file, or repair it");
  }
  return length;
}

void PlyText::pass(const PlyProperty& property) {
  if (!property.is_list) {
    pass_word(property);
    return;
  }
  const std::int64_t length = read_length(property);
  for (std::int64_t i = 0; i < length; ++i) {
    pass_word(property);
  }
}

void PlyText::skip(const PlyElement& element) {
  if (element.properties.empty()) {
    return;
  }
  begin_element(element);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(position());
    }
    scanner_.skip_space();
    for (const PlyProperty& property : element.properties) {
      pass(property);
    }
    end_row();
  }
}

void PlyText::read_vertices(const PlyElement& element, const VertexColumns& columns) {
  begin_element(element);
  builder_.reserve_vertices(element.count);
  constexpr std::size_t kNoAxis = 3;
  std::vector<std::size_t> axes(element.properties.size(), kNoAxis);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes[columns[axis]] = axis;
  }
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(position());
      source_.forget(position());
    }
    scanner_.skip_space();
    Vec3 v;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (axes[i] == kNoAxis) {
        pass(element.properties[i]);
      } else {
        v[axes[i]] = read_number(element.properties[i]);
      }
    }
    if (!fit_for_mesh(v)) [[unlikely]] {
      const CoordinateFault fault = describe_fault(v);
      scanner_.fail(fault.kind, "vertex " + std::to_string(row) + ": " + fault.what, fault.remedy);
    }
    builder_.add_vertex(v);
    end_row();
  }
}

/// Reads a list of vertex numbers, each at least `least` and below the number of vertices.
void PlyText::read_corners(const PlyProperty& property, std::int64_t least) {
  const std::int64_t length = read_length(property);
  const auto vertices = static_cast<std::int64_t>(builder_.vertices().size());
  corners_.clear();
  for (std::int64_t i = 0; i < length; ++i) {
    begin_value();
    const TextScanner before = scanner_;
    const std::int64_t corner = scanner_.integer("a vertex number");
    if (corner < least || corner >= vertices) [[unlikely]] {
      before.fail(
          ErrorKind::bad_file,
          index_fault("vertex " + std::to_string(corner), "vertices", builder_.vertices().size()),
          "repair or drop the face");
    }
    corners_.push_back(corner);
  }
}

void PlyText::read_row(const PlyElement& element, std::size_t column, std::int64_t least) {
  scanner_.skip_space();
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (i == column) {
      read_corners(element.properties[i], least);
    } else {
      pass(element.properties[i]);
    }
  }
  end_row();
}

void PlyText::read_faces(const PlyElement& element, std::size_t column) {
  begin_element(element);
  builder_.reserve_triangles(std::min(element.count, std::uint64_t{scanner_.left()} / 4));
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(position());
      source_.forget(position());
    }
    read_row(element, column, 0);
    face_.assign(corners_.begin(), corners_.end());
    builder_.add_face(face_);
  }
}

void PlyText::finish() {
  scanner_.skip_space();
  if (!scanner_.at_end()) {
    scanner_.fail_surplus("the last row that the header declares",
                          "correct the counts in the header, or delete the surplus");
  }
}

}  // namespace

std::unique_ptr<PlyBody> make_ply_text(Source& source, MeshBuilder& builder,
                                       const PlyHeader& header) {
  return std::make_unique<PlyText>(source, builder, header.body);
}

}  // namespace soms::detail
