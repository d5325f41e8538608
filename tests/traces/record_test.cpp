#include "traces/record.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/traces/sample.h"

namespace wedgesim::traces {
namespace {

// wedges[0] of the sample:
//   the wedge                                176
//   3 planes of 32                            96
//   face 0: 32, its 3 indices of 4            44
//   face 1: 32, its 3 indices of 4            44
//   umbra polygon: 40, its 3 indices of 4     52
//   faces name vertices 0 1 2 and 0 2 3, the umbra polygon 1 2 3: 4 distinct of 16   64
//                                            476
TEST(Record, WedgeWithUmbraPolygon) {
  const Trace trace = sample_trace();
  EXPECT_EQ(wedge_record_bytes(trace.view(), 0), 476U);
}

// wedges[1]: 176 + 4 planes 128 + one face of 4 indices 48 + 4 vertices 64; no umbra polygon.
TEST(Record, WedgeWithoutUmbraPolygon) {
  const Trace trace = sample_trace();
  EXPECT_EQ(wedge_record_bytes(trace.view(), 1), 416U);
}

TEST(Record, VerticesCountOnce) {
  Trace trace = sample_trace();
  trace.indices[3] = trace.indices[4] = trace.indices[5] = 0;
  trace.indices[6] = trace.indices[7] = trace.indices[8] = 1;
  EXPECT_EQ(wedge_record_bytes(trace.view(), 0), 476U - 16U);
}

TEST(Record, WedgeOutOfRange) {
  const Trace trace = sample_trace();
  EXPECT_THROW(wedge_record_bytes(trace.view(), 2), CheckError);
}

}  // namespace
}  // namespace wedgesim::traces
