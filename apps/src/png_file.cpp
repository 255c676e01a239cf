#include "png_file.h"

#include <dbd/core/error.h>
#include <tbb/parallel_for.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "text.h"

namespace dbd {
namespace {

using Bytes = std::vector<unsigned char>;

constexpr int kStripRows = 64;
constexpr std::size_t kSamples = 3;  // of a pixel, a byte each
constexpr char kPaeth = 4;           // the filter's number

std::string BigEndian(std::uint32_t value) {
  std::string text;
  for (const int shift : {24, 16, 8, 0}) text += static_cast<char>(value >> shift & 0xff);
  return text;
}

std::string Chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto* bytes = reinterpret_cast<const Bytef*>(body.data());
  const auto sum = static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(body.size())));
  return BigEndian(static_cast<std::uint32_t>(data.size())) + body + BigEndian(sum);
}

std::string Header(const PixelRows& image) {
  const char kind[] = {8, 2, 0, 0, 0};  // bits, RGB, deflate, filters, not interlaced
  return Chunk("IHDR", BigEndian(static_cast<std::uint32_t>(image.width)) +
                           BigEndian(static_cast<std::uint32_t>(image.height)) +
                           std::string(kind, sizeof kind));
}

/// What A. Paeth predicts from the samples to the left, above, and above left.
int Predicted(int left, int above, int corner) {
  const int to_left = std::abs(above - corner);
  const int to_above = std::abs(left - corner);
  const int to_corner = std::abs(left + above - 2 * corner);
  if (to_left <= to_above && to_left <= to_corner) return left;
  return to_above <= to_corner ? above : corner;
}

/// The samples of a row, after those of a black pixel to its left; all black above the first row.
Bytes Samples(const PixelRows& image, int row) {
  Bytes samples((static_cast<std::size_t>(image.width) + 1) * kSamples, 0);
  if (row < 0) return samples;
  const std::uint32_t* pixel = image.pixels + static_cast<std::size_t>(row) * image.stride;
  for (std::size_t i = kSamples; i < samples.size(); i += kSamples, ++pixel) {
    samples[i] = static_cast<unsigned char>(*pixel >> 16 & 0xff);
    samples[i + 1] = static_cast<unsigned char>(*pixel >> 8 & 0xff);
    samples[i + 2] = static_cast<unsigned char>(*pixel & 0xff);
  }
  return samples;
}

Bytes FilteredRows(const PixelRows& image, int first, int last) {
  Bytes filtered;
  Bytes above = Samples(image, first - 1);
  for (int row = first; row < last; ++row) {
    Bytes samples = Samples(image, row);
    filtered.push_back(kPaeth);
    for (std::size_t i = kSamples; i < samples.size(); ++i) {
      const int predicted = Predicted(samples[i - kSamples], above[i], above[i - kSamples]);
      filtered.push_back(static_cast<unsigned char>(samples[i] - predicted));
    }
    above.swap(samples);
  }
  return filtered;
}

/// A piece of a deflate stream that ends at a byte, and refers to nothing before it.
std::string Deflated(Bytes& bytes, bool is_last) {
  z_stream stream{};
  constexpr int kWindowBits = -15;  // negative: neither header nor checksum
  constexpr int kMemory = 9;
  const int begun =
      deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kWindowBits, kMemory, Z_DEFAULT_STRATEGY);
  DBD_ASSERT(begun == Z_OK);
  constexpr std::size_t kFlush = 16;  // at most, of the mark at the end
  std::string deflated(deflateBound(&stream, static_cast<uLong>(bytes.size())) + kFlush, '\0');
  stream.next_in = bytes.data();
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(deflated.data());
  stream.avail_out = static_cast<uInt>(deflated.size());
  deflate(&stream, is_last ? Z_FINISH : Z_SYNC_FLUSH);
  DBD_ASSERT(stream.avail_in == 0 && stream.avail_out > 0);
  deflated.resize(stream.total_out);
  deflateEnd(&stream);
  return deflated;
}

struct Strip {
  std::string deflated;
  uLong sum = 0;  // of the bytes before they were deflated
  z_off_t size = 0;
};

Strip MakeStrip(const PixelRows& image, int index) {
  const int first = index * kStripRows;
  const int last = std::min(first + kStripRows, image.height);
  Bytes rows = FilteredRows(image, first, last);
  Strip strip;
  strip.sum = adler32(adler32(0, nullptr, 0), rows.data(), static_cast<uInt>(rows.size()));
  strip.size = static_cast<z_off_t>(rows.size());
  strip.deflated = Deflated(rows, last == image.height);
  return strip;
}

}  // namespace

void WritePng(const std::filesystem::path& file, const PixelRows& image) {
  DBD_ASSERT(image.width > 0 && image.height > 0);
  std::vector<Strip> strips(static_cast<std::size_t>((image.height - 1) / kStripRows + 1));
  tbb::parallel_for(std::size_t{0}, strips.size(),
                    [&](std::size_t i) { strips[i] = MakeStrip(image, static_cast<int>(i)); });
  std::string png = "\x89PNG\r\n\x1a\n" + Header(image);
  uLong sum = adler32(0, nullptr, 0);
  std::string start = "\x78\x01";  // of a zlib stream: deflate, window of 32 KiB, fast
  for (const Strip& strip : strips) {
    sum = adler32_combine(sum, strip.sum, strip.size);
    const bool is_last = &strip == &strips.back();
    const std::string end = is_last ? BigEndian(static_cast<std::uint32_t>(sum)) : "";
    png += Chunk("IDAT", start + strip.deflated + end);
    start.clear();
  }
  WriteTextFile(file, png + Chunk("IEND", ""));
}

}  // namespace dbd
