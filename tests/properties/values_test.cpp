// Every value of the library is copied, compared and printed alike, whichever room it is of.
#include "soms/base/print_fields.h"
#include "soms/query/overlap.h"
#include "soms/soms.h"
#include "soms/thesis/overlap.h"
#include "soms/thesis/print.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <concepts>
#include <ostream>
#include <string>

namespace soms {
namespace {

template <class T>
concept Value = std::copyable<T> && std::equality_comparable<T> &&
    requires(std::ostream& out, const T& value) {
  { out << value } -> std::same_as<std::ostream&>;
};

template <class... T>
constexpr bool kValues = (Value<T> && ...);

static_assert(kValues<Vec3, Triangle, Box, Pose, Rotation, ErrorKind>);
static_assert(kValues<Clash, ClashKind, ClashList, OpenUnion, PartBody>);
static_assert(
    kValues<Mesh, Attribute, Part, PartRun, UpAxis, Defects, DefectPlaces, DefectOptions,
            EdgeCounts, EdgePlace, TriangleCopy, VertexCopy, CommonPoints, Sign, Projection,
            Midpoint, CoordinateFrame, FrameDoubt, Closedness, PartClosedness, ClosednessOptions>);
static_assert(kValues<Tree, Node, TreeStatistics, Visits, ExpectedVisits, BuildOptions, Rule,
                      AxisFrom, EmptySide, Shape, ShapeOptions, Layout>);
static_assert(kValues<ClosedBody, Contains, ContainsBatch, Side>);
static_assert(kValues<WindingIndex, Winding, WindingBatch, WindingOptions, DividedBody, Partition,
                      DividedPart, PartSide, ContainsParts, ContainsPartsBatch>);
static_assert(kValues<Solid, SolidBatch, Relation, Undecided>);
static_assert(kValues<Body, Cost, Coverage, Overlap, OverlapBatch, OverlapOptions, OverlapMode,
                      TraversalOptions, TraversalCounts, NodePair, Traversal, Descent, EntryOrder,
                      BoxUpdate, thesis::CountedOverlap>);
static_assert(kValues<FirstContact, FirstContactOptions, ContactVerdict, RigidMotion>);
static_assert(kValues<Ray, RayOptions, ClosestHit, ClosestHitBatch, AnyHit, AnyHitBatch, AllHits,
                      CrossingKind>);
static_assert(kValues<ContactChange, ContactEvents, EnvironmentEvent, MoverEvent, ContactSide,
                      ContactSpan, StepScope>);
static_assert(kValues<BodyClosest, BodyClosestBatch, BodyHit, BodyHitBatch, BodyAllHits,
                      SceneAllHits, BodyFilter, SceneBody, SceneBodyKind, SceneClosest,
                      SceneClosestBatch, SceneHit, SceneHitBatch, SceneFilter>);
static_assert(kValues<Clearance, ClearanceOptions, ClearanceStation, ClearanceStretch,
                      ClearanceVerdict, PathContact, MotionPath>);
static_assert(kValues<EnvironmentContact, MoverContact, EnvironmentGap, MoverGap, StepReport,
                      EnvironmentPassage, MoverPassage, StepOptions, RecordedMesh, RecordedBody,
                      RecordingHead, RecordedFrame, RecordingEnding, RecordingEnd>);
static_assert(kValues<Column, ReadOptions, ReadableFormat, WritableFormat, MeshFormat, Rounding>);
static_assert(kValues<City, CityOptions, Route, SpreadOptions, MoverKind, UrbanScene>);
// An exception is copied by its constructor alone where it is thrown.
static_assert(std::copy_constructible<Error> && std::equality_comparable<Error>);

/// Two triangles of a square, and one above it.
Mesh small_mesh() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}};
  mesh.parts = {{.name = "square", .first = 0, .count = 2},
                {.name = "fin", .first = 2, .count = 1}};
  return mesh;
}

