// Windows of times of triangles. Included after wide_vectors.h, once for each instruction set.
// motion_bounds.h has the proof; what is special here:
//
// A direction need not be of length 1: gaps, speeds and radii along n are those along a direction
// of length 1 times |n|, and so are margins. The root of n.n is off by 8 u of itself. Directions
// are products of vectors of length 1 or zero, so no entry exceeds 1, and 2^-1050 covers products
// that underflow. A direction of length zero leaves all times open.
//
// Edges. Both ends of an edge of length L are at the same place along n = e x f, but for 14 u L: e
// is off by 8 u, each entry of n by 3 u. One of them is looked at. L is at most 4 S, and n is not
// looked at unless it is longer than kLeastSine = 2^-4. For two triangles that is 1792 u S |n|,
// which `box_margin` has room for. Normals may be of slivers: all corners are looked at.

constexpr double kLeastSine = 0x1p-4;

inline void put_sides(const std::array<WideVec3, 3>& corners, std::size_t first,
                      TriangleLanes& lanes) {
  std::array<WideVec3, 3> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = unit_of(corners[(k + 1) % 3] - corners[k]);
    edges[k].store(first, lanes.edge[k]);
    corners[k].store(first, lanes.corner[k]);
  }
  unit_of(across(edges[0], edges[2])).store(first, lanes.normal);
}

void sweep(const MotionInterval& interval, double bow, TriangleLanes& lanes) {
  for (std::size_t first = 0; first < lanes.count; first += kDoubles) {
    std::array<WideVec3, 3> corners;
    std::array<WideVec3, 3> changes;
    for (std::size_t k = 0; k < 3; ++k) {
      const WideVec3 corner(lanes.corner[k], first);
      corners[k] = mapped_lanes(interval.mean, corner);
      changes[k] = mapped_lanes(interval.change, corner);
    }
    const WideVec3 change = (changes[0] + changes[1] + changes[2]) * WideDouble(1.0 / 3);
    WideDouble give(0.0);
    for (const WideVec3& of_corner : changes) {
      give = max(give, length_at_least(of_corner - change));
    }
    put((give + WideDouble(bow)) * WideDouble(kMotionUp), first, lanes.give);
    change.store(first, lanes.change);
    put_sides(corners, first, lanes);
  }
}

void place(const Pose& pose, TriangleLanes& lanes) {
  for (std::size_t first = 0; first < lanes.count; first += kDoubles) {
    std::array<WideVec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mapped_lanes(pose, WideVec3(lanes.corner[k], first));
    }
    put_sides(corners, first, lanes);
  }
  lanes.change = {};
  lanes.give = {};
}

/// Triangles in registers.
struct WideTriangle {
  std::array<WideVec3, 3> corner;
  std::array<WideVec3, 3> edge;
  WideVec3 normal;

  /// \param pick Makes a vector of rows.
  template <class Pick>
  WideTriangle(const TriangleLanes& lanes, const Pick& pick) : normal(pick(lanes.normal)) {
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = pick(lanes.corner[k]);
      edge[k] = pick(lanes.edge[k]);
    }
  }
};

/// kDoubles lanes from `first` on.
inline WideTriangle triangles_from(const TriangleLanes& lanes, std::size_t first) {
  return WideTriangle(lanes,
                      [&](const TriangleLanes::Vectors& rows) { return WideVec3(rows, first); });
}

/// One triangle in all lanes.
inline WideTriangle triangle_everywhere(const TriangleLanes& lanes, std::size_t lane) {
  return WideTriangle(lanes,
                      [&](const TriangleLanes::Vectors& rows) { return everywhere(rows, lane); });
}

/// Windows of kDoubles triangles that move and one that rests.
class TriangleMeeting {
 public:
  TriangleMeeting(const TriangleLanes& x, std::size_t first, const WideTriangle& y, double margin)
      : x_(triangles_from(x, first)),
        y_(y),
        change_(x.change, first),
        reach_(from_row(x.give, first) + WideDouble(margin)) {}

