// What packages are made of: archives and packed bytes, each the same for the same files, and what a policy names
// scripts by.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace snug::desktop {

/// A site's files: their bytes by their paths, in the order of these.
using SiteFiles = std::map<std::string, std::string>;

/// A zip archive, dated 1980, the first year that a zip can name. Throws std::runtime_error where libzip fails.
[[nodiscard]] std::string zip_of(const SiteFiles& files);
/// As `gzip -9n` packs. Throws std::bad_alloc.
[[nodiscard]] std::string gzip_of(std::string_view bytes);
/// As `brotli -q 11` packs. Throws std::bad_alloc.
[[nodiscard]] std::string brotli_of(std::string_view bytes);

[[nodiscard]] std::string base64_of(std::string_view bytes);
/// SHA-256, in hexadecimal digits.
[[nodiscard]] std::string sha256_hex_of(std::string_view bytes);
/// 'sha256-…', with its quotes, as a content-security policy has it.
[[nodiscard]] std::string policy_hash_of(std::string_view script);

}  // namespace snug::desktop
