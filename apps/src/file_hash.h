#pragma once

#include <filesystem>
#include <string>

namespace dbd {

/// SHA-256 (FIPS 180-4) of a file's content, hexadecimal; empty when it is no file that can be
/// read, such as the name of something built in.
std::string Sha256OfFile(const std::filesystem::path& file);

}  // namespace dbd
