#include "desktop/cli/packing.hpp"

#include <brotli/encode.h>
#include <memory>
#include <nettle/base64.h>
#include <nettle/sha2.h>
#include <new>
#include <stdexcept>
#include <vector>
#include <zip.h>
#include <zlib.h>

namespace snug::desktop {
namespace {

constexpr zip_uint16_t kFirstDay = 1 << 5 | 1;         // 1 January 1980
constexpr zip_uint32_t kPlainFile = 0100644u << 16;    // what Unix keeps of a file
constexpr int kGzip = 16, kBest = 9, kMostMemory = 9;  // of zlib

const std::uint8_t* bytes_of(std::string_view text) { return reinterpret_cast<const std::uint8_t*>(text.data()); }

[[noreturn]] void fail(const char* why) { throw std::runtime_error(std::string("the archive cannot be made: ") + why); }

struct CloseSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, CloseSource>;

void add_all(zip_t* archive, const SiteFiles& files) {
  for (const auto& [path, bytes] : files) {
    zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
    const zip_int64_t at = source == nullptr ? -1 : zip_file_add(archive, path.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (at < 0) fail(zip_strerror(archive));
    const auto index = static_cast<zip_uint64_t>(at);
    if (zip_set_file_compression(archive, index, ZIP_CM_DEFLATE, kBest) != 0 ||
        zip_file_set_dostime(archive, index, 0, kFirstDay, 0) != 0 ||
        zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, kPlainFile) != 0)
      fail(zip_strerror(archive));
  }
}

std::string read_whole(zip_source_t* source) {
  zip_stat_t about;
  if (zip_source_stat(source, &about) != 0 || zip_source_open(source) != 0) fail("it cannot be read back");
  std::string bytes(about.size, '\0');
  const bool whole = zip_source_read(source, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size());
  zip_source_close(source);
  if (!whole) fail("it cannot be read back");
  return bytes;
}

std::string sha256_of(std::string_view bytes) {
  sha256_ctx context;
  std::string digest(SHA256_DIGEST_SIZE, '\0');
  sha256_init(&context);
  sha256_update(&context, bytes.size(), bytes_of(bytes));
  sha256_digest(&context, digest.size(), reinterpret_cast<std::uint8_t*>(digest.data()));
  return digest;
}

}  // namespace

std::string zip_of(const SiteFiles& files) {
  zip_error_t error;
  zip_error_init(&error);
  const Source memory(zip_source_buffer_create(nullptr, 0, 0, &error));
  zip_t* archive = memory ? zip_open_from_source(memory.get(), ZIP_TRUNCATE | ZIP_CREATE, &error) : nullptr;
  if (archive == nullptr) fail(zip_error_strerror(&error));
  zip_source_keep(memory.get());
  add_all(archive, files);
  if (zip_close(archive) != 0) fail(zip_strerror(archive));
  return read_whole(memory.get());
}

std::string gzip_of(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, kBest, Z_DEFLATED, MAX_WBITS + kGzip, kMostMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = const_cast<Bytef*>(bytes_of(bytes));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int done = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (done != Z_STREAM_END) throw std::bad_alloc();
  return packed;
}

std::string brotli_of(std::string_view bytes) {
  std::size_t size = BrotliEncoderMaxCompressedSize(bytes.size());
  std::string packed(size, '\0');
  if (BrotliEncoderCompress(BROTLI_MAX_QUALITY, BROTLI_MAX_WINDOW_BITS, BROTLI_MODE_GENERIC, bytes.size(),
                            bytes_of(bytes), &size, reinterpret_cast<std::uint8_t*>(packed.data())) == BROTLI_FALSE)
    throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

std::string base64_of(std::string_view bytes) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(text.data(), bytes.size(), bytes_of(bytes));
  return text;
}

std::string sha256_hex_of(std::string_view bytes) {
  std::string digits;
  for (const char byte : sha256_of(bytes))
    for (const int shift : {4, 0}) digits += "0123456789abcdef"[byte >> shift & 0xf];
  return digits;
}

std::string policy_hash_of(std::string_view script) { return "'sha256-" + base64_of(sha256_of(script)) + "'"; }

}  // namespace snug::desktop
