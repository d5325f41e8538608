#include "functional/reference/judge_view.h"

namespace wedgesim::functional {

namespace fb = traces::fb;

Real judged_depth(fb::DepthFormat format, std::uint32_t word) {
  switch (format) {
    case fb::DepthFormat_unorm24:
      return Real(word) / 16777215;
    case fb::DepthFormat_unorm16:
      return Real(word) / 65535;
    case fb::DepthFormat_float32:
      return Real(std::bit_cast<float>(word));
    case fb::DepthFormat_float32_reversed:
      return 1 - Real(std::bit_cast<float>(word));
  }
  return 0;
}

JudgedView::JudgedView(const Camera& camera, int width, int height)
    : width_(width),
      eye_(camera.eye),
      near_(camera.near_plane),
      far_(camera.far_plane),
      half_width_(Real(width) / 2),
      half_height_(Real(height) / 2) {
  const RealVector view = RealVector(camera.target) - eye_;
  forward_ = unit(view);
  right_ = unit(cross(view, RealVector(camera.up)));
  down_ = cross(forward_, right_);
  const Real pi = acos(Real(-1));
  const Real half_angle = Real(camera.field_of_view_degrees) * pi / 360;
  pixels_per_unit_ = half_height_ / tan(half_angle);
}

RealVector JudgedView::from_eye(std::size_t pixel, const Real& z) const {
  const auto width = static_cast<std::size_t>(width_);
  const Real x = Real(pixel % width) + 0.5 - half_width_;
  const Real y = Real(pixel / width) + 0.5 - half_height_;
  const Real along = near_ * far_ / (far_ * (1 - z) + near_ * z);
  const RealVector direction =
      forward_ + Real(x / pixels_per_unit_) * right_ + Real(y / pixels_per_unit_) * down_;
  return along * direction;
}

}  // namespace wedgesim::functional
