// SPDX-License-Identifier: Apache-2.0
// There is no zstd here: whoever asks for something packed by it is refused. What a page in the same browser
// reads is not packed.
#pragma once

#include <stddef.h>

inline size_t ZSTD_compressBound(size_t) { return 0; }
inline size_t ZSTD_compress(void*, size_t, const void*, size_t, int) { return 1; }
inline unsigned ZSTD_isError(size_t) { return 1; }
