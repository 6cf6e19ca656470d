// Included inside a namespace, after its F4 and <immintrin.h>.

/// Column k of the pose's rotation times coordinate k of an origin.
inline __m256d column(const PoseNumbers& pose, const std::array<double, 3>& x, std::size_t k) {
  return _mm256_mul_pd(_mm256_load_pd(pose.column[k].data()), _mm256_set1_pd(x[k]));
}

/// `PoseNumbers::offset`; the fourth lane is zero. Eight bytes behind `y` are read and left out:
/// nodes and blocks go on there.
inline F4 offset_of(const PoseNumbers& pose, const std::array<double, 3>& x,
                    const std::array<double, 3>& y) {
  const __m256d rotated =
      _mm256_add_pd(_mm256_add_pd(column(pose, x, 0), column(pose, x, 1)), column(pose, x, 2));
  const __m256d origin_y = _mm256_blend_pd(_mm256_loadu_pd(y.data()), _mm256_setzero_pd(), 8);
  return F4(_mm256_cvtpd_ps(_mm256_mul_pd(
      _mm256_sub_pd(_mm256_add_pd(rotated, _mm256_load_pd(pose.shift.data())), origin_y),
      _mm256_set1_pd(pose.scale))));
}

/// `LineView::at`.
inline F4 seen_from(const LineView& view, const std::array<double, 3>& origin) {
  const auto part = [&](std::size_t k) {
    return _mm256_mul_pd(_mm256_load_pd(view.column[k].data()), _mm256_set1_pd(origin[k]));
  };
  const __m256d turned = _mm256_add_pd(_mm256_add_pd(part(0), part(1)), part(2));
  return F4(_mm256_cvtpd_ps(_mm256_add_pd(_mm256_load_pd(view.shift.data()), turned)));
}
