#include "model/count/footprint.h"

#include <algorithm>
#include <array>
#include <limits>

namespace wedgesim::model {
namespace {

// The pixels of a polygon's 8 row spans within the block at first_x, which its rim crosses.
std::uint64_t rim_bits(const Footprint::SpanRows& rows, int first_x) {
  // kFrom[i]: the pixels of a row from i on.
  static constexpr std::array<std::uint8_t, kBlock + 1> kFrom{0xff, 0xfe, 0xfc, 0xf8, 0xf0,
                                                              0xe0, 0xc0, 0x80, 0x00};
  std::array<std::uint64_t, 2> bits{};
  for (std::size_t row = 0; row < kBlock; ++row) {
    const auto begin =
        static_cast<std::size_t>(std::clamp(rows.spans[row].begin - first_x, 0, kBlock));
    const auto end = static_cast<std::size_t>(std::clamp(rows.spans[row].end - first_x, 0, kBlock));
    bits[row % 2] |= std::uint64_t(kFrom[begin] ^ kFrom[end]) << (kBlock * row);
  }
  return bits[0] | bits[1];
}

// The pixels of a polygon's 8 row spans within the block at first_x.
inline std::uint64_t block_bits(const Footprint::SpanRows& rows, int first_x) {
  if (first_x + kBlock <= rows.any_begin || first_x >= rows.any_end) return 0;
  if (first_x >= rows.all_begin && first_x + kBlock <= rows.all_end) return ~std::uint64_t{0};
  return rim_bits(rows, first_x);
}

Footprint::SpanRows span_rows(const Outline& outline, const ZFrame& frame, int first_y) {
  Footprint::SpanRows rows;
  rows.spans = outline.rows(first_y, frame.width(), frame.height());
  rows.any_begin = rows.all_end = frame.width();
  for (const Span& span : rows.spans) {
    rows.all_begin = std::max(rows.all_begin, span.begin);
    rows.all_end = std::min(rows.all_end, span.end);
    rows.any_begin = std::min(rows.any_begin, span.begin < span.end ? span.begin : frame.width());
    rows.any_end = std::max(rows.any_end, span.end);
  }
  return rows;
}

}  // namespace

void Footprint::build(const Primitive& primitive, const ZFrame& frame, int band,
                      const Kernel& kernel) {
  face_count_ = primitive.faces.size();
  find_blocks(primitive, frame, band);
  test_pixels(primitive, kernel);
}

void Footprint::find_blocks(const Primitive& primitive, const ZFrame& frame, int band) {
  blocks_.clear();
  faces_.clear();
  outline_.clear();
  umbra_.clear();
  row_begin_.clear();
  int begin = std::numeric_limits<int>::max();
  int end = std::numeric_limits<int>::min();
  const auto extend = [&](const Outline& outline) {
    begin = std::min(begin, outline.row_begin());
    end = std::max(end, outline.row_end());
  };
  for (const RasterFace& face : primitive.faces) extend(face.outline);
  if (primitive.polygon) extend(primitive.polygon->outline);
  end = std::min(end, frame.height());
  for (int row = 0; row < kRows; ++row) {
    row_begin_.push_back(blocks_.size());
    const int y = band * kBandRows + row * kBlock;
    if (y + kBlock > begin && y < end) add_block_row(primitive, frame, y / kBlock);
  }
  row_begin_.push_back(blocks_.size());
}

void Footprint::add_block_row(const Primitive& primitive, const ZFrame& frame, int by) {
  rows_.clear();
  for (const RasterFace& face : primitive.faces) {
    rows_.push_back(span_rows(face.outline, frame, by * kBlock));
  }
  if (primitive.polygon) {
    rows_.push_back(span_rows(primitive.polygon->outline, frame, by * kBlock));
  }
  int begin = frame.width();
  int end = 0;
  for (const SpanRows& rows : rows_) {
    begin = std::min(begin, rows.any_begin);
    end = std::max(end, rows.any_end);
  }
  for (int x = begin / kBlock * kBlock; x < end; x += kBlock) {
    std::uint64_t outline = 0;
    const std::size_t first_face = faces_.size();
    for (std::size_t i = 0; i < face_count_; ++i) {
      faces_.push_back(block_bits(rows_[i], x));
      outline |= faces_.back();
    }
    const std::uint64_t umbra = primitive.polygon ? block_bits(rows_.back(), x) : 0;
    if ((outline | umbra) == 0) {
      faces_.resize(first_face);
      continue;
    }
    const auto bx = static_cast<std::uint32_t>(x / kBlock);
    const auto block_y = static_cast<std::uint32_t>(by);
    const std::size_t block = frame.block(bx, block_y);
    blocks_.push_back({bx, block_y, frame.z_of(block), frame.interval_of(block)});
    outline_.push_back(outline);
    umbra_.push_back(umbra);
  }
}

void Footprint::test_pixels(const Primitive& primitive, const Kernel& kernel) {
  const std::size_t n = blocks_.size();
  inside_.assign(n, 0);
  hits_.assign(n, 0);
  negated_.assign(n, 0);
  if (primitive.wedge) kernel.inside(primitive, blocks_, outline_.data(), inside_.data());
  if (primitive.polygon && primitive.polygon->cap) {
    hits_ = umbra_;
    return;
  }
  // `inner` matters where the polygon is and, for the sign of coverage, inside the wedge.
  scratch_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    scratch_[i] = umbra_[i] | (primitive.coverage ? inside_[i] : 0);
  }
  umbra_bits_.resize(n);
  const auto& polygon = primitive.polygon;
  kernel.umbra(polygon ? polygon->inner : primitive.inner, polygon ? polygon->z : ZInterval{},
               blocks_, scratch_.data(), umbra_bits_.data());
  for (std::size_t i = 0; i < n; ++i) {
    const UmbraBits& bits = umbra_bits_[i];
    std::uint64_t inner = bits.inner;
    if (polygon) {
      // The one predicate: at pixels the polygon covers, z outside its interval decides first.
      const std::uint64_t outside = umbra_[i] & (bits.before | bits.beyond);
      inner =
          (bits.inner & ~outside) | (outside & (polygon->eye_facing ? bits.beyond : bits.before));
      hits_[i] = umbra_[i] & (polygon->hits_inner ? inner : ~inner);
    }
    if (primitive.coverage) negated_[i] = ~inner;
  }
}

}  // namespace wedgesim::model
