// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <string>

namespace chiron::catalogue {

/// One spelling of a JSON value, so that equal content has equal bytes and digests: UTF-8, no spaces, keys
/// sorted by code unit, numbers in the shortest decimals that read back to the same double (std::to_chars),
/// no minus zero, only
/// `"`, `\` and control characters escaped. Near RFC 8785; ours, because Qt's writer may change its number
/// format.
std::string canonicalJson(const QJsonValue& value);

/// SHA-256 of the bytes, lower-case hex.
std::string sha256Hex(const std::string& bytes);

} // namespace chiron::catalogue
