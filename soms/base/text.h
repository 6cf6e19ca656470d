/// \file
/// Words from anywhere, such as names in files, made fit for whoever reads them next: a browser, a
/// terminal, a spreadsheet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace soms {

/// Bytes of the UTF-8 character that begins at `at`; 0 if none does. \pre at < words.size().
[[nodiscard]] std::size_t utf8_character(std::string_view words, std::size_t at);

/// The characters of `words`; each byte that is no UTF-8 becomes U+FFFD.
[[nodiscard]] std::u32string code_points(std::string_view words);

/// `words` as text or attribute of an XML or HTML file: markup and quotes escaped, what XML or
/// UTF-8 forbids replaced by '?'.
[[nodiscard]] std::string xml_text(std::string_view words);

/// Shortest text from which the same double is read: "0.1", "1e+300", "-0", "nan", "inf".
[[nodiscard]] std::string shortest(double value);

/// A size in memory, rounded to a tenth of its unit: "1 byte", "512 bytes", "1.5 KiB", "11.6 MiB".
[[nodiscard]] std::string readable_bytes(std::uint64_t bytes);

/// `words` in double quotes, on one line and fit for a terminal: quotes and backslashes after a
/// backslash, control characters, marks that turn the direction of text, and
/// what is no UTF-8 as \xNN.
[[nodiscard]] std::string quoted_text(std::string_view words);

/// `words` on one line of a terminal, which obeys nothing in it: control characters, those that
/// turn the direction of text, and bytes that are not UTF-8 become '?'.
[[nodiscard]] std::string printable(std::string_view words);

/// `words` as one field of a CSV file (RFC 4180): in quotes where it holds a comma, a quote, a
/// semicolon, a tab or a line break, each quote doubled.
///
/// Spreadsheets take a field for a formula by its first character. So an apostrophe stands before
/// each '=', '+', '-', '@' or apostrophe that begins the field or directly follows a comma, a
/// semicolon, a tab or a line break in it, and before a tab or line break that begins the field.
/// `csv_words` takes them away again. Bytes that are not UTF-8, and control characters other than
/// tab and line breaks, become U+FFFD and stay so.
[[nodiscard]] std::string csv_field(std::string_view words);

/// The words that `csv_field` wrote, from the field without its quotes and with each doubled quote
/// made one, as every CSV reader returns it.
[[nodiscard]] std::string csv_words(std::string_view field);

}  // namespace soms
