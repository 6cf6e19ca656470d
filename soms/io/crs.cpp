#include "soms/io/crs.h"

#include "soms/io/detail/cityjson/epsg_units.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace soms {

namespace {

constexpr std::string_view kEpsg = "EPSG:";

std::string_view without_spaces(std::string_view text) {
  constexpr std::string_view kSpaces = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kSpaces);
  return begin == std::string_view::npos
             ? std::string_view()
             : text.substr(begin, text.find_last_not_of(kSpaces) + 1 - begin);
}

bool begins_with(std::string_view text, std::string_view begin) {
  return text.size() >= begin.size() &&
         std::equal(begin.begin(), begin.end(), text.begin(), [](char want, char has) {
           return want == ('a' <= has && has <= 'z' ? has - 'a' + 'A' : has);
         });
}

/// The number that a text is, of digits alone.
std::optional<std::uint32_t> code_of(std::string_view text) {
  std::uint32_t code = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), code);
  const bool whole = !text.empty() && fault == std::errc() && end == text.data() + text.size();
  return whole ? std::optional(code) : std::nullopt;
}

/// The code behind a prefix and, in URIs, a version that may be missing: "7415" in
/// "crs/EPSG/0/7415".
std::optional<std::uint32_t> code_behind(std::string_view text, std::string_view prefix,
                                         char version_end) {
  if (!begins_with(text, prefix)) {
    return std::nullopt;
  }
  text.remove_prefix(prefix.size());
  if (const std::size_t end = text.find(version_end); end != std::string_view::npos) {
    text.remove_prefix(end + 1);
  }
  return code_of(without_spaces(text));
}

/// The code of one system, in one of the forms in use.
std::optional<std::uint32_t> single_code(std::string_view text) {
  struct Form {
    std::string_view prefix;
    char version_end;
  };

  for (const Form& form :
       {Form{kEpsg, '\0'}, Form{"URN:OGC:DEF:CRS:EPSG:", ':'}, Form{"URN:X-OGC:DEF:CRS:EPSG:", ':'},
        Form{"CRS:EPSG:", ':'}, Form{"HTTP://WWW.OPENGIS.NET/DEF/CRS/EPSG/", '/'},
        Form{"HTTPS://WWW.OPENGIS.NET/DEF/CRS/EPSG/", '/'},
        Form{"HTTP://WWW.OPENGIS.NET/GML/SRS/EPSG.XML#", '\0'}}) {
    if (const auto code = code_behind(text, form.prefix, form.version_end)) {
      return code;
    }
  }
  return std::nullopt;
}

/// The systems of a compound one; a single one is itself.
std::vector<std::string_view> components(std::string_view text) {
  char separator = '+';
  for (const std::string_view form : {"HTTP://WWW.OPENGIS.NET/DEF/CRS-COMPOUND?1=",
                                      "HTTPS://WWW.OPENGIS.NET/DEF/CRS-COMPOUND?1="}) {
    if (begins_with(text, form)) {
      text.remove_prefix(form.size());
      separator = '&';
    }
  }
  if (constexpr std::string_view kUrn = "URN:OGC:DEF:CRS,"; begins_with(text, kUrn)) {
    text.remove_prefix(kUrn.size());
    separator = ',';
  }
  std::vector<std::string_view> all;
  for (bool more = true; more;) {
    const std::size_t end = std::min(text.find(separator), text.size());
    std::string_view one = text.substr(0, end);
    if (constexpr std::string_view kNumbered = "1="; separator == '&' && !all.empty()) {
      one.remove_prefix(std::min(one.size(), kNumbered.size()));
    }
    all.push_back(without_spaces(one));
    more = end < text.size();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all;
}

}  // namespace

std::string crs_name(std::string_view text) {
  text = without_spaces(text);
  const std::string_view whole = text;
  if (text.ends_with('/')) {
    text.remove_suffix(1);
  }
  std::string name;
  for (const std::string_view component : components(text)) {
    // "EPSG:28992+5709" names the registry once.
    const auto code =
        name.empty() || single_code(component) ? single_code(component) : code_of(component);
    if (!code) {
      return std::string(whole);
    }
    name += (name.empty() ? std::string(kEpsg) : "+") + std::to_string(*code);
  }
  return name;
}

CrsAxes crs_axes(std::string_view crs) {
  if (!crs.starts_with(kEpsg)) {
    return {};
  }
  std::optional<CrsAxes> all;
  for (const std::string_view component : components(crs.substr(kEpsg.size()))) {
    const std::uint32_t code = code_of(component).value_or(0);
    const std::span<const detail::EpsgRun> runs = detail::epsg_runs();
    const auto next =
        std::upper_bound(runs.begin(), runs.end(), code,
                         [](std::uint32_t number, const auto& run) { return number < run.first; });
    if (next == runs.begin() || code - (next - 1)->first >= (next - 1)->count) {
      return {};
    }
    const double meters = detail::epsg_meters(*(next - 1));
    const CrsAxes axes{.unit = meters, .angles = meters == 0};
    const bool angles = axes.angles || (all && all->angles);
    const double unit = !all || all->unit == axes.unit ? axes.unit : 0;
    all = {.unit = angles ? 0 : unit, .angles = angles};
  }
  return all.value_or(CrsAxes{});
}

std::string angles_note(std::string_view crs) {
  return "longitude and latitude are angles (" + std::string(crs) +
         "), so lengths and distances have no meaning";
}

}  // namespace soms
