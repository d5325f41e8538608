#pragma once

#include <string>
#include <vector>

#include "reports/page/page.h"
#include "reports/runner/results.h"

namespace wedgesim::tests {

/// Made-up results, alike in every run: numbers follow simple formulas, so that tests know what the
/// page must say of them.

/// Counted: 3 scenes of 2 views, both modes, tiles 2 to 256, three cullings. In frame f (from 0)
///   z_reads   1000 (f + 10) (tile + 16) / (single-pass ? 20 : 18) (none ? 4 : zmax ? 2 : 1)
///   all_bytes 4 z_reads + 40000 (f + 10) (8 / tile + tile / 8)
/// so tile 8 has the fewest bytes in most frames and single-pass 10 % fewer reads everywhere.
reports::Results counted_results();

/// In time: both modes, tiles 4 to 32, two memories, three sizes of the z cache, three resolutions;
/// cycles grow with the pixels to the power 1.
reports::Results timed_results();

/// Widths of two formats; from 14 bits on no pixel is wrong.
reports::Results precision_results();

/// Counted results of `points` points in `frames` frames, all of them with 80 settings.
reports::Results large_results(std::size_t points);

/// Names that would break a page which does not escape them.
reports::Results hostile_results();

/// Grey pictures for frames of counted_results(), a different one for each tile size.
std::vector<reports::page::HeatMap> sample_maps(const reports::Results& results);

}  // namespace wedgesim::tests
