// Compiled once for every instruction set (Highway); all give the same bits.
#include "functional/methods/ssv_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "functional/methods/ssv_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "functional/light/coverage_simd.h"
#include "functional/light/linear_simd.h"
#include "functional/raster/volume_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

void draw_hard(const VolumeFrame& frame, VolumeRow& row) { draw_row_by(NoShare(), frame, row); }
void draw_rectangle(const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(RectangleShare(), frame, row);
}
void draw_sphere(const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(SphereShare(), frame, row);
}
void draw_entry_exit(bool cubic, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(EntryExitShare{cubic}, frame, row);
}
void draw_restructured(bool cubic, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(RestructuredShare{cubic}, frame, row);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wedgesim::functional {

namespace {
HWY_EXPORT(draw_hard);
HWY_EXPORT(draw_rectangle);
HWY_EXPORT(draw_sphere);
HWY_EXPORT(draw_entry_exit);
HWY_EXPORT(draw_restructured);
}  // namespace

DrawRow hard_kernel() {
  return [](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_hard)(frame, row);
  };
}

DrawRow coverage_kernel(LightShape shape) {
  switch (shape) {
    case LightShape::rectangle:
      return [](const VolumeFrame& frame, VolumeRow& row) {
        HWY_DYNAMIC_DISPATCH(draw_rectangle)(frame, row);
      };
    case LightShape::sphere:
      return [](const VolumeFrame& frame, VolumeRow& row) {
        HWY_DYNAMIC_DISPATCH(draw_sphere)(frame, row);
      };
    case LightShape::point:
      break;
  }
  return hard_kernel();
}

DrawRow entry_exit_kernel(bool cubic) {
  return [cubic](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_entry_exit)(cubic, frame, row);
  };
}

DrawRow restructured_kernel(bool cubic) {
  return [cubic](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_restructured)(cubic, frame, row);
  };
}

}  // namespace wedgesim::functional
#endif  // HWY_ONCE
