#include "soms/base/lanes_hash.h"
#include "soms/generate/city.h"
#include "soms/generate/routes.h"
#include "soms/generate/shapes.h"
#include "soms/generate/spread.h"
#include "soms/generate/statue.h"
#include "soms/generate/teapot.h"
#include "soms/geometry/common_points.h"
#include "soms/geometry/defects.h"
#include "soms/geometry/orientation.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/io/formats.h"
#include "soms/io/poses.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"
#include "soms/query/reference/overlap.h"
#include "soms/scene/scene.h"
#include "soms/thesis/overlap.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/build.h"
#include "soms/tree/check.h"
#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/layout/detail/compact_node.h"
#include "soms/tree/refit.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/statistics.h"
#include "soms/tree/visits.h"

#include "tests/golden/golden.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace soms::golden {

namespace {

std::string text_of(const Mesh& mesh, MeshFormat format) {
  std::ostringstream out;
  write_mesh(out, "out", mesh, format);
  return out.str();
}

Mesh mesh_of(const std::string& bytes) {
  return read_mesh(std::as_bytes(std::span(bytes)), "in");
}

/// Options of a rule: the product's and the thesis'.
std::array<BuildOptions, 2> options_of(Rule rule) {
  return {BuildOptions{.rule = rule}, thesis_options(rule, 9)};
}

}  // namespace

void add_geometry(const Inputs& inputs, Rows& rows) {
  Hash signs;
  for (std::size_t i = 0; i + 4 <= inputs.points.size(); i += 4) {
    const Vec3* p = &inputs.points[i];
    signs << orientation(p[0], p[1], p[2], p[3]) << orientation2d(p[0], p[1], p[2], Projection::xy);
  }
  rows["orientation"] = signs.value();
  Hash touching;
  Hash crossings;
  std::uint64_t exact = 0;
  for (std::size_t i = 0; i + 2 <= inputs.triangles.size(); i += 2) {
    touching << triangles_overlap(inputs.triangles[i], inputs.triangles[i + 1], &exact);
    crossings << common_points(inputs.triangles[i], inputs.triangles[i + 1]).points();
  }
  rows["triangles_overlap"] = (touching << exact).value();
  rows["crossing"] = crossings.value();
  for (const auto& [name, mesh] : inputs.models) {
    const Defects found = find_defects(mesh);
    rows["defects " + name] = (Hash() << found.open_edges << found.non_manifold_edges
                                      << found.flipped_edges << bounds(mesh))
                                  .value();
    rows["transformed " + name] = (Hash() << transformed(mesh, 0.1, UpAxis::y)).value();
  }
}

bool reads_collada() {
  const auto formats = readable_formats();
  return std::any_of(formats.begin(), formats.end(),
                     [](const ReadableFormat& format) { return format.extension == ".dae"; });
}

void add_files(const Inputs& inputs, Rows& rows) {
  for (const char* name :
       {"ascii.ply", "ascii_exponents.ply", "be_double.ply", "polygons.obj", "polygons.off",
        "ascii.stl", "binary.stl", "full.3ds", "interleaved.glb", "strips.glb", "nodes_trs.gltf",
        "nodes_matrix.gltf", "mirrored_node.gltf", "sparse.gltf", "z_up_trs.dae", "z_up_matrix.dae",
        "z_up_polylist.dae"}) {
    if (std::string_view(name).ends_with(".dae") && !reads_collada()) {
      continue;
    }
    rows[std::string("read ") + name] =
        (Hash() << read_mesh(inputs.data / "formats" / name)).value();
  }
  const std::array<std::pair<const char*, MeshFormat>, 8> formats{
      {{"ply", MeshFormat::ply},
       {"ply_ascii", MeshFormat::ply_ascii},
       {"obj", MeshFormat::obj},
       {"stl", MeshFormat::stl},
       {"stl_ascii", MeshFormat::stl_ascii},
       {"off", MeshFormat::off},
       {"3ds", MeshFormat::three_ds},
       {"glb", MeshFormat::glb}}};
  for (const auto& [name, format] : formats) {
    const std::string bytes = text_of(inputs.models.at("slivers"), format);
    rows[std::string("write ") + name] = (Hash() << bytes).value();
    rows[std::string("read again ") + name] = (Hash() << mesh_of(bytes)).value();
  }
  rows["read again subnormal"] =
      (Hash() << mesh_of(text_of(inputs.models.at("subnormal"), MeshFormat::obj))).value();
  rows["poses"] = (Hash() << parse_pose("0.1 1e-310 -2.5e17") << parse_pose("1 2 3 0.8 0.36 0.48 0")
                          << parse_pose("4.9e-324 2.2250738585072011e-308 0.30000000000000004"))
                      .value();
}

