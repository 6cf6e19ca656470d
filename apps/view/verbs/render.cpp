#include "apps/view/verbs/render.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/model/part_filter.h"
#include "apps/output/output.h"
#include "apps/view/drawing/gl/gl_renderer.h"
#include "apps/view/drawing/gl/headless_context.h"
#include "apps/view/scene/draw_scene.h"
#include "apps/view/scene/event_finder.h"
#include "apps/view/scene/orientation_menu.h"
#include "apps/view/scene/shown_boxes.h"
#include "apps/view/scene/traversal_trace.h"
#include "apps/view/verbs/render_moment.h"
#include "apps/view/verbs/render_rays.h"
#include "apps/view/verbs/render_remarks.h"
#include "apps/view/verbs/render_report.h"
#include "apps/view/verbs/render_scene.h"
#include "apps/view/verbs/stage.h"
#include "apps/view/verbs/tree_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

constexpr int kMostImageSide = 16'384;
constexpr std::uint64_t kLeastMemory = std::uint64_t{256} << 20;  // drivers crash with less
constexpr std::size_t kMostContacts = 1'000'000;
constexpr std::uint8_t kGlass = 70;  // opacity of --see-through
constexpr std::uint8_t kBoxFaces = 60;

const char* const kRenderFooter =
    "Without CITY, an embedded city of 1,000,000 triangles is used, with cars, persons and\n"
    "drones. A city from files has movers only if --mover, --route or --count is given. Red is\n"
    "where surfaces touch. Without --frame some 60 frames are searched for one in which many\n"
    "movers touch. Two models that touch nowhere have a line between their nearest points, with\n"
    "its length. A camera is a subject (scene, contact, gap or mover:N), a side (north,\n"
    "southwest, top, or bearing:elevation in degrees) and a zoom, in any order, as in\n"
    "contact,45:30,2x; or six numbers: the position of the eye and the point that it looks at.\n\n"
    "Example:\n"
    "  soms generate city --triangles 20000 -o town.ply\n"
    "  soms render town.ply -o town.png --size 960x540";

void add_picture_options(command::Parser& parser, RenderOptions& options) {
  parser
      .add_option("-o,--output", options.output,
                  "PNG file to write; --depth and --visible-from also write arrays (.npy),\n"
                  "and the latter maps (.svg, .asc); - is standard output")
      ->required()
      ->option_text("FILE");
  parser
      .add_option_function(
          "--size",
          [&options](const std::string& text) { options.size = parse_picture_size(text); },
          "width and height in pixels, up to 16384x16384 (1920x1080)")
      ->option_text("WxH");
  parser
      .add_option_function(
          "--camera",
          [&options](const std::string& text) {
            std::string clash = std::move(options.camera.clash);
            options.camera = parse_camera(text);
            options.camera.clash = std::move(clash);
          },
          "point of view; see below (contact where something touches, else\ngap or scene)")
      ->option_text("CAMERA");
  parser.add_flag("--depth", options.depth,
                  "draw how far surfaces are from the eye, by rays; needs no graphics driver");
  parser
      .add_option_function(
          "--visible-from",
          [&options](const std::string& text) {
            options.visible_from = command::parse_point("--visible-from", text);
          },
          "draw what the point X,Y,Z sees, by rays: as a picture, or from above as\n"
          "a map if the output is an SVG file or an ESRI grid (.asc)")
      ->option_text("X,Y,Z");
  parser.add_flag("--center", options.center,
                  "measure the numbers of --camera from the center of the scene");
  command::add_count(parser, "--samples", options.samples, 1, 16,
                     "samples per pixel; more give smoother edges and take more memory (4)");
}

