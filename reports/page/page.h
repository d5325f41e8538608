#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/runner/results.h"

namespace wedgesim::reports::page {

/// One picture of a frame under one configuration, small enough to be inside the page.
struct HeatMap {
  std::string frame;     // label of its FrameRow
  std::string mode;      // "single-pass"
  unsigned tile = 0;     // pixels
  std::string kind;      // "z reads"
  std::string png;       // the bytes of a grey PNG: 0 is black, `maximum` white
  double maximum = 0.0;  // accesses of a pixel
  double total = 0.0;    // accesses of the frame
  std::string file;      // the full one, relative to the page; may be empty
};

/// What a pictured frame looks like.
struct FramePicture {
  std::string frame;  // label of its FrameRow
  std::string png;    // the bytes
};

/// A table that others add to the page, with the words around it.
struct Section {
  std::string id, heading, text;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// A file beside the page.
struct Link {
  std::string path;  // relative to the page
  std::string text;  // what it holds
};

/// All that a page is made from.
struct Page {
  const Results& results;
  std::vector<HeatMap> maps;
  std::vector<FramePicture> pictures;
  std::vector<Section> sections;
  std::vector<Link> downloads;
};

/// The page as one HTML file that needs no other: text, data, scripts, styles.
/// The same text for the same page. Names from users are shown as they are, whatever they hold.
std::string page_html(const Page& page);

/// Writes page_html, whole or not at all.
/// \throws InputError if the file cannot be written
void write_page(const std::filesystem::path& path, const Page& page);

}  // namespace wedgesim::reports::page
