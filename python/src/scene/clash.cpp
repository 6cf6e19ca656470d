#include "soms/clash/clash.h"

#include "soms/clash/part_keys.h"
#include "soms/clash/penetration.h"
#include "soms/clash/print.h"
#include "soms/query/print.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/function.h"
#include "python/src/objects.h"
#include "python/src/part_set.h"
#include "python/src/scene/record_columns.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>

namespace soms::python {

namespace {

constexpr const char* kClashDoc =
    R"(clash(a, b=None, *, within=None, pairs=None, timeout=None, threads=1, progress=None)

Which parts of a clash with which of b, or with each other? Each pair is decided exactly: crossing,
inside, same, touching, near or undecided (ClashKind).

a, b: PartBodies; or a Mesh, Shape, Body, or a list of them, whose parts are compared. Without b each
pair of parts of a, once. within: parts that share nothing and are at most so far apart are near; None:
none is. pairs: (k, 2), numbers of parts; only these are compared. timeout, threads, progress: as for
overlap; with timeout, pairs that are not decided then are left out, and coverage is cut.

Models are taken as they are: turn one that is y up by Mesh.transformed(1, 'y') first.

Returns ClashList, sorted by the numbers of the parts. Raises Error of kind usage (arguments, shapes),
out_of_range (a part that is not there, 2^27 parts), not_rigid.
Cost: a broad phase over the boxes; solid, and overlap where surfaces meet, for each pair of boxes that
meet; distance for each that may be near.)";

constexpr const char* kPenetrationDoc = R"(penetration(a, b, *, threads=1)

How far do two convex bodies go into each other: the shortest shift of b after which they share no
interior.

a, b: Body, Shape or Mesh, closed and convex to a millionth of its extent. threads: for their trees.

Returns Penetration, of depth 0 where they are apart; None where they have too many edges in directions
of their own. It may exceed the least shift by about a millionth of the extents, and always separates.
Raises Error of kind not_closed, usage (not convex).)";

/// A list with the parts that its numbers name.
struct HeldClashes {
  ClashList list;
  SharedParts a;
  SharedParts b;  ///< `a`, if it was compared with itself
  std::vector<std::uint64_t> keys;

  [[nodiscard]] bool operator==(const HeldClashes& other) const {
    return list == other.list && keys == other.keys;
  }
};

std::ostream& operator<<(std::ostream& out, const HeldClashes& held) {
  return out << held.list;
}

}  // namespace

template <>
inline constexpr bool kPicklesItself<HeldClashes> = true;