void add_content_options(command::Parser& parser, RenderOptions& options) {
  parser
      .add_option("--pose", options.pose,
                  "pose of the mover: \"x y z [qw qx qy qz]\", or a CSV file of poses,\n"
                  "which are drawn all at once")
      ->option_text("POSE");
  command::add_count(parser, "--frame", options.frame, 0, 1'000'000'000,
                     "frame of the simulation to draw, at 60 frames per second (one in\n"
                     "which many movers touch)");
  parser
      .add_option("--clash", options.camera.clash,
                  "contact that the camera looks at: its number among the pairs of parts,\n"
                  "that with most pairs of triangles first, or a part's name, or two with a comma")
      ->option_text("CLASH");
  command::add_count(parser, "--level", options.level, 1, 1000,
                     "draw the boxes of this level of the tree, and paler the\nleaves above it; "
                     "the root is level 1");
  command::add_choice<LevelOf>(parser, "--level-of", options.level_of,
                               {{"city", LevelOf::city}, {"mover", LevelOf::mover}},
                               "tree that --level draws (city)");
  command::add_choice<BoxStyle>(
      parser, "--boxes", options.boxes,
      {{"wire", BoxStyle::wire}, {"solid", BoxStyle::solid}, {"both", BoxStyle::both}},
      "draw edges of boxes, faces, or both (wire)");
  parser.add_flag("--trace", options.trace,
                  "draw the boxes that --traversal visited (black), pruned (gray) and found (red)\n"
                  "in the city and the mover (e-node with --descent larger); surfaces that\n"
                  "touch are violet then");
  parser.add_flag_callback(
      "--no-prune", [&options] { options.shown.trees.traversal.prune = false; },
      "with --trace: descend into disjoint boxes, too, to see what pruning saves");
  add_test(parser, options.test,
           "send the mover through an orientation test; --frame chooses\nthe frame");
  command::add_choice<CityColors>(
      parser, "--colors", options.shown.city_colors,
      {{"building", CityColors::by_building}, {"plain", CityColors::plain}},
      "colors of the city (building)");
  parser.add_flag("--see-through", options.see_through, "draw the city as glass");
  parser.add_flag_callback(
      "--edges",
      [&options] {
        options.shown.city_style = SurfaceStyle::both;
        options.shown.mover_style = SurfaceStyle::both;
      },
      "also draw the edges of triangles");
  parser.add_flag("--contacts-on-top", options.shown.contacts.on_top,
                  "draw contacts over everything that hides them");
  parser.add_flag("--no-gap", options.no_gap,
                  "do not draw the nearest points of two models that touch nowhere, nor\n"
                  "the gaps of a recording");
  parser.add_flag("--spots", options.shown.contacts.all_markers,
                  "number the touching movers also where their contacts are large\n"
                  "enough to be seen");
  parser.add_flag_callback(
      "--no-markers", [&options] { options.shown.contacts.markers = false; },
      "do not number touching movers whose contacts are too small to be seen");
  parser.add_option("--title", options.title, "words above the picture")->option_text("TEXT");
  parser.add_flag_callback(
      "--no-key", [&options] { options.shown.key = false; },
      "leave out the key of colors, names at a contact, the scale bar and the arrow\nto the north");
  parser.add_flag_callback(
      "--no-ground", [&options] { options.shown.ground = false; },
      "draw no ground below the models");
  parser.add_flag("--no-shadow", options.no_shadow, "draw no shadows");
  add_tree_options(parser, options.shown.trees.build, options.shown.trees.traversal);
}

/// \errors ErrorKind::usage for a level below the deepest leaf, where no box is.
void check_level(int level, const Tree& tree, int per_leaf) {
  std::uint32_t levels = 0;
  for (const Node& node : tree.nodes) {
    levels = std::max(levels, node.depth + 1);
  }
  if (static_cast<std::uint32_t>(level) > levels) {
    throw Error(
        ErrorKind::usage,
        fmt::format("--level {}: the tree has only {}", level, command::counted(levels, "level")),
        levels == 0     ? std::string("leave it out")
        : per_leaf == 1 ? fmt::format("give 1 to {}", levels)
                        : fmt::format("give 1 to {}, or --leaf below {}", levels, per_leaf));
  }
}