  /// True where some lane is left.
  bool find() {
    along_axes();
    if (window_.open() == 0) {
      return false;
    }
    along_normals();
    for (std::size_t i = 0; i < 3 && window_.open() != 0; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        along_edges(i, j);
      }
    }
    return window_.open() != 0;
  }

  [[nodiscard]] const WideWindow& window() const { return window_; }

 private:
  void narrow(const WideSpan& moving, const WideSpan& resting, const WideDouble& speed,
              const WideDouble& reach) {
    window_.narrow(resting.middle - moving.middle, WideSpeed(speed),
                   resting.radius + moving.radius + reach);
  }

  void along_axes() {
    const auto& a = x_.corner;
    const auto& b = y_.corner;
    narrow({a[0].x, a[1].x, a[2].x}, {b[0].x, b[1].x, b[2].x}, change_.x, reach_);
    narrow({a[0].y, a[1].y, a[2].y}, {b[0].y, b[1].y, b[2].y}, change_.y, reach_);
    narrow({a[0].z, a[1].z, a[2].z}, {b[0].z, b[1].z, b[2].z}, change_.z, reach_);
  }

  void along_normals() {
    along_normal(x_.normal);
    along_normal(y_.normal);
  }

  void along_normal(const WideVec3& n) {
    narrow({n, x_.corner}, {n, y_.corner}, along(n, change_), reach_);
  }

  void along_edges(std::size_t i, std::size_t j) {
    const WideVec3 n = across(x_.edge[i], y_.edge[j]);
    const WideDouble length = root(along(n, n));
    narrow({along(n, x_.corner[i]), along(n, x_.corner[(i + 2) % 3])},
           {along(n, y_.corner[j]), along(n, y_.corner[(j + 2) % 3])}, along(n, change_),
           select(length > WideDouble(kLeastSine), reach_ * length + WideDouble(kTinyMargin),
                  WideDouble(std::numeric_limits<double>::infinity())));
  }

  WideTriangle x_;
  const WideTriangle& y_;
  WideVec3 change_;
  WideDouble reach_;
  WideWindow window_;
};

inline void put_windows(const WideWindow& window, std::size_t first, WindowsOfLanes& windows) {
  put(window.lower, first, windows.lower);
  put(window.upper, first, windows.upper);
  windows.open |= window.open() << first;
}

void meet_triangle(const TriangleLanes& x, const TriangleLanes& y, std::size_t j, double margin,
                   WindowsOfLanes& windows) {
  const WideTriangle resting = triangle_everywhere(y, j);
  windows.open = 0;
  for (std::size_t first = 0; first < x.count; first += kDoubles) {
    TriangleMeeting meeting(x, first, resting, margin);
    if (meeting.find()) {
      put_windows(meeting.window(), first, windows);
    }
  }
  windows.open &= (1U << x.count) - 1;
}

void meet_box(const TriangleLanes& lanes, const SweptBoxes& box, double margin,
              WindowsOfLanes& windows) {
  const WideVec3 center = everywhere(box.center, 0);
  const WideVec3 change_of_box = everywhere(box.change, 0);
  windows.open = 0;
  for (std::size_t first = 0; first < lanes.count; first += kDoubles) {
    const WideTriangle t = triangles_from(lanes, first);
    const WideVec3 change = WideVec3(lanes.change, first) - change_of_box;
    const WideDouble reach = from_row(lanes.give, first) + WideDouble(box.give[0] + margin);
    WideWindow window;
    const auto look = [&](const WideVec3& n, const WideSpan& seen) {
      WideDouble radius = seen.radius + reach;
      for (std::size_t k = 0; k < 3; ++k) {
        radius = radius + abs(along(n, WideVec3(box.axis[k]))) * WideDouble(box.half[k][0]);
      }
      window.narrow(along(n, center) - seen.middle, WideSpeed(along(n, change)), radius);
    };
    look(t.normal, {t.normal, t.corner});
    for (std::size_t k = 0; k < 3 && window.open() != 0; ++k) {
      const WideVec3 n(box.direction[k]);
      look(n, {n, t.corner});
    }
    put_windows(window, first, windows);
  }
  windows.open &= (1U << lanes.count) - 1;
}
