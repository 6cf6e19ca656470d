// Tree files whose records and head were changed, with hashes that go with the change: a typed
// error, or queries that end and touch no other memory. What passes the full check answers as the
// same mesh built from its arrays.
#include "soms/base/error.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/within.h"
#include "soms/tree/file/shape_bytes.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"
#include "tests/store/forged_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using detail::Section;
using fuzz::require;

const Shape& base(std::size_t which) {
  static const Mesh kCity = generate_city({.triangles = 1000, .size = 400}).mesh;
  static const std::array<Shape, 4> kShapes = {
      Shape(kCity), Shape(kCity, {.layout = Layout::compact}),
      Shape(generate_sphere(80), {.build = {.level = 3}}),
      Shape(generate_mover(MoverKind::drone), {.layout = Layout::compact})};
  return kShapes[which % kShapes.size()];
}

const Shape& mover() {
  static const Shape kCar(generate_mover(MoverKind::car));
  return kCar;
}

/// One of each question.
struct Answers {
  Overlap overlap;
  Distance distance;
  Closest closest;
  ClosestHit hit;
  bool near = false;
};

Answers ask(const Shape& shape) {
  const Body body(shape);
  const Body car(mover(), Pose::about_z(0.3, {20, 30, 1}));
  return {overlap(car, body), distance(car, body), closest(body, Vec3{1, 2, 3}),
          closest_hit(body, Ray{{0, 0, 90}, {0.1, 0.2, -1}}), within(car, body, 2).within};
}

/// Changes the head or a record by the next bytes.
void change(test::ForgedFile& file, fuzz::Bytes& bytes) {
  const auto which = bytes.byte();
  if (which % 16 >= detail::kSections) {
    const auto section = static_cast<Section>(which % detail::kSections);
    detail::SectionPlace& place = file.head().of(section);
    (which % 2 == 0 ? place.count : place.offset) = static_cast<std::uint32_t>(bytes.eight());
    return;
  }
  const auto section = static_cast<Section>(which % 16);
  const std::size_t words =
      file.count(section) * detail::record_size(section) / sizeof(std::uint32_t);
  const auto at = static_cast<std::size_t>(bytes.eight() % 65536);
  const auto word = static_cast<std::uint32_t>(bytes.eight());
  if (words > 0) {
    const std::size_t place = at % words;
    // Small numbers are indices, and small changes of them more often pass.
    const auto old = file.record<std::uint32_t>(section, place);
    file.set_record(section, place, which >= 128 ? word : old ^ (1U << word % 32));
  }
}

void run(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes({data, size});
  const auto first = bytes.byte();
  test::ForgedFile file(base(first));
  do {
    change(file, bytes);
  } while (!bytes.spent());
  const std::vector<std::byte> forged = file.bytes();
  for (const TreeCheck check : {TreeCheck::safe, TreeCheck::sound, TreeCheck::full}) {
    try {
      const Shape opened = open_shape(forged, "forged", {.check = check});
      const Answers found = ask(opened);
      if (check == TreeCheck::full) {
        const Answers built = ask(Shape(opened.shared_mesh()));
        require(found.overlap.pairs == built.overlap.pairs, "the same pairs");
        require(found.distance.distance == built.distance.distance, "the same distance");
        require(found.closest.triangle == built.closest.triangle, "the same nearest triangle");
        require(found.hit.triangle == built.hit.triangle, "the same hit");
        require(found.near == built.near, "as near");
      }
    } catch (const Error&) {
      continue;
    }
  }
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::run(data, size);
  return 0;
}
