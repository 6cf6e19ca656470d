#include "apps/report/scene_data.h"

#include "apps/report/data_block.h"
#include "apps/report/live_data.h"
#include "apps/report/motion_data.h"
#include "apps/report/packed.h"
#include "apps/report/placing.h"
#include "apps/report/scene_models.h"
#include "apps/report/script_text.h"
#include "apps/report/sight.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::report {

namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
/// Scenes of other sizes are scaled by a power of two, so that floats hold them.
constexpr double kSmallest = 1e-3;
constexpr double kLargest = 1e7;
constexpr std::uint64_t kBytesOfPose = 28;  // at most; packed it is about a third
constexpr int kBitsOfPlace = 24;            ///< of the scene's size: 0.3 mm of 4 km
constexpr int kBitsOfCurve = 12;            ///< of a curve's box

std::uint32_t short_number(std::uint64_t value) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(value, kNone));
}

template <typename Values, typename Text>
std::string list_of(const Values& values, const Text& text) {
  std::string list = "[";
  for (const auto& value : values) {
    list += fmt::format("{}{}", list.size() == 1 ? "" : ",", text(value));
  }
  return list + "]";
}

/// Writes one scene.
class SceneWriter {
 public:
  SceneWriter(std::ostream& out, const Scene& scene, const SceneLimits& limits)
      : out_(out), scene_(scene), limits_(limits) {
    bodies_ = chosen_bodies(scene, limits.bodies);
    number_.assign(scene.bodies.size(), kNone);
    for (std::uint32_t k = 0; k < bodies_.size(); ++k) {
      number_[bodies_[k]] = k;
      moving_ += scene.bodies[bodies_[k]].moves ? 1U : 0U;
    }
    for (const SceneModel& model : scene.models) {
      bounds_.push_back(soms::bounds(model.mesh));
    }
    steps_ = scene.steps.kept;
    if (steps_.empty()) {
      const std::uint64_t room =
          limits.pose_bytes / (kBytesOfPose * std::max<std::uint64_t>(1, moving_));
      steps_ = spread_steps(scene.steps.count, std::max<std::uint64_t>(2, room));
    }
    set_frame();
  }

  Shown write(const std::function<void()>& script) {
    count_contacts();
    models_.emplace(scene_, bodies_, scale_, limits_,
                    [this](std::size_t model) { return detail_of(model); });
    live_.emplace(scene_, bodies_, steps_, limits_);
    shown_.triangles = models_->triangles();
    shown_.triangles_in_all = models_->triangles_in_all();
    models_->write_first(out_);
    write_poses();
    write_rows();
    write_curves();
    write_contacts();
    write_pairs();
    write_gaps();
    write_json();
    if (script) {
      script();
    }
    models_->write_rest(out_);
    // A hand and the slider of a motion would move the same body.
    shown_.is_live = scene_.motions.empty() && live_->is_there();
    if (shown_.is_live) {
      live_->write(out_);
    }
    return shown_;
  }

 private:
  [[nodiscard]] const Box& bounds_of(std::uint32_t body) const {
    return bounds_[scene_.bodies[body].model];
  }

  /// Origin and scale.
  void set_frame() {
    for (const std::uint32_t body : bodies_) {
      const bool moves = scene_.bodies[body].moves;
      for (const std::uint64_t step : steps_) {
        box_.grow(moved(bounds_of(body), scene_.pose(body, step)));
        if (!moves) {
          break;
        }
      }
    }
    if (box_.empty()) {
      return;
    }
    origin_ = box_.center();
    const double size = length(box_.extent());
    if (size > 0 && (size < kSmallest || size > kLargest)) {
      scale_ = std::exp2(std::clamp(-std::floor(std::log2(size)), -1000.0, 1000.0));
    }
  }

  [[nodiscard]] Vec3 place(const Vec3& at) const { return (at - origin_) * scale_; }

  void count_contacts() {
    shown_.rows = scene_.rows.size();
    shown_.contacts = std::min(scene_.contacts.size(), limits_.contacts);
    shown_.contacts_in_all = scene_.contacts_in_all;
    shown_.gaps = std::min(scene_.gaps.size(), limits_.gaps);
    shown_.gaps_in_all = scene_.gaps_in_all;
    std::vector<std::uint64_t> wanted;
    for (std::size_t k = 0; k < shown_.contacts; ++k) {
      wanted.push_back(std::min(scene_.contacts[k].pairs.size(), limits_.pairs_of_contact));
    }
    for (const std::uint64_t share : fair_shares(wanted, limits_.pairs)) {
      first_pair_.push_back(pairs_);
      pairs_ += share;
    }
    first_pair_.push_back(pairs_);
  }

