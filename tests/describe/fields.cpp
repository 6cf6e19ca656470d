// Prints the lists of fields and words that the library has, a line of JSON each: what
// tools/fields.py writes stubs and types of.
#include "soms/clash/print.h"
#include "soms/io/print.h"
#include "soms/kinematics/print.h"
#include "soms/motion/print_motion.h"
#include "soms/query/print.h"
#include "soms/robot/print.h"
#include "soms/scene/contact_spans.h"
#include "soms/scene/print.h"
#include "soms/tree/print.h"

#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace {

using namespace soms;

template <class T>
struct Type;

template <class T>
std::string type_text() {
  if constexpr (std::is_same_v<T, bool>) {
    return "bool";
  } else if constexpr (std::is_same_v<T, std::uint8_t>) {
    return "flag";
  } else if constexpr (std::is_same_v<T, double>) {
    return "double";
  } else if constexpr (std::is_same_v<T, std::uint32_t>) {
    return "uint32";
  } else if constexpr (std::is_same_v<T, std::uint64_t>) {
    return "uint64";
  } else if constexpr (std::is_same_v<T, Bracket>) {
    return "bracket";
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return "point";
  } else if constexpr (std::is_same_v<T, Box>) {
    return "box";
  } else if constexpr (std::is_same_v<T, TrianglePair>) {
    return "pair";
  } else if constexpr (Worded<T>) {
    return "enum " + std::string(kWords<T>.type) + (sizeof(T) == 1 ? " 1" : " 4");
  } else if constexpr (Described<T>) {
    return std::string("struct ") + Fields<T>::kName;
  } else if constexpr (soms::detail::kIsOptional<T>) {
    return "optional " + type_text<typename T::value_type>();
  } else if constexpr (soms::detail::kIsVector<T>) {
    return "list " + type_text<typename T::value_type>();
  } else {
    static_assert(std::is_void_v<Type<T>>, "name this type here");
  }
}

std::string json_word(std::string_view text) {
  return quoted_text(text);  // fields and words are plain letters
}

/// Lines about enumerations, by name: whatever names one adds it.
using Lines = std::map<std::string, std::string, std::less<>>;

template <class E>
void add_words(Lines& lines) {
  std::string names;
  for (const std::string_view word : kWords<E>.names) {
    names += (names.empty() ? "" : ",") + json_word(word);
  }
  lines[std::string(kWords<E>.type)] = "{\"enum\":" + json_word(kWords<E>.type) +
                                       ",\"meaning\":" + json_word(kWords<E>.meaning) +
                                       ",\"names\":[" + names + "]}";
}

/// The enumerations of fields, and of what these are made of.
template <class T>
void add_words_of(Lines& lines) {
  if constexpr (Worded<T>) {
    add_words<T>(lines);
  } else if constexpr (soms::detail::kIsOptional<T> || soms::detail::kIsVector<T>) {
    add_words_of<typename T::value_type>(lines);
  } else if constexpr (Described<T>) {
    for_each_field<T>([&](const auto& field) {
      add_words_of<typename std::remove_cvref_t<decltype(field)>::Type>(lines);
    });
  }
}

template <class T>
void print_fields() {
  std::string line = "{\"answer\":" + json_word(Fields<T>::kName) +
                     ",\"meaning\":" + json_word(Fields<T>::kMeaning);
  const auto add = [&](std::string_view key, std::string_view text) {
    line += "," + json_word(key) + ":" + json_word(text);
  };
  if constexpr (requires { Fields<T>::kBatchName; }) {
    add("batch", Fields<T>::kBatchName);
    add("batch_meaning", Fields<T>::kBatchMeaning);
    add("rows", Fields<T>::kRows);
  }
  if constexpr (requires { Fields<T>::kTruth; }) {
    add("truth", "yes");
  }
  if constexpr (requires(const T& t) { t.size(); }) {
    add("size", "yes");
    if constexpr (requires(const T& t) { t.at(0); }) {
      using Single = decltype(std::declval<const T&>().at(0));
      add("at", Fields<Single>::kName);
    }
  }
  std::string list;
  for_each_field<T>([&](const auto& field) {
    using Of = std::remove_cvref_t<decltype(field)>;
    if constexpr (requires { Fields<T>::kValues; }) {
      if constexpr (std::is_same_v<decltype(field.place),
                                   std::remove_const_t<decltype(Fields<T>::kValues)>>) {
        if (field.place == Fields<T>::kValues) {
          add("of", field.name);
        }
      }
    }
    list += (list.empty() ? "" : ",") + ("{\"name\":" + json_word(field.name)) +
            ",\"type\":" + json_word(type_text<typename Of::Type>()) +
            ",\"column\":" + json_word(field.column_name) + ",\"meaning\":" +
            json_word(std::string(field.meaning) +
                      (field.of_triangle ? " 0 without a triangle." : "")) +
            ",\"rows\":" + json_word(field.rows) + "}";
  });
  std::printf("%s,\"fields\":[%s]}\n", line.c_str(), list.c_str());
}

template <class... T>
struct List {
  static void print_fields() { (::print_fields<T>(), ...); }

  static void add_words_of(Lines& lines) { (::add_words_of<T>(lines), ...); }
};

using Answers = List<Cost, Overlap, OverlapBatch, SelfOverlap, Distance, Within, Solid, Contains,
                     ContainsParts, ContainsPartsBatch, Closest, SignedClosest, NearTriangles,
                     Winding, ClosestHit, AnyHit, AllHits, BodyClosest, BodyHit, BodyAllHits,
                     SceneClosest, SceneHit, SceneAllHits, StepReport, ContactSpan, FirstContact>;
using Options = List<ClosestOptions, DistanceOptions, FirstContactOptions, OverlapOptions,
                     RayOptions, SelfOverlapOptions, WindingOptions>;
/// Enumerations that no answer and no options name.
using Others =
    List<ClashKind, ContactChange, JointType, Layout, MeshFormat, Partition, RecordedMesh::Origin,
         RecordingEnding, RobotVerdict, Rotation, Rule, TreeCheck, UpAxis>;

}  // namespace

int main() {
  Lines lines;
  Answers::add_words_of(lines);
  Options::add_words_of(lines);
  Others::add_words_of(lines);
  for (const auto& [name, line] : lines) {
    std::printf("%s\n", line.c_str());
  }
  Answers::print_fields();
  return 0;
}
