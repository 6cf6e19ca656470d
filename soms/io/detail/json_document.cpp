#include "soms/io/detail/json_document.h"

#include "soms/geometry/detail/counts.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

using nlohmann::json;

constexpr std::size_t kDeepest = 128;
constexpr std::string_view kRepair = "get the complete file, or repair it";
/// Bytes that a value takes at most beyond its text: in a list that grows, and when it is freed.
constexpr std::uint64_t kBytesPerValue = 64;
/// Bytes of an object or a list without what it holds.
constexpr std::uint64_t kBytesPerContainer = 64;
constexpr std::uint64_t kBytesPerMember = 96;
constexpr std::uint64_t kBytesPerText = 48;
/// The parser holds a word twice while it grows.
constexpr std::uint64_t kParserFactor = 6;

/// Takes the parser's events, which names its functions, and builds the document without recursion.
class DocumentBuilder {
 public:
  using number_integer_t = json::number_integer_t;
  using number_unsigned_t = json::number_unsigned_t;
  using number_float_t = json::number_float_t;
  using string_t = json::string_t;
  using binary_t = json::binary_t;

  DocumentBuilder(Source& source, json& root) : source_(source), root_(root) {}

  bool null() { return add(json()); }

  bool boolean(bool value) { return add(json(value)); }

  bool number_integer(number_integer_t value) { return add(json(value)); }

  bool number_unsigned(number_unsigned_t value) { return add(json(value)); }

  bool number_float(number_float_t value, const string_t&) { return add(json(value)); }

  bool string(string_t& value) {
    charge(kBytesPerText + value.capacity());
    return add(json(std::move(value)));
  }

  bool binary(binary_t&) { return false; }

  bool start_object(std::size_t) { return open(json::object()); }

  bool start_array(std::size_t) { return open(json::array()); }

  bool key(string_t& name) {
    charge(kBytesPerMember + name.capacity());
    const auto [member, is_new] = open_.back()->emplace(std::move(name), nullptr);
    member_ = &*member;
    repeated_ = is_new ? repeated_ : member_;
    return is_new;
  }

  bool end_object() { return close(); }

  bool end_array() { return close(); }

  bool parse_error(std::size_t position, const std::string&, const json::exception& error) {
    position_ = position > 0 ? position - 1 : 0;
    constexpr int kNumberTooLarge = 406;  // nlohmann's number for it
    too_large_ = error.id == kNumberTooLarge;
    return false;
  }

  /// Where parsing ended, in bytes.
  [[nodiscard]] std::size_t position() const { return position_; }

  [[nodiscard]] bool too_large() const { return too_large_; }

  /// The member whose name stood a second time.
  [[nodiscard]] const json* repeated() const { return repeated_; }

  [[nodiscard]] bool too_deep() const { return too_deep_; }

 private:
  void charge(std::uint64_t bytes) {
    if (!source_.budget.take(bytes)) {
      source_.fail_memory(bytes);
    }
  }

  json* put(json&& value) {
    constexpr std::uint64_t kEventsPerTick = 1 << 16;
    if (events_++ % kEventsPerTick == 0) {
      check(source_.limits);
    }
    charge(kBytesPerValue);
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    if (open_.back()->is_array()) {
      auto& list = open_.back()->get_ref<json::array_t&>();
      list.push_back(std::move(value));
      return &list.back();
    }
    *member_ = std::move(value);
    return member_;
  }

  bool add(json&& value) {
    put(std::move(value));
    return true;
  }

  bool open(json&& value) {
    too_deep_ = open_.size() >= kDeepest;
    if (too_deep_) {
      return false;
    }
    charge(kBytesPerContainer);
    open_.push_back(put(std::move(value)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  Source& source_;
  json& root_;
  std::vector<json*> open_;
  json* member_ = nullptr;  ///< of the innermost object, awaiting its value
  std::uint64_t events_ = 0;
  std::size_t position_ = 0;
  bool too_large_ = false;
  const json* repeated_ = nullptr;
  bool too_deep_ = false;
};

/// The bracket that opens more than `kDeepest` levels, in JSON that is right up to there.
std::size_t too_deep_at(std::string_view text) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (in_string && c == '\\') {
      ++at;
    } else if (c == '"') {
      in_string = !in_string;
    } else if (!in_string && (c == '[' || c == '{')) {
      if (depth++ == kDeepest) {
        return at;
      }
    } else if (!in_string && (c == ']' || c == '}')) {
      --depth;
    }
  }
  return 0;
}

const json& known(const void* value) {
  return *static_cast<const json*>(value);
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): an empty value of nlohmann's throws nothing.
struct JsonDocument::Root {
  json value;
};

JsonDocument::JsonDocument(Source& source, std::string_view text, std::size_t offset, bool binary,
                           std::string where)
    : source_(source), where_(std::move(where)), root_(std::make_unique<Root>()) {
  const std::uint64_t left_before = source.budget.left();
  const auto fail = [&](std::size_t at, ErrorKind kind, const std::string& what) {
    if (binary) {
      source.fail_byte(offset + at, kind, what, std::string(kRepair));
    }
    source.fail_line(offset + at, kind, what, std::string(kRepair));
  };
  // The parser takes a zero byte for the end.
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    fail(zero, ErrorKind::bad_file, "the JSON contains a zero byte");
  }
  const std::uint64_t bytes_needed = kParserFactor * text.size();
  if (!source.budget.take(bytes_needed)) {
    source.fail_memory(bytes_needed);
  }
  DocumentBuilder builder(source, root_->value);
  if (!json::sax_parse(text.begin(), text.end(), &builder)) {
    if (builder.repeated() != nullptr) {
      JsonValue(*this, builder.repeated()).fail("this name occurs twice in its object");
    }
    if (builder.too_deep()) {
      fail(too_deep_at(text), ErrorKind::bad_file,
           "JSON is nested more than " + std::to_string(kDeepest) + " levels deep");
    }
    if (builder.too_large()) {
      fail(builder.position(), ErrorKind::not_finite, "a number is too large for a double");
    }
    fail(builder.position(), ErrorKind::bad_file,
         builder.position() + 1 >= text.size() ? "the JSON ends too soon"
                                               : "this is not valid JSON");
  }
  source.budget.give_back(bytes_needed);
  taken_ = left_before - source.budget.left();
}

