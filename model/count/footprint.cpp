#include "model/count/footprint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace wedgesim::model {
namespace {

// The pixels of 8 row spans within the block at bx.
std::uint64_t block_bits(const Span* spans, int first_x) {
  std::uint64_t bits = 0;
  for (int row = 0; row < kBlock; ++row) {
    const int begin = std::max(spans[row].begin - first_x, 0);
    const int end = std::min(spans[row].end - first_x, kBlock);
    if (begin >= end) continue;
    bits |= std::uint64_t{(1U << end) - (1U << begin)} << (kBlock * row);
  }
  return bits;
}

void fill_spans(const Outline& outline, const ZFrame& frame, int first_y, Span* spans) {
  for (int row = 0; row < kBlock; ++row) {
    const int y = first_y + row;
    const bool possible = y >= outline.row_begin() && y < outline.row_end() && y < frame.height();
    spans[row] = possible ? outline.row(y, frame.width()) : Span{};
  }
}

}  // namespace

void Footprint::build(const Primitive& primitive, const ZFrame& frame, int band,
                      const Kernel& kernel, double one) {
  face_count_ = primitive.faces.size();
  find_blocks(primitive, frame, band);
  test_pixels(primitive, kernel);
  evaluate_words(primitive, kernel, one);
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
  spans_.resize((face_count_ + 1) * kBlock);
  std::fill(spans_.begin(), spans_.end(), Span{});
  for (std::size_t i = 0; i < face_count_; ++i) {
    fill_spans(primitive.faces[i].outline, frame, by * kBlock, &spans_[i * kBlock]);
  }
  Span* umbra_spans = &spans_[face_count_ * kBlock];
  if (primitive.polygon) {
    fill_spans(primitive.polygon->outline, frame, by * kBlock, umbra_spans);
  }
  int begin = frame.width();
  int end = 0;
  for (const Span& span : spans_) {
    if (span.begin == span.end) continue;
    begin = std::min(begin, span.begin);
    end = std::max(end, span.end);
  }
  for (int x = begin / kBlock * kBlock; x < end; x += kBlock) {
    std::uint64_t outline = 0;
    const std::size_t first_face = faces_.size();
    for (std::size_t i = 0; i < face_count_; ++i) {
      faces_.push_back(block_bits(&spans_[i * kBlock], x));
      outline |= faces_.back();
    }
    const std::uint64_t umbra = primitive.polygon ? block_bits(umbra_spans, x) : 0;
    if ((outline | umbra) == 0) {
      faces_.resize(first_face);
      continue;
    }
    const auto bx = static_cast<std::uint32_t>(x / kBlock);
    const auto block_y = static_cast<std::uint32_t>(by);
    blocks_.push_back({bx, block_y, frame.z_of(frame.block(bx, block_y))});
    outline_.push_back(outline);
    umbra_.push_back(umbra);
  }
}

void Footprint::test_pixels(const Primitive& primitive, const Kernel& kernel) {
  const std::size_t n = blocks_.size();
  inside_.assign(n, 0);
  inner_.assign(n, 0);
  hits_.assign(n, 0);
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
    inner_[i] = bits.inner;
    if (!polygon) continue;
    // The one predicate: at pixels the polygon covers, z outside its interval decides first.
    const std::uint64_t outside = umbra_[i] & (bits.before | bits.beyond);
    inner_[i] =
        (bits.inner & ~outside) | (outside & (polygon->eye_facing ? bits.beyond : bits.before));
    hits_[i] = umbra_[i] & (polygon->hits_inner ? inner_[i] : ~inner_[i]);
  }
}

void Footprint::evaluate_words(const Primitive& primitive, const Kernel& kernel, double one) {
  first_word_.clear();
  std::size_t count = 0;
  for (std::uint64_t inside : inside_) {
    first_word_.push_back(count);
    count += static_cast<std::size_t>(std::popcount(inside));
  }
  first_word_.push_back(count);
  words_.resize(count);
  if (count == 0) return;
  kernel.words(primitive.terms, one, blocks_, inside_.data(), words_.data());
  if (!primitive.coverage) return;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    std::int64_t* word = words_.data() + first_word_[i];
    for_each_bit(inside_[i], [&](int bit) {
      if ((inner_[i] >> bit & 1) == 0) *word = -*word;
      ++word;
    });
  }
}

}  // namespace wedgesim::model
