#include "octree_file.h"

#include <dbd/core/error.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

namespace dbd {
namespace {

constexpr int kTreeDepth = 16;
constexpr const char* kBinaryFormat = "# Octomap OcTree binary file";
constexpr const char* kFullFormat = "# Octomap OcTree file";
constexpr const char* kTreeType = "OcTree";

struct Header {
  bool is_binary = false;  // .bt: two bits per child; .ot: a value per node
  std::string tree_type;
  std::uint64_t nodes = 0;
  double resolution = 0;
  std::size_t data_begin = 0;
};

[[noreturn]] void Fail(const std::string& file, const std::string& what) {
  throw InputError(file + ": " + what);
}

std::string ReadAll(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) Fail(file, "no such file");
  if (!std::filesystem::is_regular_file(file, ignored)) Fail(file, "is not a file");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) Fail(file, "cannot be read");
  return bytes;
}

// Lines "key value" up to "data", after the line that names the format; # begins a comment.
Header ParseHeader(const std::string& file, const std::string& bytes) {
  Header header;
  if (bytes.rfind(kBinaryFormat, 0) == 0) {
    header.is_binary = true;
  } else if (bytes.rfind(kFullFormat, 0) != 0) {
    Fail(file, "is not an OctoMap tree (.bt or .ot)");
  }
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = bytes.find('\n', begin);
    if (end == std::string::npos) Fail(file, "is corrupt: its header has no line 'data'");
    std::istringstream line(bytes.substr(begin, std::min<std::size_t>(end - begin, 200)));
    begin = end + 1;
    std::string key;
    line >> key;
    if (key.empty() || key[0] == '#') continue;
    if (key == "data") break;
    if (key == "id")
      line >> header.tree_type;
    else if (key == "size")
      line >> header.nodes;
    else if (key == "res")
      line >> header.resolution;
    else
      Fail(file, "is corrupt: unknown header line '" + key.substr(0, 40) + "'");
    if (!line) Fail(file, "is corrupt: header line '" + key + "' has no usable value");
  }
  header.data_begin = begin;
  return header;
}

void CheckHeader(const std::string& file, const Header& header) {
  if (header.tree_type != kTreeType) {
    Fail(file, "holds a tree of type '" + header.tree_type.substr(0, 40) + "', OcTree is needed");
  }
  if (!(header.resolution >= 1e-3 && header.resolution <= 1e3)) {
    Fail(file, "is corrupt: its resolution must be 0.001 to 1000 m");
  }
}

// Walks the nodes as OctoMap will read them, without building anything.
class StructureCheck {
 public:
  StructureCheck(std::string_view data, bool is_binary) : data_(data), is_binary_(is_binary) {}

  bool Holds(std::uint64_t expected_nodes) {
    if (expected_nodes == 0) return true;
    nodes_ = 1;
    return Visit(0) && nodes_ == expected_nodes;
  }

 private:
  bool Visit(int depth) { return is_binary_ ? VisitBinary(depth) : VisitFull(depth); }

  // Two bytes hold two bits for each child: 00 unknown, 10 free, 01 occupied, 11 has children.
  bool VisitBinary(int depth) {
    if (depth >= kTreeDepth || data_.size() - next_ < 2) return false;
    const auto low = static_cast<std::uint8_t>(data_[next_]);
    const auto high = static_cast<std::uint8_t>(data_[next_ + 1]);
    next_ += 2;
    unsigned children = low | (static_cast<unsigned>(high) << 8);
    for (int i = 0; i < 8; ++i, children >>= 2) {
      if ((children & 3U) == 0) continue;
      ++nodes_;
      if ((children & 3U) == 3 && !Visit(depth + 1)) return false;
    }
    return true;
  }

  // The node's value as a float, then one bit for each child.
  bool VisitFull(int depth) {
    if (depth > kTreeDepth || data_.size() - next_ < sizeof(float) + 1) return false;
    const auto children = static_cast<std::uint8_t>(data_[next_ + sizeof(float)]);
    next_ += sizeof(float) + 1;
    if (depth == kTreeDepth) return children == 0;
    for (int i = 0; i < 8; ++i) {
      if ((children >> i & 1) == 0) continue;
      ++nodes_;
      if (!Visit(depth + 1)) return false;
    }
    return true;
  }

  std::string_view data_;
  bool is_binary_;
  std::size_t next_ = 0;
  std::uint64_t nodes_ = 0;
};

}  // namespace

std::unique_ptr<octomap::OcTree> ReadOctree(const std::string& file) {
  const std::string bytes = ReadAll(file);
  const Header header = ParseHeader(file, bytes);
  CheckHeader(file, header);
  const std::string_view data = std::string_view(bytes).substr(header.data_begin);
  if (!StructureCheck(data, header.is_binary).Holds(header.nodes)) {
    Fail(file, "is corrupt: its nodes do not match the " + std::to_string(header.nodes) +
                   " that its header announces");
  }
  auto tree = std::make_unique<octomap::OcTree>(header.resolution);
  if (header.nodes == 0) return tree;
  std::istringstream stream(bytes);
  stream.seekg(static_cast<std::streamoff>(header.data_begin));
  if (header.is_binary) {
    tree->readBinaryData(stream);
  } else {
    tree->readData(stream);
  }
  return tree;
}

void WriteOctree(octomap::OcTree& tree, std::ostream& stream) {
  tree.toMaxLikelihood();
  tree.prune();
  stream << kBinaryFormat << "\nid " << kTreeType << "\nsize " << tree.size() << "\nres "
         << tree.getResolution() << "\ndata\n";
  if (tree.size() > 0) tree.writeBinaryData(stream);
}

}  // namespace dbd