TEST(Values, PrintWhatIsInside) {
  const Closedness open = closedness(small_mesh(), {.parts = true});
  EXPECT_EQ(printed(open),
            "Closedness{whole: PartClosedness{closed: false, first: 0, triangles: 3, degenerate: "
            "0, odd_edges: 7, odd_proper_edges: 7}, places: 7, connected: 0, parts: 2}");
  EXPECT_EQ(printed(ClosednessOptions{}).substr(0, 24), "ClosednessOptions{pose: ");
  EXPECT_EQ(printed(Side::inside) + printed(Side::on) + printed(Side::undecided),
            "insideonundecided");
  const ClosedBody nothing{Body{}};
  EXPECT_EQ(printed(nothing).substr(0, 16), "ClosedBody{Body{");
  EXPECT_EQ(printed(contains(nothing, Vec3{})),
            "Contains{side: outside, coverage: complete, cost: " + printed(Cost{}) + "}");
  EXPECT_EQ(printed(solid(nothing, nothing)),
            "Solid{relation: clear, surfaces_meet: false, why: none, coverage: complete, cost: " +
                printed(Cost{}) + "}");
  EXPECT_EQ(printed(solid(nothing, std::vector<Pose>(2), nothing)),
            "SolidBatch{2 of 2 poses clear, cost: " + printed(Cost{}) + "}");
  EXPECT_EQ(printed(contains(nothing, std::vector<Vec3>(2))),
            "ContainsBatch{0 of 2 points inside, 0 on the surface, coverage: complete, cost: " +
                printed(Cost{}) + "}");
}

TEST(Values, PrintWindingNumbersAndParts) {
  const WindingIndex fins{Body(small_mesh())};
  EXPECT_EQ(printed(fins).substr(0, 18), "WindingIndex{Body{");
  EXPECT_EQ(printed(fins).substr(printed(fins).size() - 19), ", 7 boundary edges}");
  EXPECT_EQ(printed(WindingOptions{}), "WindingOptions{width: 1e-09}");
  const WindingIndex nothing{Body{}};
  EXPECT_EQ(
      printed(winding(nothing, Vec3{})),
      "Winding{side: outside, number: Bracket{lower: 0, upper: 0}, coverage: complete, cost: " +
          printed(Cost{}) + "}");
  EXPECT_EQ(printed(winding(nothing, std::vector<Vec3>(2))),
            "WindingBatch{0 of 2 points inside, 0 undecided, coverage: complete, cost: " +
                printed(Cost{}) + "}");
  const DividedBody parts{Body(small_mesh())};
  EXPECT_EQ(printed(parts).substr(printed(parts).size() - 18), ", 2 parts, 2 open}");
  EXPECT_EQ(printed(Partition::connected), "connected");
  EXPECT_EQ(printed(parts.parts()[1]),
            "DividedPart{named: 1, first: 2, triangles: 1, closed: false, odd_edges: 3}");
  EXPECT_EQ(printed(contains(parts, Vec3{0.5, 0.5, 0})).substr(0, 42),
            "ContainsParts{2 parts, coverage: complete,");
  EXPECT_EQ(printed(contains(parts, std::vector<Vec3>(3))).substr(0, 28),
            "ContainsPartsBatch{3 points,");
}

TEST(Values, PrintRaysAndWhatTheyHit) {
  const Body body(small_mesh());
  const std::vector<Ray> rays{{{0.75, 0.25, 2}, {0, 0, -1}}, {{9, 9, 9}, {0, 0, 1}, 4}};
  EXPECT_EQ(printed(rays[1]), "Ray{origin: Vec3{9, 9, 9}, direction: Vec3{0, 0, 1}, length: 4}");
  EXPECT_EQ(printed(Ray::between({0, 0, 0}, {1, 2, 3})),
            "Ray{origin: Vec3{0, 0, 0}, end: Vec3{1, 2, 3}}");
  EXPECT_EQ(printed(RayOptions{.skip = 3}), "RayOptions{skip: 3}");
  EXPECT_EQ(printed(closest_hit(body, rays[0])).substr(0, 33), "ClosestHit{t: Bracket{lower: 2, u");
  EXPECT_EQ(printed(closest_hit(body, rays)).substr(0, 35), "ClosestHitBatch{1 of 2 rays hit, co");
  EXPECT_EQ(printed(any_hit(body, rays[0])).substr(0, 16), "AnyHit{hit: true");
  EXPECT_EQ(printed(any_hit(body, rays)).substr(0, 27), "AnyHitBatch{1 of 2 rays hit");
  EXPECT_EQ(printed(all_hits(body, rays)).substr(0, 28), "AllHits{1 crossing of 2 rays");
  EXPECT_EQ(
      printed(CrossingKind::enter) + printed(CrossingKind::leave) + printed(CrossingKind::graze),
      "enterleavegraze");
}