void add_trees(const Inputs& inputs, const Limits& limits, Rows& rows) {
  for (const auto& [name, model] : inputs.models) {
    const auto mesh = std::make_shared<const Mesh>(model);
    for (const RuleEntry& rule : rules()) {
      Hash hash;
      for (const BuildOptions& options : options_of(rule.rule)) {
        const Tree tree = build(*mesh, options, limits);
        const ExpectedVisits visits = expected_visits(tree, {0.5, 0.25, 0});
        hash << tree_hash(tree) << sah_cost(tree) << visits.nodes << visits.triangles
             << find_fault(tree, *mesh) << count_visits(tree, tree.nodes[0].bounds).leaves
             << statistics(tree, options).depth;
        const WideTree wide(tree, *mesh, limits);
        hash << wide << wide.compacted(limits) << wide.sah_area_ratio(*mesh, limits)
             << build_wide(*mesh, options, limits);
      }
      rows["tree " + name + " " + std::string(rule.name)] = hash.value();
    }
    Mesh unnamed = model;  // a path is of one machine
    unnamed.source.clear();
    Hash files;
    for (const Layout layout : {Layout::wide, Layout::compact}) {
      write_tree_file(Shape(unnamed, {.layout = layout}, limits),
                      [&](std::span<const std::byte> bytes) { files << lanes_hash(bytes); });
    }
    rows["tree file " + name] = files.value();
  }
  const Shape ring(inputs.models.at("ring"), {.keep_tree = true}, limits);
  const Shape bent = refit(ring, inputs.bent.vertices, limits);
  rows["refit"] =
      (Hash() << tree_hash(*bent.tree()) << bent.layout() << bent.sah_degradation()).value();
}

namespace {

/// As a batch has them: where the pairs of each pose begin and end, all pairs, all costs.
std::uint64_t hash_of(const std::vector<thesis::CountedOverlap>& answers) {
  std::vector<std::uint64_t> offsets{0};
  Hash hash;
  for (const auto& [answer, counts] : answers) {
    offsets.push_back(offsets.back() + answer.pairs.size());
  }
  hash << offsets;
  for (const auto& [answer, counts] : answers) {
    hash << answer.pairs;
  }
  for (const auto& [answer, counts] : answers) {
    hash << answer.cost;
  }
  return hash.value();
}

/// What each way of asking about a pair says, all poses together.
void add_pair(const ModelPair& pair, const Inputs& inputs, const Limits& limits, Rows& rows) {
  const Mesh& mesh_a = inputs.models.at(pair.first);
  const Mesh& mesh_b = inputs.models.at(pair.second);
  const std::string name = pair.name();
  const Shape a(mesh_a, {.keep_tree = true}, limits);
  const Shape b(mesh_b, {.build = {.rule = Rule::soms}, .keep_tree = true}, limits);
  const Shape compact(mesh_b, {.layout = Layout::compact}, limits);
  Hash all;
  Hash costs;
  Hash first;
  Hash small;
  Hash brute;
  for (const Pose& pose : inputs.poses) {
    const Body x(a, pose);
    const Overlap answer = overlap(x, Body(b), {}, limits);
    all << answer;
    costs << answer.cost;
    first << overlap(x, Body(b), {.mode = OverlapMode::first}, limits).pairs.size()
          << overlap(x, Body(b), {.mode = OverlapMode::any}, limits).any
          << overlap(x, Body(b), {.limit = 3}, limits).pairs;
    const Overlap of_compact = overlap(x, Body(compact), {}, limits);
    small << of_compact;
    costs << of_compact.cost;
    brute << reference::overlap(mesh_a, pose, mesh_b, Pose(), limits).pairs;
  }
  rows["overlap " + name] = all.value();
  rows["overlap first " + name] = first.value();
  rows["overlap compact " + name] = small.value();
  rows["overlap brute " + name] = brute.value();
  const OverlapBatch batch = overlap(a, inputs.poses, Body(b), {}, limits);
  rows["overlap batch " + name] = (Hash() << batch.any << batch.offsets << batch.pairs).value();
  // Work has a row of its own: a better engine may change it and must not change an answer.
  rows["overlap cost " + name] = (costs << batch.costs).value();
  for (const TraversalEntry& traversal : traversals()) {
    if (traversal.traversal != Traversal::fast) {
      const std::vector<thesis::CountedOverlap> named =
          thesis::overlap(a, std::span(inputs.poses).last(2), Body(b),
                          {.traversal = traversal.traversal}, {}, limits);
      rows[std::string(traversal.name) + " " + name] = hash_of(named);
    }
  }
}

}  // namespace

