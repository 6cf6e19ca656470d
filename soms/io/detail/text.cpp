#include "soms/io/detail/text.h"

#include "soms/base/decimal.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace soms::detail {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Passes a plus sign before a digit: from_chars takes none.
const char* behind_plus(const char* begin, const char* end) {
  return begin != end && *begin == '+' && begin + 1 != end && is_digit(begin[1]) ? begin + 1
                                                                                 : begin;
}

/// True if a number out of its type's range is too large, not too small: by the decimal exponent of
/// its first digit that is not zero.
bool exceeds(const char* begin, const char* end) {
  const char* p = begin;
  std::int64_t exponent = 0;
  bool point = false;
  bool found = false;
  for (; p != end && *p != 'e' && *p != 'E'; ++p) {
    if (*p == '.') {
      point = true;
    } else if (is_digit(*p)) {
      found = found || *p != '0';
      exponent += found && !point ? 1 : 0;
      exponent -= !found && point ? 1 : 0;
    }
  }
  if (p == end) {
    return exponent > 0;
  }
  ++p;
  const bool negative = p != end && *p == '-';
  p += p != end && (*p == '-' || *p == '+') ? 1 : 0;
  std::int64_t written = 0;
  if (std::from_chars(p, end, written).ec != std::errc()) {
    return !negative;
  }
  // Files are shorter than 2^60 digits, so the sum cannot overflow once this is bounded.
  written = std::min(written, std::int64_t{1} << 61);
  return exponent + (negative ? -written : written) > 0;
}

template <class T>
ParsedNumber parse(const char* begin, const char* end) {
  T value = 0;
  const auto [stop, error] = read_decimal(begin, end, value);
  if (error == std::errc()) {
    return {static_cast<double>(value), stop, NumberStatus::good};
  }
  if (error != std::errc::result_out_of_range) {
    return {};
  }
  if (exceeds(begin, stop)) {
    return {0, stop, NumberStatus::too_large};
  }
  return {*begin == '-' ? -0.0 : 0.0, stop, NumberStatus::good};
}

const char* find_line_feed(const char* begin, const char* end) {
  const void* const found = std::memchr(begin, '\n', static_cast<std::size_t>(end - begin));
  return found == nullptr ? end : static_cast<const char*>(found);
}

}  // namespace

TextScanner::TextScanner(const Source& source, std::size_t position, const TextStyle& style)
    : source_(&source),
      style_(style),
      has_carriage_returns_(source.bytes.find('\r', position) != std::string_view::npos),
      at_(source.bytes.data() + position),
      end_(source.bytes.data() + source.bytes.size()) {
}

std::size_t TextScanner::line_end_at(const char* p) const {
  if (p == end_ || !is_line_end(*p)) {
    return 0;
  }
  return *p == '\r' && p + 1 != end_ && p[1] == '\n' ? 2 : 1;
}

void TextScanner::skip_blanks() {
  while (at_ != end_) {
    if (is_blank(*at_)) {
      ++at_;
    } else if (style_.continued && *at_ == '\\' && line_end_at(at_ + 1) > 0) {
      at_ += 1 + line_end_at(at_ + 1);
    } else {
      return;
    }
  }
}

void TextScanner::skip_space() {
  while (at_ != end_ && (is_blank(*at_) || is_line_end(*at_))) {
    ++at_;
  }
}

bool TextScanner::comment_before(const char* end) const {
  for (const char* p = at_; style_.comments && p != end; ++p) {
    const void* const found = std::memchr(p, '#', static_cast<std::size_t>(end - p));
    if (found == nullptr) {
      return false;
    }
    p = static_cast<const char*>(found);
    if (p == at_ || is_blank(p[-1])) {
      return true;
    }
  }
  return false;
}

void TextScanner::skip_line() {
  while (at_ != end_) {
    const char* const stop =
        has_carriage_returns_ ? std::find_if(at_, end_, is_line_end) : find_line_feed(at_, end_);
    const bool joined =
        style_.continued && stop != at_ && stop[-1] == '\\' && !comment_before(stop);
    at_ = stop + line_end_at(stop);
    if (!joined) {
      return;
    }
  }
}

bool TextScanner::at_line_end() {
  skip_blanks();
  return at_ == end_ || is_line_end(*at_) || at_comment();
}

bool TextScanner::find_line() {
  while (at_ != end_ && at_line_end()) {
    skip_line();
  }
  return at_ != end_;
}

std::string_view TextScanner::peek() const {
  const char* stop = at_;
  while (!parts(stop)) {
    ++stop;
  }
  return {at_, static_cast<std::size_t>(stop - at_)};
}

std::string_view TextScanner::token_in_line() {
  skip_blanks();
  const std::string_view found = peek();
  at_ += found.size();
  return found;
}

std::string_view TextScanner::token() {
  skip_space();
  return token_in_line();
}

std::string_view TextScanner::rest_of_line() {
  skip_blanks();
  const char* begin = at_;
  while (at_ != end_ && !is_line_end(*at_)) {
    ++at_;
  }
  const char* stop = at_;
  while (stop != begin && is_blank(stop[-1])) {
    --stop;
  }
  at_ += line_end_at(at_);
  return {begin, static_cast<std::size_t>(stop - begin)};
}

