#include "apps/soms/clash/clash_journal.h"

#include "soms/base/error.h"
#include "soms/base/hash.h"
#include "soms/geometry/mesh.h"
#include "soms/io/encoding.h"

#include "apps/output/json.h"
#include "apps/soms/clash/clash_rows.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace soms::command {

namespace {

constexpr const char* kJournalSchema = "soms.clash.journal/2";

/// Names all that clashes depend on but for the program.
std::uint64_t fingerprint(const ClashModels& models, const ClashOptions& options,
                          std::span<const PartNumbers> candidates) {
  Fnv1a hash;
  hash.add(options.within.value_or(-1));
  for (const ClashSet* const set : {&models.a, &models.b}) {
    hash.add(std::uint64_t{set->parts.size()});
    for (const PartBody& part : set->parts) {
      hash.add(corner_hash(part.body.shape.mesh()));
    }
  }
  for (const auto& [a, b] : candidates) {
    hash.add(a);
    hash.add(b);
  }
  return hash.value();
}

/// Blocks have three levels.
constexpr int kDeepestBlock = 8;

Json point_of(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Vec3 point_at(const Json& list, std::size_t from) {
  return {list.at(from).get<double>(), list.at(from + 1).get<double>(),
          list.at(from + 2).get<double>()};
}

Json as_json(const Clash& clash) {
  Json row = {clash.a,
              clash.b,
              static_cast<unsigned>(clash.kind),
              static_cast<unsigned>(clash.relation),
              static_cast<unsigned>(clash.why),
              clash.triangle_pairs,
              clash.gap.lower,
              clash.gap.upper};
  for (const Vec3& v : {clash.place, clash.box.lower, clash.box.upper}) {
    for (const Json& x : point_of(v)) {
      row.push_back(x);
    }
  }
  if (clash.penetration) {
    row.push_back(clash.penetration->depth);
    for (const Json& x : point_of(clash.penetration->direction)) {
      row.push_back(x);
    }
  }
  return row;
}

/// An enumerator, up to the last one. Throws a Json::exception for no number.
template <class Enum>
std::optional<Enum> enumerator_of(const Json& value, Enum last) {
  const auto number = value.get<std::uint64_t>();
  return value.is_number_unsigned() && number <= static_cast<std::uint64_t>(last)
             ? std::optional(static_cast<Enum>(number))
             : std::nullopt;
}

/// Nothing, or a Json::exception, where the row is none of a list of these parts.
std::optional<Clash> clash_of(const Json& row, const ClashModels& models) {
  constexpr std::size_t kPlace = 8;
  constexpr std::size_t kPenetration = 17;
  const auto a = row.at(0).get<std::uint64_t>();
  const auto b = row.at(1).get<std::uint64_t>();
  const auto kind = enumerator_of(row.at(2), ClashKind::undecided);
  const auto relation = enumerator_of(row.at(3), Relation::undecided);
  const auto why = enumerator_of(row.at(4), Undecided::open);
  if (a >= models.a.parts.size() || b >= models.second().parts.size() || !kind || !relation ||
      !why) {
    return std::nullopt;
  }
  Clash clash{.a = static_cast<std::uint32_t>(a),
              .b = static_cast<std::uint32_t>(b),
              .kind = *kind,
              .relation = *relation,
              .why = *why,
              .triangle_pairs = row.at(5).get<std::uint64_t>(),
              .gap = {row.at(6).get<double>(), row.at(7).get<double>()},
              .place = point_at(row, kPlace),
              .box = {point_at(row, kPlace + 3), point_at(row, kPlace + 6)}};
  if (row.size() > kPenetration) {
    clash.penetration = {row.at(kPenetration).get<double>(), point_at(row, kPenetration + 1)};
  }
  return clash;
}

/// What a line begins with, so that damage is noticed wherever it is.
std::string checksum(std::string_view text) {
  Fnv1a hash;
  for (const char c : text) {
    hash.add_byte(static_cast<std::uint8_t>(c));
  }
  return key_text(hash.value()) + ' ';
}

/// A block as it was written; nothing where the line is no whole one.
std::optional<DecidedClashes> block_of(std::string_view line, const ClashModels& models) {
  const std::size_t at = line.find(' ');
  if (at == std::string_view::npos || checksum(line.substr(at + 1)) != line.substr(0, at + 1)) {
    return std::nullopt;
  }
  const Json block = parse_json(line.substr(at + 1), kDeepestBlock).value;
  if (!block.is_object() || !block.contains("clashes") || !block["clashes"].is_array()) {
    return std::nullopt;
  }
  try {
    DecidedClashes decided{.clashes = {},
                           .done = block.at("done").get<std::size_t>(),
                           .cost = {.node_tests = block.at("cost").at(0).get<std::uint64_t>(),
                                    .triangle_tests = block.at("cost").at(1).get<std::uint64_t>(),
                                    .exact_tests = block.at("cost").at(2).get<std::uint64_t>()}};
    for (const Json& row : block.at("clashes")) {
      const std::optional<Clash> clash = clash_of(row, models);
      if (!clash) {
        return std::nullopt;
      }
      decided.clashes.push_back(*clash);
    }
    return decided;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

ClashJournal::ClashJournal(std::string file, const ClashModels& models, const ClashOptions& options,
                           std::span<const PartNumbers> candidates)
    : file_(std::move(file)) {
  const std::string head =
      json_text({{"schema", kJournalSchema},
                 {"inputs", key_text(fingerprint(models, options, candidates))},
                 {"candidates", candidates.size()}});
  std::error_code fault;
  const std::uintmax_t size = std::filesystem::file_size(file_, fault);
  if (!fault && size > 0) {
    std::ifstream in(file_, std::ios::binary);
    read(in, head, models, candidates.size());
    out_.open(file_, std::ios::binary | std::ios::app);
  } else {
    out_.open(file_, std::ios::binary | std::ios::trunc);
    out_ << head << '\n' << std::flush;
  }
  if (!out_) {
    throw Error(ErrorKind::cannot_write, "--journal " + file_ + ": cannot be written",
                "give a file in a folder that can be written to");
  }
}

void ClashJournal::read(std::ifstream& in, const std::string& head, const ClashModels& models,
                        std::size_t candidates) {
  std::string line;
  if (!in || !std::getline(in, line)) {
    throw Error(ErrorKind::cannot_open, "--journal " + file_ + ": cannot be read",
                "give a file that can be read, or one that does not exist yet");
  }
  if (line != head) {
    refuse_utf16(line, "--journal " + file_);
    const Json found = parse_json(line, kDeepestBlock).value;
    const bool is_journal =
        found.is_object() && found.contains("schema") && found["schema"] == kJournalSchema;
    throw is_journal
        ? Error(ErrorKind::usage, "--journal " + file_ + ": of other models or options",
                "give the models and options of the run that it began with, or another file")
        : Error(ErrorKind::bad_file, "--journal " + file_ + ", line 1: no journal of soms clash",
                "give a journal, or a file that does not exist yet");
  }
  std::uintmax_t whole = line.size() + 1;
  while (std::getline(in, line) && !in.eof()) {
    std::optional<DecidedClashes> block = block_of(line, models);
    if (!block || block->done <= kept_.done || block->done > candidates) {
      break;
    }
    whole += line.size() + 1;
    kept_.clashes.insert(kept_.clashes.end(), block->clashes.begin(), block->clashes.end());
    kept_.done = block->done;
    kept_.cost += block->cost;
  }
  in.close();
  std::error_code fault;
  std::filesystem::resize_file(file_, whole, fault);
  if (fault) {
    throw Error(ErrorKind::cannot_write, "--journal " + file_ + ": " + fault.message(),
                "give a file that can be written to");
  }
}

void ClashJournal::add(std::size_t done, const ClashList& block) {
  Json clashes = Json::array();
  for (const Clash& clash : block.clashes) {
    clashes.push_back(as_json(clash));
  }
  const std::string text = json_text(
      {{"done", done},
       {"cost", {block.cost.node_tests, block.cost.triangle_tests, block.cost.exact_tests}},
       {"clashes", std::move(clashes)}});
  out_ << checksum(text) << text << '\n' << std::flush;
  if (!out_) {
    throw Error(
        ErrorKind::cannot_write, "--journal " + file_ + ": cannot be written",
        "free some space, then run the command again: it continues after the last complete line");
  }
}

}  // namespace soms::command