  [[nodiscard]] std::uint64_t pairs_of(std::size_t contact) const {
    return first_pair_[contact + 1] - first_pair_[contact];
  }

  [[nodiscard]] Triangle triangle(std::uint32_t body, TriangleId i, const Pose& pose) const {
    return moved(scene_.models[scene_.bodies[body].model].mesh.triangle(i), pose);
  }

  template <typename Shown>
  [[nodiscard]] Sight sight(const Shown& shown) const {
    return sight_of(shown, scene_, bounds_, length(box_.extent()));
  }

  /// Places in the coordinates of a model that contacts and gaps are at.
  [[nodiscard]] Detail detail_of(std::size_t model) const {
    Detail detail;
    for (std::size_t k = 0; k < shown_.contacts; ++k) {
      const SceneContact& contact = scene_.contacts[k];
      const std::array<Pose, 2> poses = soms::report::poses_of(scene_, contact);
      for (const std::size_t side : {0U, 1U}) {
        if (scene_.bodies[side == 0 ? contact.a : contact.b].model == model) {
          const Sight at = sight(contact);
          detail.points.push_back(moved_back(at.focus, poses[side]));
          detail.radius = std::max(detail.radius, at.reach);
        }
      }
    }
    for (std::size_t k = 0; k < shown_.gaps; ++k) {
      const SceneGap& gap = scene_.gaps[k];
      for (const auto& [body, point] :
           {std::pair(gap.a, gap.point_a), std::pair(gap.b, gap.point_b)}) {
        if (scene_.bodies[body].model == model) {
          detail.points.push_back(moved_back(point, scene_.pose(body, gap.nearest)));
          detail.radius = std::max(detail.radius, sight(gap).reach);
        }
      }
    }
    return detail;
  }

  void put(Base64Writer& data, const Vec3& at) const {
    for (const double value : {at.x, at.y, at.z}) {
      data.put(static_cast<float>(value));
    }
  }

  /// Place of the middle of the body's model, and its turning.
  void put_pose(Base64Writer& data, std::uint32_t body, std::uint64_t step) const {
    put_pose(data, body, scene_.pose(body, step));
  }

  void put_pose(Base64Writer& data, std::uint32_t body, const Pose& pose) const {
    put(data, place(pose.apply(models_->middle(scene_.bodies[body].model))));
    for (const double part : quaternion(pose)) {
      data.put(static_cast<float>(part));
    }
  }

  void write_poses() {
    DataBlock still(out_, "still");
    for (const std::uint32_t body : bodies_) {
      if (!scene_.bodies[body].moves) {
        put_pose(still.data(), body, 0);
      }
    }
    still.finish();
    DataBlock block(out_, "poses");
    for (const std::uint32_t body : bodies_) {
      if (scene_.bodies[body].moves) {
        PackedPath path(block.data(), step_of_places());
        for (const std::uint64_t step : steps_) {
          const Pose pose = scene_.pose(body, step);
          path.put(place(pose.apply(models_->middle(scene_.bodies[body].model))), quaternion(pose));
        }
      }
    }
    block.finish();
    shown_.bodies = bodies_.size();
    shown_.bodies_in_all = scene_.bodies.size();
    shown_.steps = steps_.size();
    shown_.steps_in_all = scene_.steps.count;
  }

  [[nodiscard]] double step_of_places() const {
    return step_of(box_.empty() ? 0 : length(box_.extent()) * scale_, kBitsOfPlace);
  }

  /// What a triangle of a body is called.
  [[nodiscard]] TriangleId named(std::size_t body, TriangleId triangle) const {
    const std::span<const TriangleId> numbers = scene_.models[scene_.bodies[body].model].numbers;
    return triangle < numbers.size() ? numbers[triangle] : triangle;
  }

  void write_rows() {
    DataBlock block(out_, "rows");
    Base64Writer& data = block.data();
    for (const SceneRow& row : scene_.rows) {
      for (const std::uint32_t value :
           {number_[row.a], number_[row.b], row.part_a, row.part_b,
            static_cast<std::uint32_t>(row.count & kNone),
            static_cast<std::uint32_t>(row.count >> 32), short_number(row.steps),
            short_number(row.begin), short_number(row.end), named(row.a, row.first.a),
            named(row.b, row.first.b), short_number(row.most_pairs), short_number(row.most_step)}) {
        data.put(value);
      }
      put(data, row.box.empty() ? Vec3{} : place(row.box.center()));
      put(data, row.box.empty() ? Vec3{} : row.box.extent() * (0.5 * scale_));
    }
    block.finish();
  }

