#include "reports/memory_trace.h"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "tests/support/expect_input_error.h"

namespace wedgesim::reports {
namespace {

using model::memory::Cause;
using model::memory::MemoryRecord;
using model::memory::Surface;

/// A wedge record fetched, a line of z filled, a line of LI put out.
std::vector<MemoryRecord> records() {
  return {{.cycle = 0,
           .client = Surface::wedges,
           .address = 0x1000,
           .bytes = 128,
           .wedge = 7,
           .cause = Cause::fetch},
          {.cycle = 81,
           .client = Surface::z,
           .address = 0x400180,
           .bytes = 64,
           .tile = 12,
           .wedge = 7,
           .cause = Cause::fill},
          {.cycle = 81,
           .client = Surface::li,
           .write = true,
           .address = 0x123456789C0,
           .bytes = 64,
           .tile = 3,
           .cause = Cause::write_back}};
}

struct Written {
  std::string text;
  std::uint64_t bytes = 0;
};

Written written(const MemoryTraceOptions& options,
                const std::vector<MemoryRecord>& from = records()) {
  std::ostringstream out;
  MemoryTraceWriter writer(out, options);
  for (const MemoryRecord& record : from) writer.write(record);
  return {out.str(), writer.bytes()};
}

TEST(MemoryTrace, OwnFormatHasEveryField) {
  const Written trace = written({.block_mhz = 800, .configuration = "c0ffee", .trace = "1234"});
  EXPECT_EQ(trace.text,
            "# wedgesim memory trace, schema 1\n"
            "# block_mhz 800\n"
            "# configuration c0ffee\n"
            "# trace 1234\n"
            "cycle,client,op,addr,bytes,tile,wedge,cause\n"
            "0,wedges,read,0x1000,128,,7,fetch\n"
            "81,z,read,0x400180,64,12,7,fill\n"
            "81,li,write,0x123456789c0,64,3,,write_back\n");
  EXPECT_EQ(trace.bytes, 256U);
}

TEST(MemoryTrace, DramSysHasSizesAndTheBlocksCycles) {
  const Written trace = written({.format = MemoryTraceFormat::dramsys, .block_mhz = 800});
  EXPECT_EQ(trace.text,
            "# player clock: 800 MHz\n"
            "0: (128) read 0x1000\n"
            "81: (64) read 0x400180\n"
            "81: (64) write 0x123456789c0\n");
  EXPECT_EQ(trace.bytes, 256U);
}

TEST(MemoryTrace, DramSim3CountsItsOwnClockAndEqualRequests) {
  // Cycle 81 at 500 MHz is 162 ns: 259.2 cycles of 1600 MHz, so 260.
  const Written trace =
      written({.format = MemoryTraceFormat::dramsim3, .block_mhz = 500, .memory_mhz = 1600});
  EXPECT_EQ(trace.text,
            "0x1000 READ 0\n"
            "0x1040 READ 0\n"
            "0x400180 READ 260\n"
            "0x123456789C0 WRITE 260\n");
  EXPECT_EQ(trace.bytes, 256U);
}

TEST(MemoryTrace, RamulatorHasNeitherTimesNorSizes) {
  const Written trace =
      written({.format = MemoryTraceFormat::ramulator, .request_bytes = 32}, {records()[1]});
  EXPECT_EQ(trace.text,
            "LD 0x400180\n"
            "LD 0x4001a0\n");
  EXPECT_EQ(trace.bytes, 64U);
  EXPECT_EQ(written({.format = MemoryTraceFormat::ramulator}, {records()[2]}).text,
            "ST 0x123456789c0\n");
}

TEST(MemoryTrace, PartOfARequestIsAWholeOne) {
  const MemoryRecord two{.address = 0x3E, .bytes = 4};  // its bytes lie in two requests
  const Written trace = written({.format = MemoryTraceFormat::ramulator}, {two});
  EXPECT_EQ(trace.text,
            "LD 0x0\n"
            "LD 0x40\n");
  EXPECT_EQ(trace.bytes, 128U);
}

TEST(MemoryTrace, RecordsComeInTheOrderOfTime) {
  std::ostringstream out;
  MemoryTraceWriter writer(out, {});
  writer.write({.cycle = 5});
  EXPECT_THROW(writer.write({.cycle = 4}), CheckError);
}

TEST(MemoryTrace, OptionsAreChecked) {
  const auto error = [](const MemoryTraceOptions& options) {
    return input_error_of([&] { written(options); });
  };
  EXPECT_EQ(error({.block_mhz = 0}),
            "memory trace: 'block_mhz' is 0; expected an integer from 1 to 10000");
  EXPECT_EQ(error({.memory_mhz = 20000}),
            "memory trace: 'memory_mhz' is 20000; expected an integer from 1 to 10000");
  EXPECT_EQ(error({.request_bytes = 48}),
            "memory trace: 'request_bytes' is 48; expected a power of two from 8 to 4096");
  EXPECT_EQ(memory_trace_format("dramsys", "--memory-trace"), MemoryTraceFormat::dramsys);
  EXPECT_EQ(input_error_of([] { memory_trace_format("stl", "--memory-trace"); }),
            "--memory-trace: unknown value 'stl'; expected one of csv, dramsys, dramsim3, "
            "ramulator");
}

}  // namespace
}  // namespace wedgesim::reports