TEST(Values, PrintMeshesAndWhatIsFoundInThem) {
  const Mesh mesh = small_mesh();
  EXPECT_EQ(printed(mesh), "Mesh{3 triangles, 6 vertices, 2 parts}");
  EXPECT_EQ(printed(Mesh{}), "Mesh{0 triangles, 0 vertices, 0 parts}");
  EXPECT_EQ(printed(mesh.parts[1]), R"(Part{"fin", 1 triangle from 2})");
  EXPECT_EQ(printed(Part{.name = "a", .parent = 3, .first = 0, .count = 2}),
            R"(Part{"a", 2 triangles from 0, parent: 3})");
  EXPECT_EQ(printed(PartRun{.first = 2, .part = 1}), "PartRun{first: 2, part: 1}");
  EXPECT_EQ(printed(PartRun{}), "PartRun{first: 0, no part}");
  EXPECT_EQ(printed(UpAxis::y), "y");
  const Defects defects = find_defects(mesh);
  EXPECT_EQ(printed(defects).rfind("Defects{degenerate: 0, repeated_corner: 0, duplicate: 0, ", 0),
            0U);
  EXPECT_NE(printed(defects).find("open_edges: 7, "), std::string::npos) << defects;
  EXPECT_EQ(printed(defects.places.open_edges.at(0)),
            "EdgePlace{triangle: 0, corner: 0, other: 0, uses: 1}");
  EXPECT_EQ(printed(EdgeCounts{}), "EdgeCounts{open: 0, non_manifold: 0, flipped: 0, none: false}");
  EXPECT_EQ(printed(TriangleCopy{7, 2}), "TriangleCopy{triangle: 7, original: 2}");
  EXPECT_EQ(printed(VertexCopy{7, 2}), "VertexCopy{vertex: 7, original: 2}");
  EXPECT_EQ(printed(DefectOptions{}), "DefectOptions{places: 10, parts: true}");
  EXPECT_EQ(printed(Sign::negative), "negative");
  EXPECT_EQ(printed(Projection::zx), "zx");
}

