/// \file
/// A scene that is looked at: bodies, their contacts, time, and what the hand moves.
#pragma once

#include "soms/base/parallel.h"
#include "soms/scene/scene.h"
#include "soms/tree/statistics.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"
#include "apps/view/scene/explain.h"
#include "apps/view/scene/frame_gaps.h"
#include "apps/view/scene/gap.h"
#include "apps/view/scene/mesh_facts.h"
#include "apps/view/scene/scene_content.h"
#include "apps/view/scene/touch.h"
#include "apps/view/scene/traversal_trace.h"
#include "apps/view/scene/view_options.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::view {

/// The first point of a scene on a ray.
struct SurfaceHit {
  std::optional<BodyRef> body = std::nullopt;  ///< nothing where the ray hits nothing
  TriangleId triangle = 0;
  Vec3 point = {};
  double t = std::numeric_limits<double>::infinity();  ///< in units of the ray's direction
};

/// Where a ray meets a scene first.
struct Picked {
  BodyRef body;
  TriangleId triangle = 0;
  std::uint32_t face = 0;                   ///< of the file
  std::uint32_t part = Part::kNoParent;     ///< part of the mesh
  std::string part_name;                    ///< empty where the file names none
  std::array<std::uint32_t, 3> vertices{};  ///< numbers of the corners in the file
  Triangle corners;                         ///< where they are
  Vec3 point;
  double distance = 0;         ///< from the ray's origin
  std::vector<Touch> touches;  ///< contacts of this triangle
  std::string explanation;     ///< some lines for people
};

/// Numbers for panels.
struct SceneStatistics {
  std::uint64_t bodies = 0;
  std::uint64_t triangles = 0;  ///< of the city once, of movers each
  std::uint64_t frame = 0;
  std::uint64_t contacts = 0;            ///< touching pairs of triangles
  std::uint64_t touching_movers = 0;     ///< movers that touch anything
  double clearance = 0;                  ///< within which there are gaps; 0: none are searched for
  std::uint64_t gaps = 0;                ///< pairs of bodies within it that do not touch
  std::optional<Gap> least_gap;          ///< the nearest of them
  std::uint64_t queries = 0;             ///< of the last step
  std::uint64_t box_pairs = 0;           ///< of the last step
  Cost cost;                             ///< of the last step
  double step_milliseconds = 0;          ///< the last step: poses, broad and narrow phase
  std::string_view rule;                 ///< of the trees that are shown
  std::string_view traversal;            ///< of the pair
  std::optional<TreeStatistics> tree_a;  ///< of the pair's first body, where its tree was built
  std::optional<TreeStatistics> tree_b;
  std::optional<TraversalCounts> trace;  ///< of the pair, where it was traversed
  std::uint64_t trace_pruned = 0;        ///< box tests of the traversal that ended a branch
  double trace_milliseconds = 0;
  bool trace_cut = false;  ///< it ended at `kMostWatchedTests`: counts are of what was traversed
};

/// A scene that is looked at. Contacts are always those of the present poses: whatever moves a body
/// asks the scene again.
///
/// Time: `step` brings the movers to the next frame of their motions, of an orientation test or of
/// a recording. A mover that is held stays where the hand put it.
/// The pair: a body of the city or a mover, and a mover, whose trees are shown and traversed.
/// \threads One caller at a time; uses the threads of `Limits`.
class ViewScene {
 public:
  /// Finds the contacts of frame 0. \errors As `Scene` for poses; ErrorKind::cancelled.
  explicit ViewScene(SceneContent content, const Limits& limits = {});
  ~ViewScene();
  ViewScene(ViewScene&&) noexcept;
  ViewScene& operator=(ViewScene&&) noexcept;

  [[nodiscard]] const std::string& title() const;

  /// Where on the Earth the coordinates lie, if a file of the city says so.
  [[nodiscard]] const Georeference& georeference() const;

  /// Meters a unit of all numbers, where the parts of the city declare the same; else 0.
  [[nodiscard]] double unit() const;
  [[nodiscard]] const std::vector<std::string>& notes() const;
  [[nodiscard]] const std::vector<command::FrameWarning>& warnings() const;
  [[nodiscard]] std::uint32_t city_parts() const;
  [[nodiscard]] std::uint32_t movers() const;

  /// The bodies at their present poses: part and mover k have the k-th least of their ids.
  [[nodiscard]] const Scene& scene() const;

  /// \pre `body` is there. The reference lasts until a body is added.
  [[nodiscard]] const Body& body(BodyRef body) const;

  /// World bounds of a body at its present pose: those of its moved box, so not tight.
  [[nodiscard]] Box bounds(BodyRef ref) const;

  /// World bounds of the city, or of everything where there is no city.
  [[nodiscard]] Box bounds() const;

  /// Adds a body, such as a dropped file; the other contacts are found again.
  BodyRef add_city(Body body);

  /// Adds to `notes` what is not there yet.
  void add_notes(const std::vector<std::string>& notes);

  BodyRef add_mover(MovingBody mover);

  /// Frame that is shown, from 0.
  [[nodiscard]] std::uint64_t frame() const;

