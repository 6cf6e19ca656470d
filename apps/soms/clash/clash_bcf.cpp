#include "apps/soms/clash/clash_bcf.h"

#include "soms/base/error.h"
#include "soms/base/parallel.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/draw/look.h"
#include "apps/output/png_file.h"
#include "apps/output/zip_file.h"
#include "apps/soms/clash/bcf_guid.h"
#include "apps/soms/clash/clash_picture.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

namespace soms::command {

namespace {

constexpr std::size_t kTopicsAtATime = 64;
constexpr const char* kBcfAuthor = "soms";

/// Sides of the box around a clash beyond which viewers hide everything, in reaches of its sight.
constexpr double kClippedAt = 1.5;

/// Meters a unit of the models, where those that declare one agree; else 1.
double meters_a_unit(const ClashModels& models) {
  double unit = 0;
  for (const ClashSet* const set : {&models.a, &models.b}) {
    for (const Mesh& mesh : set->meshes) {
      if (mesh.unit > 0 && unit > 0 && mesh.unit != unit) {
        return 1;
      }
      unit = mesh.unit > 0 ? mesh.unit : unit;
    }
  }
  return unit > 0 ? unit : 1;
}

std::string status_in_bcf(const std::string& status) {
  if (status.empty() || status == "new") {
    return "Open";
  }
  if (status == kResolved) {
    return "Closed";
  }
  std::string words = status;
  words.front() = words.front() >= 'a' && words.front() <= 'z'
                      ? static_cast<char>(words.front() - 'a' + 'A')
                      : words.front();
  return words;
}

std::string file_name(const Json& row, const char* side) {
  const auto at = row.find(side);
  return at == row.end() || !at->is_object()
             ? std::string()
             : std::filesystem::path(text_of(*at, "file")).filename().string();
}

/// A value for people: fractions with few digits, lists in parentheses. Exact ones are in the
/// list's other files.
std::string value_in_text(const Json& value) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  if (value.is_number_float()) {
    return readable(value.get<double>());
  }
  if (!value.is_array()) {
    return json_text(value);
  }
  std::string text;
  for (const Json& item : value) {
    text += (text.empty() ? "(" : ", ") + value_in_text(item);
  }
  return text.empty() ? "()" : text + ")";
}

/// A side in words: its names, its file, and what else the file says of it.
std::string side_in_text(const Json& row, const char* side) {
  std::string text = side_label(row, side);
  const Json& part = row.contains(side) && row[side].is_object() ? row[side] : Json::object();
  for (const char* const key : {"id", "type", "set"}) {
    if (const std::string value = text_of(part, key); !value.empty()) {
      text += fmt::format(", {} {}", key, value);
    }
  }
  return text + fmt::format(" ({})", file_name(row, side));
}

/// A line for each thing that the row says.
std::string description_of(const Json& row) {
  std::string text =
      fmt::format("Class: {}\nFirst part: {}\nSecond part: {}\n", text_of(row, "class"),
                  side_in_text(row, "a"), side_in_text(row, "b"));
  static const std::set<std::string_view> kSaid{"schema", "a", "b", "class"};
  for (const auto& [key, value] : row.items()) {
    if (kSaid.count(key) == 0 && !value.is_null()) {
      std::string words = key;
      std::replace(words.begin(), words.end(), '_', ' ');
      text += fmt::format("{}: {}\n", words, value_in_text(value));
    }
  }
  return text;
}

/// A further line, if a georeference is stated.
std::string georeference_line(const Georeference& georeference) {
  return georeference.empty() ? std::string()
                              : fmt::format("georeference: {}\n", describe(georeference));
}

/// Classes, and groups where rows have them.
std::vector<std::string> labels_of(const Json& row) {
  std::vector<std::string> labels{text_of(row, "class")};
  if (const std::string group = text_of(row, "group"); !group.empty()) {
    labels.push_back(group);
  }
  return labels;
}

/// The part of a side, and the others of its body.
void add_components(const Json& row, const char* side, look::Rgb color,
                    std::vector<BcfComponent>& components) {
  const Json& part = row.contains(side) && row[side].is_object() ? row[side] : Json::object();
  std::string hex = look::hex(color).substr(1);
  std::transform(hex.begin(), hex.end(), hex.begin(), [](char c) {
    return c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  components.push_back({text_of(part, "id"), file_name(row, side), side_label(row, side), hex});
  const Json others = part.value("joined", Json::array());
  for (const Json& other : others) {
    if (other.is_object()) {
      components.push_back(
          {text_of(other, "id"), file_name(row, side), text_of(other, "part"), hex});
    }
  }
}

BcfCamera camera_in_meters(const ClashSight& sight, double unit) {
  const Vec3 forward = -sight.toward;
  Vec3 right = cross(forward, {0, 0, 1});
  right = right * (1 / std::sqrt(dot(right, right)));
  BcfCamera camera{.eye = unit * sight.eye(),
                   .direction = forward,
                   .up = cross(right, forward),
                   .field_of_view = ClashSight::kFieldOfView,
                   .aspect = static_cast<double>(ClashPainter::kSize.width) /
                             static_cast<double>(ClashPainter::kSize.height)};
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    for (const Vec3& outward : {axis, -axis}) {
      camera.clipping.push_back(
          {unit * (sight.focus + kClippedAt * sight.reach * outward), outward});
    }
  }
  return camera;
}

/// Writes one archive.
class BcfWriter {
 public:
  BcfWriter(const ClashReport& report, const ClashBcfOptions& options, std::ostream& out)
      : options_(options),
        clashes_(report),
        painter_(report.models),
        unit_(meters_a_unit(report.models)),
        georeference_(georeference_line(report.models.georeference)),
        zip_(out, ZipForm::plain) {
    head_.version = options.version;
    head_.date = xml_time(creation_time(report.models));
    head_.author = kBcfAuthor;
    head_.project_name = project_name(report.models);
    head_.project_guid = bcf_guid("project " + head_.project_name);
  }

  void write(const Limits& limits) {
    zip_.add_stored("bcf.version", bcf_version_xml(head_));
    zip_.add_packed("project.bcfp", bcf_project_xml(head_));
    const std::size_t count = clashes_.size();
    for (std::size_t first = 0; first < count; first += kTopicsAtATime) {
      write_topics(first, std::min(count, first + kTopicsAtATime), limits);
      if (limits.progress) {
        limits.progress(static_cast<double>(first) / static_cast<double>(count));
      }
    }
    if (options_.version == BcfVersion::v3_0) {
      zip_.add_packed("extensions.xml", bcf_extensions_xml(head_, statuses_, labels_));
    }
    zip_.finish();
  }

 private:
  /// A topic and its picture.
  struct Made {
    BcfTopic topic;
    std::string snapshot;
  };

  [[nodiscard]] static std::string project_name(const ClashModels& models) {
    const auto first = [](const ClashSet& set) {
      std::string name = set.meshes.empty()
                             ? std::string("no model")
                             : std::filesystem::path(set.meshes.front().source).filename().string();
      return set.meshes.size() > 1 ? fmt::format("{} and {} more", name, set.meshes.size() - 1)
                                   : name;
    };
    return models.two_sets ? fmt::format("Clashes of {} with {}", first(models.a), first(models.b))
                           : "Clashes of " + first(models.a);
  }

  void write_topics(std::size_t first, std::size_t last, const Limits& limits) {
    std::vector<Made> made(last - first);
    Limits quiet = limits;
    quiet.progress = {};
    for_each_chunk(made.size(), 1, quiet, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        made[k] = make(first + k);
      }
    });
    for (Made& each : made) {
      put(each);
    }
  }

