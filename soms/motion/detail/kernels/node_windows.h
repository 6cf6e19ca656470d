// Windows of times of pairs of boxes. Included after wide_vectors.h, once for each instruction set.

/// kDoubles boxes of x, from lane `first` on, beside one of y.
class BoxMeeting {
 public:
  BoxMeeting(const SweptBoxes& x, std::size_t first, const SweptBoxes& y, double margin)
      : x_(x),
        y_(y),
        center_(x.center, first),
        change_(x.change, first),
        half_(x.half, first),
        reach_(from_row(x.give, first) + WideDouble(margin)) {}

  /// Narrows the windows with all lanes of y along a direction.
  void look_along(const Vec3& n) {
    const WideVec3 direction(n);
    const WideSpeed speed(along(direction, change_));
    const WideDouble middle = along(direction, center_);
    const WideDouble radius = along(WideVec3(share_of(n, x_)), half_) + reach_;
    const Vec3 share_y = share_of(n, y_);
    for (std::size_t j = 0; j < y_.count; ++j) {
      window_[j].narrow(WideDouble(dot(n, lane_of(y_.center, j))) - middle, speed,
                        radius + WideDouble(dot(share_y, lane_of(y_.half, j))));
    }
  }

  [[nodiscard]] bool any_open() const {
    std::uint32_t open = 0;
    for (std::size_t j = 0; j < y_.count; ++j) {
      open |= window_[j].open();
    }
    return open != 0;
  }

  void store(std::size_t first, WindowsOfPairs& windows) const {
    for (std::size_t j = 0; j < y_.count; ++j) {
      put(window_[j].lower, first, windows.lower[j]);
      put(window_[j].upper, first, windows.upper[j]);
      windows.open |= window_[j].open() << (SweptBoxes::kLanes * j + first);
    }
  }

 private:
  /// How much of each half side counts along a direction.
  static Vec3 share_of(const Vec3& n, const SweptBoxes& boxes) {
    return {std::abs(dot(n, boxes.axis[0])), std::abs(dot(n, boxes.axis[1])),
            std::abs(dot(n, boxes.axis[2]))};
  }

  const SweptBoxes& x_;
  const SweptBoxes& y_;
  WideVec3 center_;
  WideVec3 change_;
  WideVec3 half_;
  WideDouble reach_;
  std::array<WideWindow, SweptBoxes::kLanes> window_;
};

void meet_nodes(const SweptBoxes& x, const SweptBoxes& y, double margin, WindowsOfPairs& windows) {
  windows.open = 0;
  for (std::size_t first = 0; first < x.count; first += kDoubles) {
    BoxMeeting meeting(x, first, y, margin);
    for (const Vec3& n : y.direction) {
      meeting.look_along(n);
    }
    if (meeting.any_open()) {
      for (const Vec3& n : x.direction) {
        meeting.look_along(n);
      }
      meeting.store(first, windows);
    }
  }
  windows.open &= ((1U << x.count) - 1) * 0x1111U;
}
