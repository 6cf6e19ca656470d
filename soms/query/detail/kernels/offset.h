// Included inside a namespace, after its F4.

/// `PoseNumbers::offset`; the fourth lane is zero.
inline F4 offset_of(const PoseNumbers& pose, const std::array<double, 3>& x,
                    const std::array<double, 3>& y) {
  const std::array<float, 3> d = pose.offset(x, y);
  const std::array<float, 4> row{d[0], d[1], d[2], 0};
  return F4::load(row.data());
}

/// `LineView::at`.
inline F4 seen_from(const LineView& view, const std::array<double, 3>& origin) {
  return F4::load(view.at(origin).data());
}
