// What a journal holds: the headers of the analyses and their points, as bytes and back.
#pragma once

#include "common/result_sink.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vibroimpact {

std::string header_record(const AnalysisHeader &header);
std::string point_record(const std::string &analysis, const PointResult &result);

/// Points of an analysis by their index, which is also the order of the result file.
using PointMap = std::map<std::vector<std::size_t>, PointResult>;

/// Headers in the order the analyses were begun. A journal that another version of the program
/// wrote in another format is a std::runtime_error that names it.
std::vector<AnalysisHeader> read_headers(const std::vector<std::filesystem::path> &journals);
/// All points of one analysis; of a point that is there twice, the first.
PointMap read_points(const std::vector<std::filesystem::path> &journals,
                     const std::string &analysis);

} // namespace vibroimpact
