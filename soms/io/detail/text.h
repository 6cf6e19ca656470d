/// \file
/// Words and numbers of a text file: no locale, no copies, nothing beyond the last byte.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/io/detail/source.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace soms::detail {

[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

[[nodiscard]] constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

[[nodiscard]] constexpr bool is_space(char c) {
  return is_blank(c) || is_line_end(c);
}

/// How the text of a number becomes a double.
enum class Precision { as_double, as_float };

/// What a format makes of its text beyond blanks and line ends.
struct TextStyle {
  bool comments = false;   ///< a word that begins with # ends the line
  bool continued = false;  ///< a backslash before a line end joins two lines
};

/// Reads a text from front to back. Blanks are space, tab, VT and FF; lines end with LF, CRLF or
/// CR.
class TextScanner {
 public:
  TextScanner(const Source& source, std::size_t position, const TextStyle& style = {});

  [[nodiscard]] std::size_t position() const {
    return static_cast<std::size_t>(at_ - source_->bytes.data());
  }

  /// Bytes that are left.
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

  [[nodiscard]] bool at_end() const { return at_ == end_; }

  /// Passes blanks.
  void skip_blanks();
  /// Passes blanks and line ends.
  void skip_space();
  /// Passes the rest of the line and its end.
  void skip_line();
  /// Passes blanks; true if nothing else but a comment is left in the line.
  [[nodiscard]] bool at_line_end();
  /// Passes lines that are empty or comments; false at the end of the file.
  [[nodiscard]] bool find_line();

  /// The next word of this line; empty at its end.
  [[nodiscard]] std::string_view token_in_line();
  /// The next word, over line ends; empty at the end of the file.
  [[nodiscard]] std::string_view token();
  /// The rest of the line without blanks around it, comments included; its end is passed.
  [[nodiscard]] std::string_view rest_of_line();

  /// The next number of this line. `what` names it in errors ("x of a vertex").
  /// \errors ErrorKind::bad_file, not_finite (nan, inf, or too large for the type).
  [[nodiscard]] double number(Precision precision, std::string_view what);

  /// Three numbers of this line that are a vertex: finite and at most 2^300.
  /// \errors ErrorKind::bad_file, not_finite, out_of_range.
  [[nodiscard]] Vec3 vertex(Precision precision);

  /// The next whole number of this line.
  /// \errors ErrorKind::bad_file: a fraction, a word, the end of the line, beyond 64 bits.
  [[nodiscard]] std::int64_t integer(std::string_view what);

  /// The next corner of a face in the manner of OBJ: a number, and up to two more behind slashes,
  /// which are passed. \errors ErrorKind::bad_file.
  [[nodiscard]] std::int64_t slashed_integer(std::string_view what);

  /// The line, or the file, ends where `what` should be. \errors ErrorKind::bad_file.
  [[noreturn]] void fail_missing(std::string_view what) const;

  /// The next word of this line, which follows `what`, is one too many. \errors
  /// ErrorKind::bad_file.
  [[noreturn]] void fail_surplus(std::string_view what, const std::string& remedy) const;

  [[noreturn]] void fail(ErrorKind kind, const std::string& what, const std::string& remedy) const {
    source_->fail_line(position(), kind, what, remedy);
  }

 private:
  /// Bytes of the line end at `p`, 0 if there is none.
  [[nodiscard]] std::size_t line_end_at(const char* p) const;

  /// True if a word ends before `p`.
  [[nodiscard]] bool parts(const char* p) const {
    return p == end_ || is_blank(*p) || is_line_end(*p) ||
           (style_.continued && *p == '\\' && line_end_at(p + 1) > 0);
  }

  /// True if a comment begins between here, where no word goes on, and `end`.
  [[nodiscard]] bool comment_before(const char* end) const;

  [[nodiscard]] bool at_comment() const { return style_.comments && at_ != end_ && *at_ == '#'; }

  [[nodiscard]] std::string_view peek() const;
  [[noreturn]] void fail_number(std::string_view what, std::string_view expected) const;

  const Source* source_;
  TextStyle style_;
  bool has_carriage_returns_;
  const char* at_;
  const char* end_;
};

/// Takes the next word from the front of a line; empty at its end.
[[nodiscard]] std::string_view take_token(std::string_view& line);

/// Outcome of `parse_number`.
enum class NumberStatus { good, not_a_number, too_large };

struct ParsedNumber {
  double value = 0;
  const char* end = nullptr;  ///< behind the number's last character
  NumberStatus status = NumberStatus::not_a_number;
};

/// The number at the front of `[begin, end)`: decimal, correctly rounded to the type; one too small
/// becomes zero. A sign + is accepted; "nan" and "inf" are numbers.
[[nodiscard]] ParsedNumber parse_number(const char* begin, const char* end, Precision precision);

/// The number that fills a cell of a table. `name` is the cell's in errors, "inf" a number where
/// `may_be_infinite`.
/// \errors `bad` for what is no number; ErrorKind::not_finite.
[[nodiscard]] double cell_number(std::string_view cell, std::string_view name, ErrorKind bad,
                                 bool may_be_infinite = false);

/// What is wrong with a vertex that is not fit for a mesh.
struct CoordinateFault {
  ErrorKind kind = ErrorKind::not_finite;
  std::string what;
  std::string remedy;
};

/// \pre `fit_for_mesh(vertex)` is false.
[[nodiscard]] CoordinateFault describe_fault(const Vec3& vertex);

/// True if all coordinates are finite and of magnitude at most 2^300.
[[nodiscard]] inline bool fit_for_mesh(const Vec3& vertex) {
  return std::abs(vertex.x) <= kMaxCoordinate && std::abs(vertex.y) <= kMaxCoordinate &&
         std::abs(vertex.z) <= kMaxCoordinate;
}

}  // namespace soms::detail
