#include "thesis/page/html.h"

#include "thesis/run/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, kVerdictCount> kSigns{"&#10003;", "&#8776;",  "&#8764;",
                                                             "&#177;",   "&#10007;", "&#63;"};
constexpr std::array<std::string_view, kVerdictCount> kClasses{
    "holds", "holds_under", "holds_on_some", "undecided", "does_not_hold", "cannot_be_checked"};

constexpr std::array<std::string_view, kNearestStandCount> kNearestSigns{
    "&#10003;", "&#8776;", "&#8764;", "&#177;", "&#8777;", "&#10007;", "&#8230;", "&#63;"};
constexpr std::array<std::string_view, kNearestStandCount> kNearestClasses{
    "holds",        "mostly_holds",  "mixed",        "undecided",
    "mostly_fails", "does_not_hold", "too_few_rows", "cannot_be_checked"};

std::string badge_of(std::string_view style, std::string_view sign, std::string_view words) {
  return fmt::format("<span class=\"badge {}\">{} {}</span>", style, sign, words);
}

}  // namespace

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", to_text(static_cast<std::int64_t>(count)), noun,
                     count == 1 ? "" : "s");
}

std::string badge(Verdict verdict) {
  return badge_of(class_of(verdict), sign_of(verdict), name(verdict));
}

std::string badge(NearestStand stand) {
  return badge_of(class_of(stand), sign_of(stand), name(stand));
}

std::string_view sign_of(Verdict verdict) {
  return kSigns[static_cast<std::size_t>(verdict)];
}

std::string_view sign_of(NearestStand stand) {
  return kNearestSigns[static_cast<std::size_t>(stand)];
}

std::string_view class_of(Verdict verdict) {
  return kClasses[static_cast<std::size_t>(verdict)];
}

std::string_view class_of(NearestStand stand) {
  return kNearestClasses[static_cast<std::size_t>(stand)];
}

std::string sentence(std::string words) {
  if (!words.empty() && words.back() != '.') {
    words += '.';
  }
  return words;
}

std::string spoken(std::string_view item) {
  std::string words(item);
  std::replace(words.begin(), words.end(), '-', ' ');
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') {
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
  }
  return words;
}

}  // namespace soms::reproduce