  [[nodiscard]] Made make(std::size_t k) const {
    const ListedClash clash = clashes_.at(k);
    Made made;
    BcfTopic& topic = made.topic;
    topic.guid = text_of(clash.row, "key");  // until `put` makes a GUID of it
    topic.index = k;
    topic.title = fmt::format("{}: {} and {}", text_of(clash.row, "class"),
                              side_label(clash.row, "a"), side_label(clash.row, "b"));
    topic.status = status_in_bcf(text_of(clash.row, "status"));
    topic.labels = labels_of(clash.row);
    topic.description = description_of(clash.row) + georeference_;
    for (const char* const side : {"a", "b"}) {
      const std::string file = file_name(clash.row, side);
      if (!file.empty() &&
          std::find(topic.files.begin(), topic.files.end(), file) == topic.files.end()) {
        topic.files.push_back(file);
      }
    }
    add_components(clash.row, "a", look::kBodyA.light, topic.components);
    add_components(clash.row, "b", look::kBodyB.light, topic.components);
    if (const auto sight = sight_of(clashes_.report().models, clash)) {
      topic.camera = camera_in_meters(*sight, unit_);
      topic.has_snapshot = options_.snapshots;
      if (options_.snapshots) {
        const look::Picture drawn = painter_.draw(clash, *sight);
        made.snapshot = png_bytes(static_cast<std::size_t>(drawn.size.width),
                                  static_cast<std::size_t>(drawn.size.height), drawn.bytes);
      }
    }
    return made;
  }

