#pragma once

#include <string>
#include <vector>

#include "reports/accuracy/measure.h"
#include "reports/page/row_charts.h"

namespace wedgesim::reports::accuracy {

/// The names of the methods that were measured, in the order of all methods: the charts' series.
std::vector<std::string> method_names(const std::vector<SceneResult>& results);

/// RMSE on receivers over run time on all threads: a mark for each choice, its front as a line.
/// \param label    of the scene among all, for the chart's id
/// \param methods  method_names
page::RowChart time_chart(const SceneResult& result, const std::string& label,
                          const std::vector<std::string>& methods);
/// The same over the bytes of all accesses.
page::RowChart bytes_chart(const SceneResult& result, const std::string& label,
                           const std::vector<std::string>& methods);

/// "0.0123", "4.5e-5": an error as people write it.
std::string error_text(double error);
/// "1.23 ms"
std::string time_text(double seconds);
/// "1.23 MB"
std::string bytes_text(double bytes);

}  // namespace wedgesim::reports::accuracy
