#pragma once

namespace wedgesim {

/// The longest edge of a frame, in pixels, that scenes may ask for and traces may hold.
inline constexpr int kMaxFrameEdge = 16384;

}  // namespace wedgesim
