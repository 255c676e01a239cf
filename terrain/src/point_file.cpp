#include "point_file.h"

#include <dbd/core/error.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

namespace dbd {
namespace {

[[noreturn]] void Fail(const std::string& file, const std::string& what) {
  throw InputError(file + ": " + what);
}

std::ifstream Open(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) Fail(file, "no such file, or it cannot be read");
  return stream;
}

bool IsSeparator(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r'; }

std::optional<Eigen::Vector3d> ParsePoint(const std::string& line) {
  Eigen::Vector3d point;
  const char* at = line.data();
  const char* const end = at + line.size();
  for (int i = 0; i < 3; ++i) {
    while (at != end && IsSeparator(*at)) ++at;
    const auto [stop, error] = std::from_chars(at, end, point[i]);
    if (error != std::errc() || (stop != end && !IsSeparator(*stop))) return std::nullopt;
    at = stop;
  }
  return point.allFinite() ? std::optional(point) : std::nullopt;
}

// A little-endian value in a LAS header.
template <typename Value>
Value At(const std::array<char, 375>& header, std::size_t offset) {
  Value value;
  std::memcpy(&value, header.data() + offset, sizeof value);
  return value;
}

}  // namespace

std::vector<Eigen::Vector3d> ReadXyz(const std::string& file) {
  std::ifstream stream = Open(file);
  std::vector<Eigen::Vector3d> points;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    if (const auto point = ParsePoint(line)) {
      points.push_back(*point);
    } else if (number > 1) {
      Fail(file, "line " + std::to_string(number) + " has no three numbers x y z");
    }
  }
  if (points.empty()) Fail(file, "holds no points x y z");
  return points;
}

PointFileInfo ReadPcdHeader(const std::string& file) {
  std::ifstream stream = Open(file);
  std::string line;
  constexpr int kLongestHeader = 64;
  for (int i = 0; i < kLongestHeader && std::getline(stream, line); ++i) {
    std::istringstream words(line.substr(0, 1000));
    std::string key;
    words >> key;
    if (key != "POINTS") continue;
    PointFileInfo info;
    if (words >> info.points) return info;
  }
  Fail(file, "is not a PCD file: it has no header line POINTS");
}

// Public header block of the LAS 1.4 specification (ASPRS, table 3): the legacy number of points
// stands at byte 107, the extent as max x, min x, max y, ... from 179, the 1.4 number at 247.
PointFileInfo ReadLasHeader(const std::string& file) {
  std::ifstream stream = Open(file);
  std::array<char, 375> header = {};
  stream.read(header.data(), header.size());
  constexpr std::streamsize kShortestHeader = 227;
  if (stream.gcount() < kShortestHeader || std::memcmp(header.data(), "LASF", 4) != 0) {
    Fail(file, "is not a LAS or LAZ file");
  }
  PointFileInfo info;
  info.points = At<std::uint32_t>(header, 107);
  if (header[25] >= 4 && info.points == 0) info.points = At<std::uint64_t>(header, 247);
  for (int axis = 0; axis < 3; ++axis) {
    info.extent.high[axis] = At<double>(header, 179 + 16 * static_cast<std::size_t>(axis));
    info.extent.low[axis] = At<double>(header, 187 + 16 * static_cast<std::size_t>(axis));
  }
  if (!info.extent.low.allFinite() || !info.extent.high.allFinite()) {
    Fail(file, "is corrupt: its extent is not finite");
  }
  return info;
}

}  // namespace dbd