TEST(Values, PrintAndCompareCrossings) {
  const Triangle flat{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const Triangle upright{{0.5, 0.5, -1}, {0.5, 0.5, 1}, {0.25, 0.5, 0}};
  const CommonPoints found = common_points(flat, upright);
  EXPECT_EQ(found, common_points(flat, upright));
  EXPECT_EQ(printed(found).rfind("CommonPoints{Vec3{", 0), 0U) << found;
  EXPECT_EQ(printed(CommonPoints{}), "CommonPoints{empty}");
  EXPECT_FALSE(found == CommonPoints{});
  CommonPoints shorter = found;
  --shorter.count;
  EXPECT_FALSE(found == shorter);
  // What stands beyond the count is no part of the value.
  CommonPoints other = found;
  other.corners[5] = {9, 9, 9};
  EXPECT_EQ(found, other);
}

TEST(Values, PrintTreesShapesAndTheirOptions) {
  const Mesh mesh = small_mesh();
  const BuildOptions options{.rule = Rule::soms, .axis_from = AxisFrom::outer, .per_leaf = 1};
  const Tree tree = build(mesh, options);
  EXPECT_EQ(printed(tree), "Tree{5 nodes, 3 triangles}");
  EXPECT_EQ(printed(tree.nodes[0]),
            "Node{id: 0, depth: 0, first: 0, count: 3, left: 1, right: " +
                std::to_string(tree.nodes[0].right) +
                ", undividable: true, bounds: Box{(0, 0, -1) to (1, 1, 1)}}");
  EXPECT_EQ(printed(options),
            "BuildOptions{rule: soms, midpoint: aabb, c_vertex: 2, axis_from: outer, empty_side: "
            "object_median, level: 0, root_level: 1, per_leaf: 1}");
  EXPECT_EQ(printed(statistics(tree, options)),
            "TreeStatistics{nodes: 5, leaves: 3, one: 3, lt5: 3, undividable: 2, capped: 0, empty: "
            "0, depth: 2, min_leaf_depth: 1, max_leaf_depth: 2, largest_leaf: 1, balanced_level: "
            "2}");
  EXPECT_EQ(printed(Visits{3, 2, 1}), "Visits{nodes: 3, leaves: 2, triangles: 1}");
  EXPECT_EQ(printed(ExpectedVisits{0.5, 2, 1}),
            "ExpectedVisits{nodes: 0.5, leaves: 2, triangles: 1}");
  EXPECT_EQ(printed(Shape(mesh)),
            "Shape{Mesh{3 triangles, 6 vertices, 2 parts}, layout: wide, keep_tree: false, "
            "sah_degradation: 1}");
  EXPECT_EQ(printed(Layout::compact), "compact");
}

TEST(Values, CompareShapesByWhatTheyHold) {
  const Mesh mesh = small_mesh();
  const Shape shape(mesh);
  EXPECT_EQ(shape, Shape(shape));
  EXPECT_EQ(shape, Shape(mesh));  // built again
  EXPECT_EQ(Shape{}, Shape{});
  EXPECT_FALSE(shape == Shape{});
  EXPECT_FALSE(shape == Shape(mesh, {.keep_tree = true}));
  EXPECT_FALSE(shape == Shape(mesh, {.layout = Layout::compact}));
  EXPECT_FALSE(shape == Shape(mesh, {.build = {.rule = Rule::sah}}));
  Mesh moved = mesh;
  moved.vertices[5].z = 2;
  EXPECT_FALSE(shape == Shape(moved));
  EXPECT_FALSE(shape == refit(shape, moved.vertices));
}

TEST(Values, PrintAndCompareBodiesAndAnswers) {
  const Body body(Shape(small_mesh()), Pose::translation(1, 2, 3), "plate \"A\"");
  EXPECT_EQ(printed(body),
            "Body{\"plate \\\"A\\\"\", Shape{Mesh{3 triangles, 6 vertices, 2 parts}, layout: wide, "
            "keep_tree: false, sah_degradation: 1}, Pose{1 0 0 1, 0 1 0 2, 0 0 1 3}}");
  Body other = body;
  EXPECT_EQ(body, other);
  other.pose = {};
  EXPECT_FALSE(body == other);
  const Overlap answer = overlap(body, body);
  EXPECT_EQ(printed(answer), "Overlap{any: true, " + std::to_string(answer.pairs.size()) +
                                 " pairs, coverage: complete, cost: " + printed(answer.cost) + "}");
  EXPECT_EQ(answer, overlap(body, body));
  EXPECT_FALSE(answer == Overlap{});
  EXPECT_EQ(printed(Cost{1, 2, 3}), "Cost{node_tests: 1, triangle_tests: 2, exact_tests: 3}");
  const std::array<Pose, 2> poses{Pose{}, Pose::translation(1, 2, 3)};
  const OverlapBatch batch = overlap(body.shape, poses, body);
  EXPECT_EQ(printed(batch).rfind("OverlapBatch{1 of 2 poses with an overlap, ", 0), 0U) << batch;
  EXPECT_EQ(batch, overlap(body.shape, poses, body));
  EXPECT_FALSE(batch == OverlapBatch{});
  EXPECT_EQ(printed(TraversalCounts{.box_tests = 3, .leaf_pairs = 1}),
            "TraversalCounts{box_tests: 3, entered: 0, leaf_pairs: 1, triangle_pairs: 0, "
            "first_tests: 0, max_stack: 0}");
  const thesis::CountedOverlap counted{answer, {.entered = 2}};
  EXPECT_EQ(printed(counted), "CountedOverlap{answer: " + printed(answer) +
                                  ", counts: " + printed(counted.counts) + "}");
  EXPECT_FALSE(counted == thesis::CountedOverlap{});
  EXPECT_EQ(printed(NodePair{1, 2}), "NodePair{a: 1, b: 2}");
}

TEST(Values, PrintAndCompareAnswersAboutPoints) {
  const Body body{Shape(small_mesh())};
  const Closest answer = closest(body, {0, 0, 0});
  EXPECT_EQ(printed(answer).rfind(
                "Closest{distance: Bracket{lower: 0, upper: 0}, farther: false, triangle: ", 0),
            0U)
      << answer;
  EXPECT_EQ(answer, Closest(answer));
  EXPECT_FALSE(answer == Closest{});
  const std::array<Vec3, 2> points{Vec3{}, Vec3{1, 2, 3}};
  const ClosestBatch batch = closest(body, points);
  EXPECT_EQ(printed(batch), "ClosestBatch{2 points, cost: " + printed(batch.cost) + "}");
  EXPECT_FALSE(batch == ClosestBatch{});
  const NearTriangles near = nearest_triangles(body, points, 2);
  EXPECT_EQ(printed(near),
            "NearTriangles{2 points, 4 triangles, cost: " + printed(near.cost) + "}");
  EXPECT_FALSE(near == NearTriangles{});
  EXPECT_EQ(printed(ClosestOptions{.at_most = 2}), "ClosestOptions{at_most: 2}");
  EXPECT_EQ(
      printed(PointDistance{{1, 1}, {0, 0, 1}, TriangleFeature::edge}),
      "PointDistance{distance: Bracket{lower: 1, upper: 1}, point: Vec3{0, 0, 1}, feature: edge}");
}

TEST(Values, PrintOptionsOfQueries) {
  EXPECT_EQ(printed(OverlapOptions{.mode = OverlapMode::first, .limit = 7}),
            "OverlapOptions{mode: first, limit: 7}");
  EXPECT_EQ(printed(TraversalOptions{}),
            "TraversalOptions{traversal: fast, descent: both, order: tree, ericson_rule: larger, "
            "recursive: false, prune: true, update: refit}");
  EXPECT_FALSE(OverlapOptions{} == OverlapOptions{.limit = 7});
  EXPECT_EQ(printed(Traversal::e_node_front), "e_node_front");
}

TEST(Values, PrintAndCompareAnswersAboutManyBodies) {
  Scene scene;
  const MoverId mover = scene.add_mover(Body(small_mesh()));
  const std::array<Vec3, 2> points{Vec3{}, Vec3{1, 2, 3}};
  const SceneClosest near = scene.closest(points[1]);
  EXPECT_EQ(printed(near), "SceneClosest{body: SceneBody{kind: mover, id: 0}, " +
                               printed(static_cast<const Closest&>(near)) + "}");
  EXPECT_FALSE(near == SceneClosest{});
  const SceneClosestBatch batch = scene.closest(points);
  EXPECT_EQ(printed(batch),
            "SceneClosestBatch{" + printed(static_cast<const ClosestBatch&>(batch)) + "}");
  EXPECT_FALSE(batch == SceneClosestBatch{});
  const SceneHit hit = scene.closest_hit(Ray{{0.5, 0.25, 9}, {0, 0, -1}});
  EXPECT_EQ(printed(hit), "SceneHit{body: SceneBody{kind: mover, id: 0}, " +
                              printed(static_cast<const ClosestHit&>(hit)) + "}");
  EXPECT_FALSE(hit == SceneHit{});
  EXPECT_EQ(printed(SceneFilter{.movers = false, .except = {{SceneBodyKind::mover, mover}}}),
            "SceneFilter{environment: true, movers: false, except: SceneBody{kind: mover, id: 0}}");
  EXPECT_LT((SceneBody{SceneBodyKind::environment, 7}), (SceneBody{SceneBodyKind::mover, 0}));

  const BodyIndex index(std::vector<Body>{Body(), Body(small_mesh())});
  EXPECT_EQ(printed(index.closest(points[0])).rfind("BodyClosest{body: 1, Closest{", 0), 0U);
  EXPECT_EQ(printed(index.closest(points)).rfind("BodyClosestBatch{ClosestBatch{", 0), 0U);
  EXPECT_EQ(printed(BodyHit{}).rfind("BodyHit{ClosestHit{", 0), 0U);
  EXPECT_EQ(printed(BodyHitBatch{}).rfind("BodyHitBatch{ClosestHitBatch{", 0), 0U);
  EXPECT_EQ(printed(SceneHitBatch{}).rfind("SceneHitBatch{ClosestHitBatch{", 0), 0U);
  EXPECT_EQ(printed(BodyAllHits{}).rfind("BodyAllHits{AllHits{0 crossings of 0 rays", 0), 0U);
  EXPECT_EQ(printed(SceneAllHits{}).rfind("SceneAllHits{AllHits{0 crossings of 0 rays", 0), 0U);
  EXPECT_EQ(printed(BodyFilter{.except = 3}), "BodyFilter{except: 3}");
}

// The names that `<<` has of enumerators are those of the tables.
TEST(Values, PrintEnumeratorsByTheirNames) {
  for (const auto& row : {name(EmptySide::chain), name(EmptySide::next_axis)}) {
    EXPECT_EQ(row, printed(empty_side_named(row)));
  }
  for (const auto kind : {MoverKind::car, MoverKind::person, MoverKind::drone}) {
    EXPECT_EQ(name(kind), printed(kind));
  }
  for (const RuleEntry& row : rules()) {
    EXPECT_EQ(row.name, printed(row.rule));
  }
  for (const TraversalEntry& row : traversals()) {
    EXPECT_EQ(row.name, printed(row.traversal));
  }
  for (const DescentEntry& row : descents()) {
    EXPECT_EQ(row.name, printed(row.descent));
  }
  EXPECT_EQ(printed(static_cast<Coverage>(9)), "Coverage(9)");
}

TEST(Values, PrintAndCompareWhatHappensInAScene) {
  Scene scene;
  scene.add_environment(Body(Shape(small_mesh())));
  scene.add_mover(Body(Shape(small_mesh())));
  const StepReport report = scene.step();
  EXPECT_EQ(
      printed(report).rfind("StepReport{environment: " + std::to_string(report.environment.size()) +
                                ", movers: 0, coverage: complete, cost: Cost{",
                            0),
      0U)
      << report;
  EXPECT_EQ(report, StepReport(report));
  EXPECT_FALSE(report == StepReport{});
  EXPECT_EQ(printed(report.environment.at(0)), "EnvironmentContact{mover: 0, part: 0, i: 0, j: 0}");
  EXPECT_EQ(printed(MoverContact{1, 2, 3, 4}), "MoverContact{a: 1, b: 2, i: 3, j: 4}");
  EXPECT_EQ(printed(MoverGap{1, 2, 3, 4, {0.5, 0.75}, {0, 0, 1}, {0, 0, 2}}),
            "MoverGap{a: 1, b: 2, i: 3, j: 4, distance: Bracket{lower: 0.5, upper: 0.75}, point_a: "
            "Vec3{0, 0, "
            "1}, point_b: Vec3{0, 0, 2}}");
  EXPECT_EQ(printed(EnvironmentGap{}).rfind("EnvironmentGap{mover: 0, part: 0, i: 0, j: 0, ", 0),
            0U);
  EXPECT_EQ(printed(MoverPassage{1, 2, 3, 4, ContactVerdict::grazing, {0.5, 1}, {0, 0, 1}}),
            "MoverPassage{a: 1, b: 2, i: 3, j: 4, verdict: grazing, t: Bracket{lower: 0.5, upper: "
            "1}, point: Vec3{0, 0, 1}}");
  EXPECT_EQ(printed(StepOptions{}).rfind("StepOptions{mode: all, scope: every_pair, ", 0), 0U);
}

TEST(Values, PrintRecordings) {
  const RecordedMesh mesh{.name = "van", .source = "van.3ds", .triangles = 12};
  EXPECT_EQ(printed(mesh), R"(RecordedMesh{"van", origin: file, source: "van.3ds", 12 triangles})");
  EXPECT_EQ(printed(RecordedBody{mesh, {}}),
            "RecordedBody{" + printed(mesh) + ", Pose{1 0 0 0, 0 1 0 0, 0 0 1 0}}");
  RecordingHead head;
  head.title = "run";
  EXPECT_EQ(
      printed(head),
      R"(RecordingHead{"run", frames_a_second: 60, frames_requested: 0, environment: 0, models: )"
      R"(0, movers: 0, clearance: 0})");
  EXPECT_EQ(
      printed(RecordedFrame{}),
      "RecordedFrame{poses: 0, environment: 0, movers: 0, environment_gaps: 0, mover_gaps: 0, "
      "environment_passages: 0, mover_passages: 0}");
  EXPECT_EQ(printed(RecordingEnd{.ending = RecordingEnding::timed_out, .frames = 3}),
            "RecordingEnd{ending: timed_out, frames: 3, environment_contacts: 0, mover_contacts: "
            "0, hash: 0}");
}

TEST(Values, PrintFormatsAndWhatIsGenerated) {
  EXPECT_NE(printed(ReadOptions{}).find("allow_empty: false"), std::string::npos);
  EXPECT_EQ(printed(readable_formats().at(0)).rfind(R"(ReadableFormat{PLY, ".ply")", 0), 0U);
  EXPECT_EQ(printed(entry(MeshFormat::three_ds)),
            R"(WritableFormat{format: three_ds, name: "3ds", title: "3DS", extension: ".3ds", )"
            R"(doubles: false, names: true, unit_and_axis: false})");
  EXPECT_EQ(printed(Column{"length", true}), R"(Column{name: "length", may_be_infinite: true})");
  EXPECT_EQ(printed(Rounding{2, 0.5}), "Rounding{count: 2, most: 0.5}");
  EXPECT_EQ(printed(CityOptions{.triangles = 5000}),
            "CityOptions{triangles: 5000, size: 4000, seed: 1, streets: bare}");
  EXPECT_EQ(printed(Route{.points = {{0, 0, 0}}, .speed = 2.5}),
            "Route{1 point, closed: false, start: 0, speed: 2.5, base: 0}");
  EXPECT_EQ(printed(SpreadOptions{}).rfind("SpreadOptions{triangles: 20000, ratio: 1, ", 0), 0U);
  EXPECT_EQ(printed(UrbanScene::boxes), "boxes");
}

}  // namespace
}  // namespace soms
