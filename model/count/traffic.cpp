#include "model/count/traffic.h"

namespace wedgesim::model {

void finish_traffic(Counters& counters, Mode mode, traces::fb::DepthFormat format,
                    std::uint64_t pixels, std::uint64_t merged, const WordBytes& bytes) {
  const bool stencil = mode == Mode::three_pass;
  if (!stencil) merged = 0;
  counters.stencil_reads = counters.stencil_writes.value();
  counters.li_reads = counters.li_writes.value() - counters.stencil_writes.value();
  counters.merge_reads = stencil ? pixels + merged : 0;
  counters.merge_writes = merged;
  counters.clear_writes = stencil ? 2 * pixels : pixels;

  const std::uint64_t depth_words =
      counters.z_reads.value() + counters.tile_reads.value() + counters.tile_build_reads.value();
  // To merge, to clear LI, to add penumbra and, without a stencil, umbra.
  const std::uint64_t li_words = 2 * counters.li_reads.value() + 2 * merged + pixels;
  // To add umbra, to merge, to clear.
  const std::uint64_t stencil_words =
      2 * counters.stencil_writes.value() + (stencil ? 2 * pixels : 0);
  counters.all_bytes = depth_words * depth_bytes(format) + li_words * bytes.li +
                       stencil_words * bytes.stencil + counters.wedge_bytes.value();
}

}  // namespace wedgesim::model