  void put(Made& made) {
    BcfTopic& topic = made.topic;
    const std::string key = topic.guid;
    // Keys differ, but an older list may have been edited.
    const std::size_t before = seen_[key]++;
    const std::string name = before == 0 ? key : fmt::format("{} {}", key, before + 1);
    topic.guid = bcf_guid("topic " + name);
    if (topic.camera) {
      topic.viewpoint_guid = bcf_guid("viewpoint " + name);
    }
    statuses_.insert(topic.status);
    labels_.insert(topic.labels.begin(), topic.labels.end());
    const std::string folder = topic.guid + "/";
    zip_.add_packed(folder + "markup.bcf", bcf_markup_xml(head_, topic));
    if (topic.camera) {
      zip_.add_packed(folder + kBcfViewpoint, bcf_viewpoint_xml(head_, topic));
    }
    if (topic.has_snapshot) {
      zip_.add_stored(folder + kBcfSnapshot, made.snapshot);
    }
  }

  ClashBcfOptions options_;
  ListedClashes clashes_;
  ClashPainter painter_;
  double unit_;
  std::string georeference_;
  ZipWriter zip_;
  BcfHead head_;
  std::map<std::string, std::size_t> seen_;
  std::set<std::string> statuses_;
  std::set<std::string> labels_;
};

}  // namespace

std::int64_t creation_time(const ClashModels& models) {
  if (const char* const stated = std::getenv("SOURCE_DATE_EPOCH"); stated != nullptr) {
    const std::string_view text(stated);
    std::int64_t seconds = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    constexpr std::int64_t kYear10000 = 253402300800;
    if (fault != std::errc() || end != text.data() + text.size() || seconds < 0 ||
        seconds >= kYear10000) {
      throw Error(ErrorKind::usage, fmt::format("SOURCE_DATE_EPOCH is \"{}\"", text),
                  "set it to a whole number of seconds since 1970, or unset it");
    }
    return seconds;
  }
  std::int64_t newest = 0;
  for (const ClashSet* const set : {&models.a, &models.b}) {
    for (const Mesh& mesh : set->meshes) {
      struct stat file {};

      if (::stat(mesh.source.c_str(), &file) == 0 && S_ISREG(file.st_mode)) {
        newest = std::max<std::int64_t>(newest, file.st_mtime);
      }
    }
  }
  return newest;
}

std::string xml_time(std::int64_t seconds) {
  using std::chrono::days;
  using std::chrono::hh_mm_ss;
  const std::chrono::sys_seconds time{std::chrono::seconds(seconds)};
  const auto day = std::chrono::floor<days>(time);
  const std::chrono::year_month_day date(day);
  const hh_mm_ss clock(time - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count());
}

void write_clashes_as_bcf(const ClashReport& report, const ClashBcfOptions& options,
                          Console& console, std::ostream& out) {
  Progress bar = console.progress("drawing clashes");
  Limits limits = console.limits().without_deadline();
  if (report.interrupted) {
    limits.stop = {};  // Ctrl-C ended the comparison; what was found is written all the same
  }
  limits.progress = [&bar](double share) { bar.show(share); };
  BcfWriter(report, options, out).write(limits);
}

}  // namespace soms::command