  /// Where the bodies of a row are in the step of its most pairs, if these are known.
  void write_curves() {
    DataBlock block(out_, "curves");
    Base64Writer& data = block.data();
    for (std::size_t r = 0; r < scene_.rows.size(); ++r) {
      const SceneRow& row = scene_.rows[r];
      if (row.pairs.empty()) {
        continue;
      }
      data.put(short_number(r));
      data.put(short_number(row.pairs.size()));
      put(data, place(row.place));
      data.put(static_cast<float>(sight(row).reach * scale_));
      data.put(static_cast<float>(step_of_curve(row)));
      put_pose(data, row.a, row.most_step);
      put_pose(data, row.b, row.most_step);
    }
    block.finish();
    DataBlock lines(out_, "lines");
    for (const SceneRow& row : scene_.rows) {
      put_lines(lines.data(), lines_of(row), place(row.place), step_of_curve(row));
    }
    lines.finish();
  }

  [[nodiscard]] double step_of_curve(const SceneRow& row) const {
    return step_of(length(row.box.extent()) * scale_, kBitsOfCurve);
  }

  /// Where the triangles of a row's pairs cross.
  [[nodiscard]] std::vector<std::array<Vec3, 2>> lines_of(const SceneRow& row) const {
    std::vector<std::array<Vec3, 2>> lines;
    if (!row.pairs.empty()) {
      const Pose pose_a = scene_.pose(row.a, row.most_step);
      const Pose pose_b = scene_.pose(row.b, row.most_step);
      for (const auto& [i, j] : row.pairs) {
        const auto [from, to] =
            crossing_line(triangle(row.a, i, pose_a), triangle(row.b, j, pose_b));
        lines.push_back({place(from), place(to)});
      }
    }
    return lines;
  }

  void write_contacts() {
    DataBlock block(out_, "contacts");
    Base64Writer& data = block.data();
    for (std::size_t k = 0; k < shown_.contacts; ++k) {
      const SceneContact& contact = scene_.contacts[k];
      for (const std::uint32_t value :
           {number_[contact.a], number_[contact.b], contact.part_a, contact.part_b,
            short_number(contact.begin), short_number(contact.end),
            short_number(contact.pairs_in_all), short_number(first_pair_[k]),
            short_number(pairs_of(k))}) {
        data.put(value);
      }
      const Sight at = sight(contact);
      put(data, place(at.focus));
      data.put(static_cast<float>(at.reach * scale_));
      const auto [pose_a, pose_b] = soms::report::poses_of(scene_, contact);
      put_pose(data, contact.a, pose_a);
      put_pose(data, contact.b, pose_b);
      data.put(static_cast<std::uint32_t>(contact.row));
    }
    block.finish();
  }

  void write_pairs() {
    DataBlock block(out_, "pairs");
    Base64Writer& data = block.data();
    for (std::size_t k = 0; k < shown_.contacts; ++k) {
      const SceneContact& contact = scene_.contacts[k];
      const auto [pose_a, pose_b] = soms::report::poses_of(scene_, contact);
      for (std::size_t n = 0; n < pairs_of(k); ++n) {
        const auto& [i, j] = contact.pairs[n];
        put_unsigned(data, named(contact.a, i));
        put_unsigned(data, named(contact.b, j));
        const Triangle a = triangle(contact.a, i, pose_a);
        const Triangle b = triangle(contact.b, j, pose_b);
        const auto [from, to] = crossing_line(a, b);
        put_points(data,
                   std::array{place(from), place(to), place(a.a), place(a.b), place(a.c),
                              place(b.a), place(b.b), place(b.c)},
                   step_of_places());
      }
    }
    block.finish();
  }

  void write_gaps() {
    DataBlock block(out_, "gaps");
    Base64Writer& data = block.data();
    for (std::size_t k = 0; k < shown_.gaps; ++k) {
      const SceneGap& gap = scene_.gaps[k];
      for (const std::uint32_t value : {number_[gap.a], number_[gap.b], short_number(gap.begin),
                                        short_number(gap.end), short_number(gap.nearest)}) {
        data.put(value);
      }
      put(data, place(gap.point_a));
      put(data, place(gap.point_b));
      data.put(static_cast<float>(sight(gap).reach * scale_));
      put_pose(data, gap.a, gap.nearest);
      put_pose(data, gap.b, gap.nearest);
    }
    block.finish();
  }

  static std::string numbers(const Vec3& v) { return fmt::format("[{},{},{}]", v.x, v.y, v.z); }