  /// Frames there are: of a running test or a recording; nothing where time does not end.
  [[nodiscard]] std::optional<std::uint64_t> frames() const;

  /// The next frame; a test or recording begins again after its last one.
  /// \errors ErrorKind::cancelled; as `Replay::frame`.
  void step();

  /// Any frame; beyond the last one the last. \errors As `step`; the frame of before stays then.
  void go_to(std::uint64_t frame);

  /// True while contacts are those of the recording: nothing was held, tested or added.
  [[nodiscard]] bool replaying() const;

  /// Places a mover by hand and finds its contacts. It is held from then on.
  /// \errors As `Scene::set_pose`; the old pose stays then.
  void set_pose(std::uint32_t mover, const Pose& pose);
  void hold(std::uint32_t mover);
  void release(std::uint32_t mover);  ///< it goes on along its motion with the next step
  [[nodiscard]] bool held(std::uint32_t mover) const;

  /// The two bodies whose trees are shown: the second is a mover. Nothing without movers.
  [[nodiscard]] std::optional<std::pair<BodyRef, BodyRef>> pair() const;
  /// \errors ErrorKind::usage unless both are there, differ, and `b` is a mover.
  void set_pair(BodyRef a, BodyRef b);

  /// Sends the pair's mover through an orientation test, from its frame 0.
  /// \errors ErrorKind::usage for an unknown name, without a pair, and for an empty model.
  void start_test(std::string_view name, std::size_t up = 2);
  void end_test();
  [[nodiscard]] std::optional<std::string_view> test() const;

  /// All contacts at the present poses, sorted.
  [[nodiscard]] const std::vector<Touch>& contacts() const;

  /// Who is within the clearance without touching, at the present poses; the nearest first. A
  /// recording with gaps has a clearance, and all else none.
  [[nodiscard]] const std::vector<Gap>& frame_gaps() const;

  /// Where the bodies of the pair are nearest, if they share no point; queried again only when
  /// one of them moved. The whole city counts as the pair's first body where that is a part of it.
  /// Where nothing moves at all, the pair are the two parts of a city of two.
  /// \errors As `distance`.
  [[nodiscard]] const std::optional<Gap>& gap() const;

  /// Ends the search for a gap after this time. A window needs it: surfaces that are everywhere
  /// equally near, as of two concentric balls of a million triangles, take seconds.
  void set_gap_patience(GapStore::Patience patience);

  /// Distance queries that gaps took so far.
  [[nodiscard]] std::uint64_t gap_queries() const;

  /// Numbers in the files of the city, of which parts may be left out.
  [[nodiscard]] const CityNumbers& numbers() const { return numbers_; }

  /// World corners of a triangle at its body's present pose.
  [[nodiscard]] Triangle triangle(BodyRef ref, TriangleId i) const;

  /// What two touching triangles have in common.
  [[nodiscard]] CommonPoints common_points(const Touch& touch) const;

  /// Why a pair of triangles touches or does not.
  [[nodiscard]] Explanation explain(const Touch& pair) const;

  /// What each of `rays` hits first, as `Scene::closest_hit`; without movers of the city alone.
  /// \shape  n rays give n answers.
  /// \errors As `Scene::closest_hit`.
  [[nodiscard]] std::vector<SurfaceHit> first_hits(std::span<const Ray> rays,
                                                   bool with_movers = true,
                                                   const Limits& limits = {}) const;

  /// A triangle with facts for people, as of now: its middle, and no distance.
  [[nodiscard]] Picked picked(BodyRef at, TriangleId i) const;

  /// The first triangle that a ray meets, with facts for people. \errors As `first_hits`.
  [[nodiscard]] std::optional<Picked> pick(const Ray& ray, bool with_movers = true) const;

  /// The contact that is seen nearest to a ray, if it is seen less than `angle` radians off; hidden
  /// ones count. \cost O(contacts).
  [[nodiscard]] std::optional<Touch> pick_contact(const Ray& ray, double angle) const;

  /// Changes how trees are built and traversed. Trees are built when they are needed.
  /// \errors ErrorKind::usage for options out of range.
  void set_trees(const TreeChoice& choice);
  [[nodiscard]] const TreeChoice& trees() const;

  /// Goes up whenever trees are built in another way.
  [[nodiscard]] std::uint64_t trees_version() const;

  /// The tree of a body by the present choice; built on the first call, shared by equal meshes.
  [[nodiscard]] const Tree& tree(BodyRef body);

  /// The pair's traversal at the present poses; made again only after a change. An empty traversal
  /// without a pair and by Traversal::fast. `world_boxes` are the boxes that it tests.
  [[nodiscard]] const TraversalTrace& trace();

  /// Goes up with each new traversal.
  [[nodiscard]] std::uint64_t trace_version() const;

  /// Boxes of the nodes of a body's tree at its present pose, as the traversals test them.
  [[nodiscard]] std::span<const Box> world_boxes(BodyRef body);

  /// Keys, colors and parts of the meshes.
  [[nodiscard]] MeshFactsStore& mesh_facts();

  [[nodiscard]] SceneStatistics statistics() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  CityNumbers numbers_;
};

}  // namespace soms::view