JsonDocument::~JsonDocument() {
  source_.budget.give_back(taken_);
}

JsonValue JsonDocument::root() const {
  return {*this, &root_->value};
}

/// Depth first, each open object or list with the place in it.
std::string JsonDocument::path_of(const void* target) const {
  struct Level {
    const json* container;
    json::const_iterator at;
  };

  std::vector<Level> levels;
  const json* value = &root_->value;
  while (value != target) {
    if (value->is_structured() && !value->empty()) {
      levels.push_back({value, value->begin()});
    } else {
      while (!levels.empty() && ++levels.back().at == levels.back().container->end()) {
        levels.pop_back();
      }
    }
    if (levels.empty()) {
      return {};
    }
    value = &*levels.back().at;
  }
  std::string path;
  for (const Level& level : levels) {
    if (level.container->is_array()) {
      path.append("[").append(std::to_string(level.at - level.container->begin())).append("]");
    } else {
      const std::string key = in_quotes(level.at.key());
      path.append(path.empty() ? "" : ".").append(key, 1, key.size() - 2);
    }
  }
  return path;
}

bool JsonValue::is_object() const {
  return known(value_).is_object();
}

bool JsonValue::is_null() const {
  return known(value_).is_null();
}

bool JsonValue::is_text() const {
  return known(value_).is_string();
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  const json& value = known(value_);
  if (!value.is_object()) {
    fail("expected an object");
  }
  const auto member = value.find(key);
  if (member == value.end()) {
    return std::nullopt;
  }
  return JsonValue(*document_, &*member);
}

std::optional<std::string_view> JsonValue::first_name() const {
  const json& value = known(value_);
  if (!value.is_object()) {
    fail("expected an object");
  }
  if (value.empty()) {
    return std::nullopt;
  }
  return value.begin().key();
}

std::vector<std::pair<std::string_view, JsonValue>> JsonValue::members() const {
  const json& value = known(value_);
  if (!value.is_object()) {
    fail("expected an object");
  }
  std::vector<std::pair<std::string_view, JsonValue>> members;
  members.reserve(value.size());
  for (auto member = value.begin(); member != value.end(); ++member) {
    members.emplace_back(member.key(), JsonValue(*document_, &*member));
  }
  return members;
}

std::string JsonValue::as_text() const {
  const json& value = known(value_);
  return value.is_string() ? value.get<std::string>()
                           : value.dump(-1, ' ', false, json::error_handler_t::replace);
}

JsonValue JsonValue::at(std::string_view key) const {
  const std::optional<JsonValue> member = find(key);
  if (!member) {
    fail(in_quotes(key) + " is missing");
  }
  return *member;
}

std::size_t JsonValue::size() const {
  if (!known(value_).is_array()) {
    fail("expected a list");
  }
  return known(value_).size();
}

JsonValue JsonValue::at(std::size_t index) const {
  return {*document_, &known(value_)[index]};
}

std::uint64_t JsonValue::whole() const {
  if (known(value_).is_number_unsigned()) {
    return known(value_).get<std::uint64_t>();
  }
  constexpr double kMostExact = 0x1p53;
  if (known(value_).is_number_float()) {
    const auto value = known(value_).get<double>();
    if (value >= 0 && value <= kMostExact && std::floor(value) == value) {
      return static_cast<std::uint64_t>(value);
    }
  }
  fail("expected a whole number of at least 0");
}

double JsonValue::number() const {
  if (!known(value_).is_number()) {
    fail("expected a number");
  }
  return known(value_).get<double>();
}

bool JsonValue::boolean() const {
  if (!known(value_).is_boolean()) {
    fail("expected true or false");
  }
  return known(value_).get<bool>();
}

std::string_view JsonValue::text() const {
  if (!known(value_).is_string()) {
    fail("expected a string");
  }
  return known(value_).get_ref<const std::string&>();
}

JsonValue JsonValue::referred(std::string_view list) const {
  const std::uint64_t index = whole();
  const std::optional<JsonValue> items = document_->root().find(list);
  const std::size_t count = items ? items->size() : 0;
  if (index >= count) {
    fail(index_fault("number " + std::to_string(index), std::string(list), count));
  }
  return items->at(static_cast<std::size_t>(index));
}

std::string JsonValue::path() const {
  return document_->path_of(value_);
}

void JsonValue::fail(ErrorKind kind, const std::string& what, const std::string& remedy) const {
  std::string place = document_->source().name;
  for (const std::string& part : {document_->where(), path()}) {
    place += part.empty() ? "" : ", " + part;
  }
  throw Error(kind, place + ": " + what, remedy);
}

void JsonValue::fail(const std::string& what) const {
  fail(ErrorKind::bad_file, what, std::string(kRepair));
}

std::string json_text(std::string_view text) {
  return json(text).dump(-1, ' ', true, json::error_handler_t::replace);
}

}  // namespace soms::detail
