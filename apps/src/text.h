#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace dbd {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string Format(const char* format, ...);

/// Line breaks become spaces.
std::string OneLine(std::string text);

/// A hash as 16 hexadecimal digits.
std::string HashText(std::uint64_t hash);

/// "3 min 24 s", "12.4 s".
std::string FormatDuration(double seconds);

/// "1.12 km", "340 m".
std::string FormatLength(double meters);

/// Replaces a file's content. Throws InputError that names the file when it cannot be written.
void WriteTextFile(const std::filesystem::path& file, const std::string& text);

}  // namespace dbd
