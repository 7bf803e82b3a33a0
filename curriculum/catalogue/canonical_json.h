// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <string>

namespace chiron::catalogue {

/// Returns the one canonical spelling of a JSON value, so that equal content has equal bytes and equal
/// digests: UTF-8, no spaces, keys sorted by code unit, numbers in the shortest decimals that read back to
/// the same double (std::to_chars), no minus zero, and only `"`, `\` and control characters escaped. The form
/// is close to RFC 8785. It is our own writer because Qt's may change its number format.
std::string canonicalJson(const QJsonValue& value);

/// Returns the SHA-256 of the bytes in lower-case hex.
std::string sha256Hex(const std::string& bytes);

} // namespace chiron::catalogue