ViewOptions what_is_shown(const RenderOptions& options, ViewScene& scene) {
  ViewOptions shown = options.shown;
  shown.contacts.most = kMostContacts;
  shown.gap = draws_gap(options, scene);
  shown.frame_gaps.shown = !options.no_gap;
  if (options.see_through) {
    shown.colors.plain_city.a = kGlass;
  }
  if (options.boxes != BoxStyle::wire) {
    shown.colors.level.a = kBoxFaces;
    shown.colors.leaf_above.a = kBoxFaces;
  }
  const bool of_mover = options.level_of == LevelOf::mover;
  if (options.level) {
    if ((of_mover ? scene.movers() : scene.city_parts()) == 0) {
      throw Error(ErrorKind::usage, "--level: there is no mover", "give a --mover");
    }
    const BodyRef body = level_body(options);
    scene.set_trees(options.shown.trees);
    check_level(*options.level, scene.tree(body), options.shown.trees.build.per_leaf);
    shown.level = LevelBoxes{.body = body, .level = *options.level, .style = options.boxes};
  }
  if (options.trace) {
    if (!scene.pair()) {
      throw Error(ErrorKind::usage, "--trace: there is no mover", "give a --mover");
    }
    shown.trace = TraceBoxes{};
  }
  return shown;
}

/// What the options name. What was left out is reported on the way.
SceneContent load(const RenderOptions& options, command::Console& console) {
  command::WorldOptions world = options.world;
  // Numbers that were given are those of the file.
  world.guess_up =
      options.camera.subject != CameraChoice::Subject::place && !is_ray_picture(options);
  SceneContent content = options.test.empty()
                             ? load_content(std::move(world), options.pose, console)
                             : load_tested(std::move(world), options.pose, console);
  // Numbers of triangles are those of the file, which bodies that move have not got in part.
  const command::PartFilter* const parts = options.world.city_model.parts.get();
  if (!is_ray_picture(options) && !options.level && (parts == nullptr || !parts->is_given())) {
    make_pair_of_two(content);
  }
  if (content.recording) {
    for (const std::string& note : content.notes) {
      console.note(note);
    }
  }
  return content;
}

/// \errors ErrorKind::usage for a frame behind the last one of a recording or test.
void check_frame(std::uint64_t frame, const ViewScene& scene) {
  const std::optional<std::uint64_t> frames = scene.frames();
  if (frame > 0 && frames && frame >= *frames) {
    throw Error(ErrorKind::usage, fmt::format("--frame {}", frame),
                *frames == 0 ? std::string("there is no frame")
                             : fmt::format("there are frames from 0 to {} only", *frames - 1));
  }
}

/// \errors ErrorKind::usage for options that would change nothing beside the others.
void check_effects(const command::Parser& parser, RenderOptions& options) {
  const auto needs = [&](const char* option, bool there, const char* other) {
    if (parser.count(option) > 0 && !there) {
      throw Error(ErrorKind::usage, fmt::format("{} has no effect without {}", option, other),
                  fmt::format("also give {}, or leave it out", other));
    }
  };
  needs("--level-of", options.level.has_value(), "--level");
  needs("--boxes", options.level.has_value(), "--level");
  needs("--no-prune", options.trace, "--trace");
  needs("--center", options.camera.subject == CameraChoice::Subject::place,
        "six numbers of --camera");
  needs("--traversal", options.trace, "--trace");
  using Subject = CameraChoice::Subject;
  if (parser.count("--clash") > 0) {
    if (options.camera.subject == Subject::open) {
      options.camera.subject = Subject::contact;
    }
    needs("--clash", options.camera.subject == Subject::contact, "--camera contact");
  }
  needs("--descent", options.trace, "--trace");
  if (const std::string given = command::given_of_trees(parser); !given.empty()) {
    needs(given.c_str(), options.trace || options.level, "--level or --trace");
  }
  check_tree_options(parser, options.shown.trees.build, options.shown.trees.traversal);
  if (options.trace && options.shown.trees.traversal.traversal == Traversal::fast) {
    throw Error(ErrorKind::usage, "--trace: --traversal fast visits no boxes of the trees",
                "choose another traversal, or leave it out");
  }
  if (parser.count("--no-prune") > 0 &&
      options.shown.trees.traversal.traversal == Traversal::e_node_front) {
    throw Error(ErrorKind::usage, "--no-prune: --traversal e-node-front needs pruning",
                "choose another traversal, or leave it out");
  }
}