namespace {

/// With the parts, which copies of a list share.
py::tuple clashes_state(const HeldClashes& held) {
  py::tuple list = packed(held.list);
  return py::make_tuple(held.a, held.b, std::move(list), packed(held.keys));
}

HeldClashes clashes_from(const py::tuple& state) {
  if (state.size() != 4) {
    refuse_pickle();
  }
  return {.list = unpacked<ClashList>(state[2]),
          .a = state[0].cast<SharedParts>(),
          .b = state[1].cast<SharedParts>(),
          .keys = unpacked<std::vector<std::uint64_t>>(state[3])};
}

std::vector<std::uint64_t> keys_of(const HeldClashes& held) {
  std::vector<MeshPart> named;
  const auto add = [&](const PartSet& set) {
    for (std::size_t k = 0; k < set.parts.size(); ++k) {
      named.push_back({set.mesh_of(k), &set.parts[k]});
    }
  };
  add(*held.a);
  if (held.b != held.a) {
    add(*held.b);
  }
  const std::vector<std::uint64_t> parts = part_keys(named);
  const std::size_t second = held.b == held.a ? 0 : held.a->parts.size();
  std::vector<std::uint64_t> keys;
  for (const Clash& clash : held.list.clashes) {
    keys.push_back(clash_key(parts[clash.a], parts[second + clash.b]));
  }
  return keys;
}

/// Sorted pairs, of one set the lesser number first.
std::vector<PartNumbers> pairs_of(const py::object& given, const PartSet& a, const PartSet& b) {
  Extents shape;
  const std::vector<TriangleId> ids = ids_of(given, "pairs", shape);
  const bool is_empty_list = shape.size() == 1 && shape[0] == 0;
  if (!is_empty_list && (shape.size() != 2 || shape[1] != 2)) {
    refuse_shape(py::array::ensure(given), "pairs", "shape (k, 2)");
  }
  std::vector<PartNumbers> pairs;
  for (std::size_t i = 0; i + 1 < ids.size(); i += 2) {
    if (ids[i] >= a.parts.size() || ids[i + 1] >= b.parts.size()) {
      throw Error(ErrorKind::out_of_range,
                  "pairs: row " + std::to_string(i / 2) + ": parts " + std::to_string(ids[i]) +
                      " and " + std::to_string(ids[i + 1]) + " of " +
                      std::to_string(a.parts.size()) + " and " + std::to_string(b.parts.size()),
                  "count parts from 0");
    }
    pairs.emplace_back(ids[i], ids[i + 1]);
    if (&a == &b && pairs.back().first > pairs.back().second) {
      std::swap(pairs.back().first, pairs.back().second);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

py::object query_clash(const py::object& a, const py::object& b, std::optional<double> within,
                       const py::object& pairs, std::optional<double> timeout, int threads,
                       const py::object& progress) {
  ClashOptions options{.within = within};
  check(options);
  if (b.is(a)) {
    throw usage("a, b: the same object", "leave b out to compare the parts of a with each other");
  }
  HeldClashes held;
  held.a = parts_argument(a, "a", threads);
  held.b = b.is_none() ? held.a : parts_argument(b, "b", threads);
  const bool one_set = b.is_none();
  std::vector<PartNumbers> wanted;
  if (!pairs.is_none()) {
    wanted = pairs_of(pairs, *held.a, *held.b);
    options.wanted = [&](std::uint32_t x, std::uint32_t y) {
      return std::binary_search(wanted.begin(), wanted.end(), PartNumbers(x, y));
    };
  }
  return made(run(Work::many, {threads, timeout}, progress, [&](const Limits& limits) {
    held.list = one_set ? clashes(held.a->parts, options, limits)
                        : clashes(held.a->parts, held.b->parts, options, limits);
    held.keys = keys_of(held);
    return std::move(held);
  }));
}

/// A whole body as one part, prepared.
ConvexPart convex_of(const PosedMesh& model, const char* what, const Limits& limits) {
  Mesh plain;
  plain.vertices = model.mesh->vertices;
  plain.triangles = model.mesh->triangles;
  const std::vector<PartBody> parts = part_bodies(plain, model.pose, limits);
  if (parts.empty() || !parts.front().closed) {
    throw Error(ErrorKind::not_closed, std::string(what) + ": is not closed",
                "give a closed body; Mesh.closedness says what is open");
  }
  std::optional<ConvexPart> convex = ConvexPart::of(parts.front());
  if (!convex) {
    throw usage(std::string(what) + ": is not convex", "give a convex body, or convex parts");
  }
  return *std::move(convex);
}

py::object query_penetration(const py::object& a, const py::object& b, int threads) {
  const std::vector<PosedMesh> first = posed_meshes_of(a, "a");
  const std::vector<PosedMesh> second = posed_meshes_of(b, "b");
  if (first.size() != 1 || second.size() != 1) {
    throw usage("a, b: a list of bodies", "give one body each");
  }
  std::optional<Penetration> found =
      run(Work::many, threads, py::none(), [&](const Limits& limits) {
        const ConvexPart fixed = convex_of(first.front(), "a", limits);
        return penetration(fixed, convex_of(second.front(), "b", limits));
      });
  return found ? made(*std::move(found)) : py::none();
}

double depth_of(const Clash& clash) {
  return clash.penetration ? clash.penetration->depth : std::numeric_limits<double>::quiet_NaN();
}

py::array directions_of(const std::vector<Clash>& clashes) {
  py::array_t<double> array({static_cast<py::ssize_t>(clashes.size()), py::ssize_t{3}});
  double* to = array.mutable_data();
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const Clash& clash : clashes) {
    const Vec3 d = clash.penetration ? clash.penetration->direction : Vec3{kNone, kNone, kNone};
    *to++ = d.x;
    *to++ = d.y;
    *to++ = d.z;
  }
  return array;
}

void bind_single_clash(py::module_& module) {
  AnswerClass<Penetration> penetration(module, "Penetration", "A shift that separates two bodies.");
  penetration.field("depth", &Penetration::depth, "Its length, in the unit of the bodies.")
      .field("direction", &Penetration::direction, "(3,), of length one: where the second goes.");
  AnswerClass<Clash> clash(module, "Clash", "Two parts that clash: a row of a ClashList.");
  clash.field("a", &Clash::a, "The number of the first part.")
      .field("b", &Clash::b, "The number of the second part.")
      .field("kind", &Clash::kind, "ClashKind.")
      .field("relation", &Clash::relation, "Relation, as solid says; of near ones, clear.")
      .field("why", &Clash::why, "Undecided: why the kind is.")
      .field("triangle_pairs", &Clash::triangle_pairs, "Pairs of triangles that overlap.")
      .derived(
          "gap", [](const Clash& c) { return py::make_tuple(c.gap.lower, c.gap.upper); },
          "(lower, upper) of the least distance of the surfaces; 0, 0 where they meet.")
      .field("place", &Clash::place, "(3,): a point of the clash, in world.")
      .derived(
          "box", [](const Clash& c) { return py::object(array_of(c.box)); },
          "(2, 3): holds all that the surfaces share, or else the inner part or the gap.")
      .derived(
          "penetration",
          [](const Clash& c) { return c.penetration ? py::cast(*c.penetration) : py::none(); },
          "Penetration of convex parts that share interior, else None.");
}

template <class Value>
Getter clash_column(Value Clash::*place) {
  return [place](const py::object& self) {
    return field_column(self.cast<const HeldClashes&>().list.clashes, place, self);
  };
}

void bind_clash_columns(AnswerClass<HeldClashes>& list) {
  def_property(list, "a", clash_column(&Clash::a), "(n,) uint32: parts of a.");
  def_property(list, "b", clash_column(&Clash::b), "(n,) uint32: parts of b; of one set, greater.");
  def_property(list, "kind", clash_column(&Clash::kind), "(n,) integers of ClashKind.");
  def_property(list, "relation", clash_column(&Clash::relation), "(n,) integers of Relation.");
  def_property(list, "why", clash_column(&Clash::why), "(n,) integers of Undecided.");
  def_property(list, "triangle_pairs", clash_column(&Clash::triangle_pairs),
               "(n,) uint64: pairs of triangles that overlap.");
  def_property(list, "gap", clash_column(&Clash::gap),
               "(n,) with fields lower, upper of the least distance of the surfaces.");
  def_property(list, "place", clash_column(&Clash::place), "(n, 3): a point of each clash.");
  def_property(list, "box", clash_column(&Clash::box),
               "(n, 2, 3): holds all that the surfaces share, or else the inner part or the gap.");
  list.column("key", &HeldClashes::keys,
              "(n,) uint64: names of the clashes that survive renumbering of parts and triangles; "
              "those of soms clash.");
  list.derived(
          "depth",
          [](const HeldClashes& h) { return computed_column<double>(h.list.clashes, &depth_of); },
          "(n,): how far convex parts that share interior go into each other, else NaN.")
      .derived(
          "direction", [](const HeldClashes& h) { return directions_of(h.list.clashes); },
          "(n, 3), of length one: where b goes by depth, else NaN.");
}

Clash clash_at(const HeldClashes& held, py::ssize_t row) {
  const auto count = static_cast<py::ssize_t>(held.list.clashes.size());
  const py::ssize_t place = row < 0 ? row + count : row;
  if (place < 0 || place >= count) {
    throw py::index_error("clash " + std::to_string(row) + " of " + std::to_string(count));
  }
  return held.list.clashes[static_cast<std::size_t>(place)];
}

void bind_clash_list(py::module_& module) {
  AnswerClass<HeldClashes> list(
      module, "ClashList",
      "Answer of clash: rows by the parts of a, then of b. Each column is an array; [i] is row i.");
  bind_clash_columns(list);
  list.derived(
          "parts",
          [](const HeldClashes& h) { return py::make_tuple(py::cast(h.a), py::cast(h.b)); },
          "(PartBodies, PartBodies) that a and b number; twice the same one without b.")
      .derived(
          "compared", [](const HeldClashes& h) { return h.list.compared; },
          "Pairs of parts that were decided: those whose boxes meet or are near.")
      .derived(
          "left_out", [](const HeldClashes& h) { return h.list.left_out; },
          "Pairs of parts that were not, as time ended.")
      .derived(
          "coverage", [](const HeldClashes& h) { return member(h.list.coverage); }, "Coverage.")
      .derived(
          "cost", [](const HeldClashes& h) { return h.list.cost; }, "Cost.");
  list.def(py::pickle(&clashes_state, &clashes_from));
  list.def("__len__", [](const HeldClashes& h) { return h.list.clashes.size(); });
  list.def("__getitem__", &clash_at, py::arg("row"), "The Clash of a row.");
  list.def(
      "__iter__",
      [](const py::object& self) {
        return py::reinterpret_steal<py::object>(PySeqIter_New(self.ptr()));
      },
      "Each row as a Clash.");
  list.def(
      "columns",
      [](const py::object& self) {
        return py::module_::import("soms._table").attr("clash_columns")(self);
      },
      "columns() -> dict[str, numpy.ndarray]\n\nA table: arrays (n,) by name, with the names of "
      "parts, the words of classes, and a column for each\ncoordinate, as pandas.DataFrame takes "
      "them.");
  list.def(
      "_repr_html_",
      [](const py::object& self) {
        return py::module_::import("soms._table").attr("clash_html")(self);
      },
      "_repr_html_() -> str\n\nThe first rows as a table, as a notebook shows it.");
}

}  // namespace

void bind_clash(py::module_& module) {
  bind_single_clash(module);
  bind_clash_list(module);
  def_function(
      module, "clash", &query_clash, kClashDoc,
      with_limits(
          {{"a"}, {"b", py::none()}, {"within", py::none(), true}, {"pairs", py::none(), true}}));
  def_function(module, "penetration", &query_penetration, kPenetrationDoc,
               {{"a"}, {"b"}, {"threads", py::int_(1), true}});
}

}  // namespace soms::python
