#include "soms/io/detail/numbers/npy_header.h"

#include "soms/base/error.h"
#include "soms/io/detail/source.h"
#include "soms/io/detail/text.h"

#include <charconv>
#include <optional>

namespace soms::detail {

namespace {

/// A dictionary of Python with the values that such headers have.
class NpyDictionary {
 public:
  NpyDictionary(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  [[nodiscard]] NpyHeader parse() {
    expect('{');
    while (!take('}')) {
      const std::string_view key = quoted();
      expect(':');
      read_value(key);
      if (!take(',')) {
        expect('}');
        break;
      }
    }
    if (!type_ || !in_fortran_order_ || !shape_) {
      fail("its header lacks descr, fortran_order or shape");
    }
    return checked();
  }

 private:
  [[noreturn]] void fail(const std::string& what,
                         const std::string& remedy = "save the array again with numpy.save") const {
    throw Error(ErrorKind::bad_file, name_ + ": " + what, remedy);
  }

  void skip_blanks() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || is_line_end(text_[at_]))) {
      ++at_;
    }
  }

  bool take(char c) {
    skip_blanks();
    const bool here = at_ < text_.size() && text_[at_] == c;
    at_ += here ? 1U : 0U;
    return here;
  }

  void expect(char c) {
    if (!take(c)) {
      fail("its header is " + in_quotes(text_) + ", not that of a NumPy array");
    }
  }

  bool take(std::string_view word) {
    skip_blanks();
    const bool here = text_.substr(at_).starts_with(word);
    at_ += here ? word.size() : 0;
    return here;
  }

  std::string_view quoted() {
    const char quote = take('"') ? '"' : '\'';
    if (quote == '\'') {
      expect('\'');
    }
    const std::size_t end = text_.find(quote, at_);
    if (end == std::string_view::npos) {
      expect(quote);
    }
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end + 1;
    return word;
  }

  void read_value(std::string_view key) {
    if (key == "descr") {
      if (take('[')) {
        fail("it is an array of records", "save one array of floats, a row of numbers per row");
      }
      type_ = quoted();
    } else if (key == "fortran_order") {
      in_fortran_order_ = take("True");
      if (!*in_fortran_order_ && !take("False")) {
        fail("its fortran_order is neither True nor False");
      }
    } else if (key == "shape") {
      read_shape();
    } else {
      fail("its header has the unknown key " + in_quotes(key));
    }
  }

  void read_shape() {
    shape_.emplace();
    expect('(');
    while (!take(')')) {
      skip_blanks();
      std::uint64_t size = 0;
      const char* const begin = text_.data() + at_;
      const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), size);
      if (error != std::errc()) {
        fail("its shape is not a tuple of whole numbers");
      }
      at_ += static_cast<std::size_t>(end - begin);
      shape_->push_back(size);
      if (!take(',')) {
        expect(')');
        break;
      }
    }
  }

  [[nodiscard]] NpyHeader checked() const {
    const std::string kind = "its numbers are " + in_quotes(*type_);
    const std::string remedy = "save array.astype('<f8')";
    if (*type_ == ">f8" || *type_ == ">f4") {
      fail(kind + ", which is big-endian", remedy);
    }
    if (type_->starts_with("|O")) {
      fail(kind + ": it holds objects of Python", remedy);
    }
    if (*type_ != "<f8" && *type_ != "<f4") {
      fail(kind + ", not little-endian floats of 4 or 8 bytes", remedy);
    }
    if (*in_fortran_order_) {
      fail("it is in Fortran order, column by column", "save numpy.ascontiguousarray(array)");
    }
    return {*type_ == "<f8" ? std::size_t{8} : std::size_t{4}, *shape_};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  const std::string& name_;
  std::optional<std::string_view> type_;
  std::optional<bool> in_fortran_order_;
  std::optional<std::vector<std::uint64_t>> shape_;
};

}  // namespace

NpyHeader parse_npy_header(std::string_view text, const std::string& name) {
  return NpyDictionary(text, name).parse();
}

std::string npy_shape(const std::vector<std::uint64_t>& shape) {
  std::string text = "(";
  for (const std::uint64_t size : shape) {
    text += (text.size() == 1 ? "" : ", ") + std::to_string(size);
  }
  return text + (shape.size() == 1 ? ",)" : ")");
}

}  // namespace soms::detail
