// SPDX-License-Identifier: Apache-2.0
// What the libraries ask of zstd, without its library. A frame is written of blocks as they are (RFC
// 8878, 3.1.1.2.2: Raw_Block), so that nothing gets smaller and every reader of zstd reads it; one is read by
// the host's JavaScript.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

struct ZSTD_CCtx_s {};

/// Bytes written to `out`, which has room for `capacity`; more than `capacity` where they are no frame or too
/// many.
__attribute__((import_module("fairway"), import_name("unzstd"))) size_t fairway_unzstd(void* out,
                                                                                       size_t capacity,
                                                                                       const void* frame,
                                                                                       size_t size);

namespace fairway::web {

inline constexpr size_t zstd_block = size_t{1} << 17U;
inline constexpr size_t zstd_header = 9;
inline constexpr uint32_t zstd_magic = 0xFD2FB528U;
inline constexpr size_t zstd_error = ~size_t{0};

}  // namespace fairway::web

inline size_t ZSTD_compressBound(size_t size) {
  return size + fairway::web::zstd_header + 3 * (size / fairway::web::zstd_block + 1);
}

inline unsigned ZSTD_isError(size_t result) { return result == fairway::web::zstd_error ? 1 : 0; }

inline size_t ZSTD_compress(void* out, size_t capacity, const void* bytes, size_t size, int) {
  using namespace fairway::web;
  if (capacity < ZSTD_compressBound(size)) return zstd_error;
  auto* to = static_cast<uint8_t*>(out);
  const auto* from = static_cast<const uint8_t*>(bytes);
  const auto length = static_cast<uint32_t>(size);
  memcpy(to, &zstd_magic, 4);
  to[4] = 0xA0;  // one segment, whose size follows in four bytes
  memcpy(to + 5, &length, 4);
  to += zstd_header;
  do {
    const size_t block = size < zstd_block ? size : zstd_block;
    const auto header = static_cast<uint32_t>(block << 3U) | (block == size ? 1U : 0U);
    memcpy(to, &header, 3);
    memcpy(to + 3, from, block);
    to += 3 + block;
    from += block;
    size -= block;
  } while (size > 0);
  return static_cast<size_t>(to - static_cast<uint8_t*>(out));
}

inline ZSTD_CCtx_s* ZSTD_createCCtx() { return new ZSTD_CCtx_s; }
inline size_t ZSTD_freeCCtx(ZSTD_CCtx_s* context) {
  delete context;
  return 0;
}
inline size_t ZSTD_compressCCtx(ZSTD_CCtx_s*, void* out, size_t capacity, const void* bytes, size_t size,
                                int level) {
  return ZSTD_compress(out, capacity, bytes, size, level);
}

/// RFC 8878, 3.1.1.1. As large as no frame is where it does not say.
inline unsigned long long ZSTD_getFrameContentSize(const void* frame, size_t size) {
  const auto* bytes = static_cast<const uint8_t*>(frame);
  uint32_t magic = 0;
  if (size < 5) return ~0ULL;
  memcpy(&magic, bytes, 4);
  if (magic != fairway::web::zstd_magic) return ~0ULL;
  const uint8_t descriptor = bytes[4];
  const bool one_segment = (descriptor & 0x20U) != 0;
  const size_t dictionary = (size_t{1} << (descriptor & 3U)) >> 1U;
  const size_t kind = descriptor >> 6U;
  const size_t width = kind == 0 ? (one_segment ? 1 : 0) : size_t{1} << kind;
  const size_t at = 5 + (one_segment ? 0 : 1) + dictionary;
  uint64_t content = 0;
  if (width == 0 || at + width > size) return ~0ULL;
  memcpy(&content, bytes + at, width);
  return width == 2 ? content + 256 : content;
}

inline size_t ZSTD_decompress(void* out, size_t capacity, const void* frame, size_t size) {
  const size_t got = fairway_unzstd(out, capacity, frame, size);
  return got <= capacity ? got : fairway::web::zstd_error;
}
