#include "text.h"

#include <dbd/core/error.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <fstream>

namespace dbd {

std::string Format(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string text(static_cast<std::size_t>(length), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  return text;
}

std::string OneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string HashText(std::uint64_t hash) {
  return Format("%016llx", static_cast<unsigned long long>(hash));
}

std::string FormatDuration(double seconds) {
  if (seconds < 59.95) return Format("%.1f s", seconds);
  const long whole = std::lround(seconds);
  return Format("%ld min %02ld s", whole / 60, whole % 60);
}

std::string FormatLength(double meters) {
  return meters < 999.5 ? Format("%.0f m", meters) : Format("%.2f km", meters / 1000);
}

void WriteTextFile(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw InputError(file.string() + ": cannot be written");
}

}  // namespace dbd