void add_answers(const Inputs& inputs, const Limits& limits, Rows& rows) {
  for (const ModelPair& pair : inputs.pairs) {
    add_pair(pair, inputs, limits, rows);
  }
}

void add_scene(const Limits& limits, Rows& rows) {
  City city = generate_city({.triangles = 6000, .size = 400, .seed = 3});
  rows["city"] = (Hash() << city.mesh).value();
  for (const auto& [name, mesh] :
       {std::pair("knot", generate_knot(500)), std::pair("sphere", generate_sphere(300)),
        std::pair("teapot", generate_teapot(2)), std::pair("statue", generate_statue(700)),
        std::pair("spread", generate_spread({.triangles = 300, .ratio = 1e4}))}) {
    rows[std::string("generate ") + name] = (Hash() << mesh).value();
  }
  const std::array<Shape, 3> shapes{Shape(generate_mover(MoverKind::car), {}, limits),
                                    Shape(generate_mover(MoverKind::person), {}, limits),
                                    Shape(generate_mover(MoverKind::drone), {}, limits)};
  Scene scene;
  const Box box = bounds(city.mesh);
  std::vector<Route> routes;
  for (std::uint64_t i = 0; i < 30; ++i) {
    routes.push_back(i % 3 == 2   ? flight_route(city, i, 10, 5, 40)
                     : i % 5 == 4 ? straight_route(box, {150, 150, 1}, i, 12)
                                  : street_route(city, i, i % 3 == 1 ? 1.4 : 13.9, 0.5));
    routes.back().base = i % 3 == 0 ? 2.6 : 0;
    routes.back().measure();
    scene.add_mover(Body(shapes[i % 3], routes.back().at(0)));
  }
  scene.add_environment(Body(Shape(std::move(city.mesh), {}, limits)));
  Hash poses;
  Hash steps;
  Hash costs;
  for (int frame = 0; frame < 25; ++frame) {
    for (std::size_t i = 0; i < routes.size(); ++i) {
      const Pose pose = routes[i].at(0.25 * frame);
      poses << pose << routes[i].length() << city.ground(pose.m[3], pose.m[7]);
      scene.set_pose(static_cast<MoverId>(i), pose);
    }
    const StepReport report = scene.step({}, limits);
    steps << report.hash() << report.queries << report.box_pairs;
    costs << report.cost;
  }
  rows["routes"] = poses.value();
  rows["simulate"] = steps.value();
  rows["simulate cost"] = costs.value();
}

Rows all_rows(const Inputs& inputs, int threads) {
  const Limits limits{.threads = threads};
  Rows rows;
  add_geometry(inputs, rows);
  add_files(inputs, rows);
  add_trees(inputs, limits, rows);
  add_answers(inputs, limits, rows);
  add_near_answers(inputs, limits, rows);
  add_solid_answers(inputs, limits, rows);
  add_probe_answers(inputs, limits, rows);
  add_scene(limits, rows);
  return rows;
}

}  // namespace soms::golden
