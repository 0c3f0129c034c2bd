// SPDX-License-Identifier: LGPL-2.1-or-later
// Bytes as text, as pages carry them.

#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace blossom::pictures {

/// RFC 4648, section 4.
std::string base64(std::span<const std::byte> bytes);

}  // namespace blossom::pictures