/// The frame that is drawn where none is searched for.
std::uint64_t drawn_frame(const RenderOptions& options) {
  return options.frame.value_or(options.test.empty() ? 0 : fullest_frame(options.test));
}

/// True if the frame in which most movers touch is drawn. Rays show no contacts.
bool searches_frame(const RenderOptions& options) {
  return !options.frame && options.test.empty() && !is_ray_picture(options);
}

/// The scene at its frame, with its contacts.
Moment make_scene(const RenderOptions& options, command::Console& console) {
  constexpr std::uint64_t kMostSearched = 600;
  SceneContent content = load(options, console);
  const std::uint64_t frames = frames_to_search(content);
  const bool must_touch = options.camera.subject == CameraChoice::Subject::contact;
  return console.run("finding what touches", [&](const Limits& limits) {
    Moment moment{ViewScene(std::move(content), limits), frames, std::nullopt};
    if (!options.test.empty()) {
      moment.scene.start_test(options.test);
    }
    if (searches_frame(options) && frames > 1) {
      const std::uint64_t most = must_touch ? frames : kMostSearched;
      moment.found = go_to_richest(moment.scene, frames, most, limits);
    } else if (const std::uint64_t frame = drawn_frame(options); frame > 0) {
      check_frame(frame, moment.scene);
      moment.scene.go_to(frame);
    }
    if (must_touch && moment.scene.contacts().empty()) {
      refuse_without_contact(moment, limits);
    }
    return moment;
  });
}

/// True if the scene looks alike in every frame.
bool stands_still(const RenderOptions& options, const ViewScene& scene) {
  return !scene.frames() && (scene.movers() == 0 || !options.pose.empty());
}

/// The contact that a picture is of.
std::optional<TouchingPair> touching_in(const RenderOptions& options, const ViewScene& scene,
                                        const AimedCamera& aimed) {
  if (!aimed.pair) {
    return std::nullopt;
  }
  const auto has_parts = [&](BodyRef body) {
    return scene.body(body).shape.mesh().parts.size() > 1;
  };
  const bool of_parts = has_parts(aimed.pair->a) && has_parts(aimed.pair->b);
  const bool alone = !options.camera.clash.empty() || (scene.movers() == 1 && of_parts);
  return TouchingPair{*aimed.pair, aimed.around, alone};
}

/// What is drawn, and from where.
std::pair<DrawnScene, AimedCamera> compose(const RenderOptions& options, ViewScene& scene,
                                           const command::Console& console) {
  return console.run("choosing what is shown", [&](const Limits& limits) {
    const Vec3 origin = options.center ? scene_bounds(scene).center() : Vec3{};
    CameraChoice choice = options.camera;
    choice.with_gap = draws_gap(options, scene);
    choice.boxes = options.level || options.trace;
    choice.may_cut = true;
    const AimedCamera aimed = aimed_by(choice, scene, options.size, origin, limits);
    const Camera& camera = aimed.camera;
    ViewOptions shown = what_is_shown(options, scene);
    shown.touching = touching_in(options, scene, aimed);
    if (choice.subject == CameraChoice::Subject::contact) {
      shown.focus = aimed.around;
    }
    DrawnScene drawn = draw_scene(scene, shown);
    drawn.list.captions.title = options.title;
    drawn.list.light.toward = sun_for(camera, scene);
    if (drawn.list.ground) {
      drawn.list.ground->center.z = ground_level(camera, scene, drawn.list.ground->center.z);
    }
    if (options.shown.key) {
      drawn.list.captions.meters = meters_of(options, scene);
      drawn.list.captions.north = drawn.list.captions.meters > 0;
    }
    keep_seen_entries(drawn.list.captions.key, camera, options.size, scene);
    return std::pair(std::move(drawn), aimed);
  });
}

/// Draws and reads in parts, so that a software driver can be interrupted, too.
Picture draw_image(const RenderOptions& options, const DrawList& list, const Camera& camera,
                   GlRenderer& renderer, const command::Console& console) {
  return console.run("drawing " + options.output, [&](const Limits& limits) {
    renderer.watch(limits);
    renderer.draw(list, camera, options.size,
                  // What is cut away would still cast its shadow.
                  {.samples = options.samples, .shadows = !options.no_shadow && camera.cut == 0});
    Picture picture = renderer.read_pixels();
    renderer.watch({});
    return picture;
  });
}

}  // namespace

