#include "tests/reproduce/well_formed.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

namespace soms::test {

namespace {

bool is_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == ':';
}

/// Reads markup from left to right and keeps the open elements.
class Reader {
 public:
  Reader(std::string_view text, const std::vector<std::string_view>& void_elements)
      : text_(text), void_(void_elements) {}

  std::string fault() {
    while (at_ < text_.size() && fault_.empty()) {
      if (text_[at_] == '<') {
        tag();
      } else {
        character();
      }
    }
    if (fault_.empty() && !open_.empty()) {
      fault_ = "no end of " + open_.back();
    }
    return fault_;
  }

 private:
  void character() {
    if (text_[at_] == '&') {
      const std::size_t end = text_.find(';', at_);
      if (end == std::string_view::npos || end - at_ > 8) {
        fault_ = "bare & at " + std::to_string(at_);
      }
    } else if (text_[at_] == '>') {
      fault_ = "bare > at " + std::to_string(at_);
    }
    ++at_;
  }

  std::string name() {
    std::string result;
    while (at_ < text_.size() && is_name(text_[at_])) {
      result += text_[at_++];
    }
    return result;
  }

  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
      ++at_;
    }
  }

  void tag() {
    ++at_;
    if (text_.substr(at_).starts_with("!DOCTYPE html>")) {
      at_ += 14;
      return;
    }
    const bool end = text_[at_] == '/';
    at_ += end ? 1 : 0;
    const std::string element = name();
    if (element.empty()) {
      fault_ = "bare < at " + std::to_string(at_);
      return;
    }
    if (end) {
      if (open_.empty() || open_.back() != element) {
        fault_ = "end of " + element + " where " + (open_.empty() ? "none" : open_.back()) +
                 " is open, at " + std::to_string(at_);
        return;
      }
      open_.pop_back();
      close('>');
      return;
    }
    attributes(element);
    if (!fault_.empty()) {
      return;
    }
    if (text_.substr(at_).starts_with("/>")) {
      at_ += 2;
      return;
    }
    close('>');
    if (std::find(void_.begin(), void_.end(), element) == void_.end()) {
      open_.push_back(element);
    }
    if (element == "style") {
      at_ = std::min(text_.find("</style>", at_), text_.size());
    }
  }

  void close(char c) {
    if (at_ >= text_.size() || text_[at_] != c) {
      fault_ = "tag without end at " + std::to_string(at_);
      return;
    }
    ++at_;
  }

  void attributes(const std::string& element) {
    std::set<std::string> seen;
    for (skip_space(); at_ < text_.size() && is_name(text_[at_]); skip_space()) {
      const std::string attribute = name();
      if (!seen.insert(attribute).second) {
        fault_ = element + " has " + attribute + " twice, at " + std::to_string(at_);
        return;
      }
      if (!text_.substr(at_).starts_with("=\"")) {
        fault_ = attribute + " without quotes at " + std::to_string(at_);
        return;
      }
      const std::size_t end = text_.find('"', at_ + 2);
      if (end == std::string_view::npos ||
          text_.substr(at_ + 2, end - at_ - 2).find('<') != std::string_view::npos) {
        fault_ = attribute + " without end at " + std::to_string(at_);
        return;
      }
      at_ = end + 1;
    }
  }

  std::string_view text_;
  std::vector<std::string_view> void_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::string fault_;
};

}  // namespace

std::string markup_fault(std::string_view text,
                         const std::vector<std::string_view>& void_elements) {
  return Reader(text, void_elements).fault();
}

std::vector<std::string> values_of(std::string_view text, std::string_view attribute) {
  std::string key = " ";
  key.append(attribute).append("=\"");
  std::vector<std::string> values;
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at)) {
    at += key.size();
    values.emplace_back(text.substr(at, text.find('"', at) - at));
  }
  return values;
}

std::size_t count_of(std::string_view text, std::string_view words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string_view::npos;
       at = text.find(words, at + words.size())) {
    ++count;
  }
  return count;
}

}  // namespace soms::test