void TextScanner::fail_missing(std::string_view what) const {
  fail(ErrorKind::bad_file,
       std::string(what) + " is missing: the " + (at_end() ? "file" : "line") + " ends",
       at_end() ? "get the complete file, or repair it"
                : "repair the file, or put all values of a row on one line");
}

void TextScanner::fail_surplus(std::string_view what, const std::string& remedy) const {
  TextScanner surplus = *this;
  fail(ErrorKind::bad_file, in_quotes(surplus.token_in_line()) + " follows " + std::string(what),
       remedy);
}

void TextScanner::fail_number(std::string_view what, std::string_view expected) const {
  const std::string_view found = peek();
  if (found.empty()) {
    fail_missing(what);
  }
  fail(ErrorKind::bad_file,
       std::string(what) + " is " + in_quotes(found) + ", not " + std::string(expected),
       "repair the file");
}

double TextScanner::number(Precision precision, std::string_view what) {
  skip_blanks();
  const ParsedNumber parsed = parse_number(at_, end_, precision);
  if (parsed.status == NumberStatus::not_a_number || !parts(parsed.end)) {
    fail_number(what, "a number");
  }
  if (parsed.status == NumberStatus::too_large) {
    fail(ErrorKind::not_finite,
         std::string(what) + " is " + in_quotes(peek()) + ", too large for a " +
             (precision == Precision::as_float ? "float" : "double"),
         "repair or scale the model");
  }
  at_ = parsed.end;
  return parsed.value;
}

Vec3 TextScanner::vertex(Precision precision) {
  Vec3 v;
  v.x = number(precision, "x of a vertex");
  v.y = number(precision, "y of a vertex");
  v.z = number(precision, "z of a vertex");
  if (!fit_for_mesh(v)) [[unlikely]] {
    const CoordinateFault fault = describe_fault(v);
    fail(fault.kind, fault.what, fault.remedy);
  }
  return v;
}

std::int64_t TextScanner::integer(std::string_view what) {
  skip_blanks();
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(behind_plus(at_, end_), end_, value);
  if (error != std::errc() || !parts(stop)) {
    fail_number(what, "a whole number");
  }
  at_ = stop;
  return value;
}

std::int64_t TextScanner::slashed_integer(std::string_view what) {
  skip_blanks();
  std::int64_t value = 0;
  auto [p, error] = std::from_chars(behind_plus(at_, end_), end_, value);
  for (int slashes = 0; error == std::errc() && slashes < 2 && p != end_ && *p == '/'; ++slashes) {
    ++p;
    if (!parts(p) && *p != '/') {
      std::int64_t passed = 0;
      const auto next = std::from_chars(p, end_, passed);
      p = next.ptr;
      error = next.ec;
    }
  }
  if (error != std::errc() || !parts(p)) {
    fail_number(what, "a vertex number (v, v/vt, v//vn or v/vt/vn)");
  }
  at_ = p;
  return value;
}

std::string_view take_token(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin])) {
    ++begin;
  }
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) {
    ++end;
  }
  const std::string_view found = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return found;
}

ParsedNumber parse_number(const char* begin, const char* end, Precision precision) {
  if (begin != end && *begin == '+' && begin + 1 != end && begin[1] != '-') {
    ++begin;
  }
  return precision == Precision::as_float ? parse<float>(begin, end) : parse<double>(begin, end);
}

double cell_number(std::string_view cell, std::string_view name, ErrorKind bad,
                   bool may_be_infinite) {
  const char* end = cell.data() + cell.size();
  const ParsedNumber parsed = parse_number(cell.data(), end, Precision::as_double);
  if (parsed.status == NumberStatus::not_a_number || parsed.end != end) {
    const bool has_comma = cell.find(',') != std::string_view::npos;
    throw Error(bad, std::string(name) + " is " + in_quotes(cell) + ", not a number",
                has_comma ? "write a decimal point in place of the comma: 1.5"
                          : "give a number such as 1.5 or -2e3");
  }
  const bool infinite = parsed.status == NumberStatus::good && std::isinf(parsed.value);
  if (!(infinite && may_be_infinite) &&
      (parsed.status == NumberStatus::too_large || !std::isfinite(parsed.value))) {
    throw Error(ErrorKind::not_finite,
                std::string(name) + " is " + in_quotes(cell) + ", not a finite number",
                "give a finite number");
  }
  return parsed.value;
}

CoordinateFault describe_fault(const Vec3& vertex) {
  std::size_t axis = 0;
  while (axis < 2 && std::abs(vertex[axis]) <= kMaxCoordinate) {
    ++axis;
  }
  const std::string what = std::string(1, "xyz"[axis]) + " of a vertex ";
  if (!std::isfinite(vertex[axis])) {
    return {ErrorKind::not_finite, what + "is not a finite number", "repair or drop the vertex"};
  }
  return {ErrorKind::out_of_range, what + "exceeds 2^300", "scale the model"};
}

}  // namespace soms::detail
