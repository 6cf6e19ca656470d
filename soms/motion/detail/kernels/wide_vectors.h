// Vectors and windows of times side by side, for any kind of lanes WideDouble. Included inside a
// namespace, after lanes_double.h and a function `root`, once for each instruction set.

inline WideDouble operator/(const WideDouble& a, const WideDouble& b) {
  return WideDouble(a.v / b.v);
}

template <class Row>
WideDouble from_row(const Row& row, std::size_t first) {
  WideDouble lanes;
  std::memcpy(&lanes.v, row.data() + first, sizeof lanes.v);
  return lanes;
}

template <class Row>
void put(const WideDouble& lanes, std::size_t first, Row& row) {
  std::memcpy(row.data() + first, &lanes.v, sizeof lanes.v);
}

/// Vectors side by side.
struct WideVec3 {
  WideDouble x;
  WideDouble y;
  WideDouble z;

  WideVec3() = default;

  WideVec3(const WideDouble& a, const WideDouble& b, const WideDouble& c) : x(a), y(b), z(c) {}

  explicit WideVec3(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}

  template <class Vectors>
  WideVec3(const Vectors& rows, std::size_t first)
      : x(from_row(rows[0], first)), y(from_row(rows[1], first)), z(from_row(rows[2], first)) {}

  void store(std::size_t first, TriangleLanes::Vectors& rows) const {
    put(x, first, rows[0]);
    put(y, first, rows[1]);
    put(z, first, rows[2]);
  }
};

inline WideVec3 operator+(const WideVec3& a, const WideVec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline WideVec3 operator-(const WideVec3& a, const WideVec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline WideVec3 operator*(const WideVec3& a, const WideDouble& s) {
  return {a.x * s, a.y * s, a.z * s};
}

inline WideDouble along(const WideVec3& a, const WideVec3& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

inline WideVec3 across(const WideVec3& a, const WideVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// At least the length of a vector, but for 8 u of it. Where squares may be too small for a double,
/// the sum of its magnitudes.
inline WideDouble length_at_least(const WideVec3& v) {
  const WideDouble squared = along(v, v);
  return select(squared > WideDouble(0x1p-900), root(squared), (abs(v.x) + abs(v.y)) + abs(v.z));
}

/// As `direction_of`, to 2^-50.
inline WideVec3 unit_of(const WideVec3& v) {
  // Those that are short are first made longer.
  const WideDouble most = max(max(abs(v.x), abs(v.y)), abs(v.z));
  const WideDouble one(1.0);
  const WideVec3 u = v * select(most > WideDouble(0x1p-400), one, WideDouble(0x1p600));
  const MaskDouble some = most > WideDouble(0x1p-1000);
  const WideDouble length = root(select(some, along(u, u), one));
  return u * select(some, one / length, WideDouble(0.0));
}

inline WideVec3 turned_lanes(const Pose& map, const WideVec3& v) {
  const auto& m = map.m;
  const auto row = [&](std::size_t i) {
    return (WideDouble(m[i]) * v.x + WideDouble(m[i + 1]) * v.y) + WideDouble(m[i + 2]) * v.z;
  };
  return {row(0), row(4), row(8)};
}

inline WideVec3 mapped_lanes(const Pose& map, const WideVec3& v) {
  return turned_lanes(map, v) + WideVec3(map.shift());
}

/// One lane in all of them.
template <class Vectors>
WideVec3 everywhere(const Vectors& rows, std::size_t lane) {
  return WideVec3(Vec3{rows[0][lane], rows[1][lane], rows[2][lane]});
}

/// Speeds along a direction, from the middle of a stretch to its end.
struct WideSpeed {
  WideDouble magnitude;
  MaskDouble moves;  ///< what hardly moves counts as one that may be anywhere on its way
  WideDouble inverse;

  explicit WideSpeed(const WideDouble& w)
      : magnitude(abs(w)),
        moves(magnitude > WideDouble(0x1p-1000)),
        inverse(WideDouble(1.0) / select(moves, w, WideDouble(1.0))) {}
};

/// As TimeWindow, side by side.
struct WideWindow {
  WideDouble lower{-1.0};
  WideDouble upper{1.0};

  /// Leaves the times s with |p - s w| <= r, and the next ones, w the speed.
  void narrow(const WideDouble& p, const WideSpeed& w, const WideDouble& r) {
    const WideDouble a = (p - r) * w.inverse;
    const WideDouble b = (p + r) * w.inverse;
    const MaskDouble apart = abs(p) > r + w.magnitude;
    const WideDouble begin = min(a, b) - WideDouble(kWindowMargin);
    const WideDouble end = max(a, b) + WideDouble(kWindowMargin);
    lower = max(lower, select(w.moves, begin, WideDouble(-1.0)));
    upper = select(apart, WideDouble(-2.0), min(upper, select(w.moves, end, WideDouble(1.0))));
  }

  /// Lanes whose windows are not empty.
  [[nodiscard]] std::uint32_t open() const { return ~bits(lower > upper) & ((1U << kDoubles) - 1); }
};

/// Middle and half length of what a direction sees.
struct WideSpan {
  WideDouble middle;
  WideDouble radius;

  /// Of two places.
  WideSpan(const WideDouble& a, const WideDouble& b)
      : middle((a + b) * WideDouble(0.5)), radius(abs(a - b) * WideDouble(0.5)) {}

  WideSpan(const WideDouble& a, const WideDouble& b, const WideDouble& c)
      : WideSpan(min(min(a, b), c), max(max(a, b), c)) {}

  WideSpan(const WideVec3& n, const std::array<WideVec3, 3>& corners)
      : WideSpan(along(n, corners[0]), along(n, corners[1]), along(n, corners[2])) {}
};