Size parse_picture_size(const std::string& text) {
  Size size;
  const std::size_t cross = text.find('x');
  const auto read = [&](std::size_t from, std::size_t to, int& side) {
    const char* const end = text.data() + to;
    const auto result = std::from_chars(text.data() + from, end, side);
    return result.ec == std::errc{} && result.ptr == end && side >= 1 && side <= kMostImageSide;
  };
  if (cross == std::string::npos || !read(0, cross, size.width) ||
      !read(cross + 1, text.size(), size.height)) {
    throw Error(ErrorKind::usage, "--size " + text,
                "give width and height in pixels from 1 to 16384, such as 1920x1080");
  }
  return size;
}

command::Action add_render(command::Parser& parser, command::Shared&) {
  const auto options = std::make_shared<RenderOptions>();
  command::add_world_options(parser, options->world);
  describe_count(parser);
  add_picture_options(parser, *options);
  add_content_options(parser, *options);
  parser.footer(kRenderFooter);
  return [options, &parser](command::Console& console) {
    check_ray_picture(parser, *options);
    check_effects(parser, *options);
    // The descent with which the options start is for who names no traversal: a named one has its
    // own, as in `overlap`.
    if (parser.count("--traversal") > 0 && parser.count("--descent") == 0) {
      options->shown.trees.traversal.descent = TraversalOptions{}.descent;
    }
    options->shown.trees.traversal = without_idle(options->shown.trees.traversal);
    return run_render(*options, console);
  };
}

int run_render(const RenderOptions& given, command::Console& console) {
  RenderOptions options = given;
  const std::uint64_t most = console.shared().max_memory;
  const bool by_rays = is_ray_picture(options);
  if (!by_rays && most != 0 && most < kLeastMemory) {
    throw Error(ErrorKind::out_of_memory, "--max-memory: drawing needs at least 256M",
                "raise the limit, or leave it out");
  }
  if (options.output == "-" && console.shared().json) {
    throw Error(ErrorKind::usage, "--json and the picture cannot both go to standard output",
                "write the picture to a file");
  }
  if (options.output != "-") {
    if (options.visible_from) {
      command::check_extension("--output", options.output, {".png", ".svg", ".npy", ".asc"});
    } else {
      command::check_extension("--output", options.output,
                               options.depth ? std::vector<std::string_view>{".png", ".npy"}
                                             : std::vector<std::string_view>{".png"});
    }
  }
  // What may be missing is checked first, before models are read for minutes.
  std::optional<HeadlessContext> context;
  std::optional<GlRenderer> renderer;
  if (!by_rays) {
    context.emplace();
    renderer.emplace();
  }
  command::OutputFile file(options.output);
  Moment moment = make_scene(options, console);
  ViewScene& scene = moment.scene;
  if (options.frame.value_or(0) > 0 && stands_still(options, scene)) {
    const bool posed = !options.pose.empty();
    throw Error(ErrorKind::usage,
                fmt::format("--frame {} has no effect: {}", *options.frame,
                            posed ? "--pose draws the mover at every pose, in one picture"
                                  : "nothing moves here"),
                posed ? "leave it out, or give the poses as --route" : "leave it out");
  }
  options.camera.subject = chosen_subject(options, scene);
  if (by_rays) {
    write_ray_picture(options, scene, file, console);
    return 0;
  }
  remark_what_is_left_out(options, scene, console);
  const auto [drawn, aimed] = compose(options, scene, console);
  remark_cut(options, aimed.camera, console);
  const Picture picture = draw_image(options, drawn.list, aimed.camera, *renderer, console);
  file.stream() << console.run("writing " + options.output,
                               [&](const Limits& limits) { return to_png(picture, limits); });
  file.commit();
  for (const std::string& line : left_out(drawn.counts)) {
    console.note(options.output + ": " + line);
  }
  report(options, moment, aimed, renderer->statistics(), console);
  return 0;
}

}  // namespace soms::view