  /// When the rows behind all others are, if they are passages.
  void write_passages() {
    const auto first =
        std::find_if(scene_.rows.begin(), scene_.rows.end(),
                     [](const SceneRow& row) { return row.meeting != Meeting::touch; });
    if (first != scene_.rows.end()) {
      const std::span passages(first, scene_.rows.end());
      out_ << fmt::format(",\"passages\":{{\"row\":{},\"after\":", first - scene_.rows.begin())
           << list_of(passages, [](const SceneRow& row) { return row.after; }) << ",\"proved\":"
           << list_of(passages,
                      [](const SceneRow& row) { return row.meeting == Meeting::passage ? 1 : 0; })
           << "}";
    }
  }

  void write_json() {
    const Vec3 half = box_.empty() ? Vec3{} : (box_.extent() * (0.5 * scale_));
    out_ << "<script type=\"application/json\" id=\"soms-scene\">{\"schema\":\"soms.scene/3\"";
    out_ << fmt::format(",\"up\":\"{}\",\"origin\":{},\"scale\":{},\"half\":{}",
                        scene_.y_is_up ? 'y' : 'z', numbers(origin_), scale_, numbers(half));
    out_ << ",\"models\":[" << models_->json() << "]";
    const auto body = [&](std::uint32_t k) -> const SceneBody& { return scene_.bodies[k]; };
    out_ << ",\"bodies\":{\"model\":" << list_of(bodies_, [&](auto k) { return body(k).model; })
         << ",\"moves\":" << list_of(bodies_, [&](auto k) { return body(k).moves ? 1 : 0; })
         << ",\"names\":" << list_of(bodies_, [&](auto k) {
              return script_text(shortened(body(k).name, kLongestText));
            });
    out_ << fmt::format(",\"all\":{}}}", shown_.bodies_in_all);
    out_ << fmt::format(
                ",\"steps\":{{\"count\":{},\"noun\":{},\"second\":{},\"smooth\":{},\"kept\":",
                scene_.steps.count, script_text(scene_.steps.noun), scene_.steps.a_second,
                scene_.steps.smooth)
         << list_of(steps_, [](auto step) { return step; }) << "}";
    out_ << fmt::format(
        ",\"place_step\":{},\"turns\":{},\"row\":{{\"one\":{},\"many\":{}}},\"complete\":{},"
        "\"rows\":{},\"contacts\":{{\"listed\":{},\"all\":{},\"pairs\":{},\"one\":"
        "{},\"many\":{}}"
        "}",
        step_of_places(), kTurns, script_text(scene_.row.one), script_text(scene_.row.many),
        scene_.complete, shown_.rows, shown_.contacts, shown_.contacts_in_all, pairs_,
        script_text(scene_.contact.one), script_text(scene_.contact.many));
    out_ << fmt::format(",\"gaps\":{{\"listed\":{},\"all\":{},\"lengths\":", shown_.gaps,
                        shown_.gaps_in_all)
         << list_of(std::span(scene_.gaps).first(shown_.gaps),
                    [](const SceneGap& gap) {
                      return script_text(shortened(gap.length, kLongestText));
                    })
         << "}";
    write_passages();
    out_ << ",\"live\":"
         << (scene_.motions.empty()
                 ? live_->json([this](std::size_t model) { return models_->middle(model); })
                 : "null");
    if (!scene_.motions.empty()) {
      out_ << motions_json(scene_, {.middle = models_->middle(scene_.bodies.front().model),
                                    .origin = origin_,
                                    .scale = scale_});
    }
    const auto words = [](const std::string& text) {
      return script_text(shortened(text, kLongestText));
    };
    out_ << ",\"parts\":"
         << list_of(scene_.parts, [&](const auto& part) { return words(part.name); })
         << ",\"paths\":"
         << list_of(scene_.parts,
                    [&](const auto& part) {
                      return part.path == part.name
                                 ? "\"\""
                                 : script_text(shortened_front(part.path, kLongestText));
                    })
         << "}</script>\n";
  }

  std::ostream& out_;
  const Scene& scene_;
  const SceneLimits& limits_;
  std::vector<std::uint32_t> bodies_;  ///< drawn
  std::vector<std::uint32_t> number_;  ///< of each body among those drawn
  std::uint64_t moving_ = 0;
  std::vector<Box> bounds_;  ///< of the models
  std::vector<std::uint64_t> steps_;
  Box box_;
  Vec3 origin_;
  double scale_ = 1;
  std::uint64_t pairs_ = 0;
  std::vector<std::uint64_t> first_pair_;
  std::optional<SceneModels> models_;
  std::optional<LiveData> live_;
  Shown shown_;
};

}  // namespace

Shown write_scene(std::ostream& out, const Scene& scene, const SceneLimits& limits,
                  const std::function<void()>& script) {
  return SceneWriter(out, scene, limits).write(script);
}

}  // namespace soms::report
