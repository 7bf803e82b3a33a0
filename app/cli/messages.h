// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>

namespace chiron::cli {

/// A value as messages show it: in double quotes, control characters escaped, at most 120 characters.
QString quoted(const QString& value);
/// The same text with every control character but the line's end escaped: what people typed cannot drive a
/// terminal.
QString printable(const QString& text);

tl::unexpected<core::Error> wrongUse(const QString& message);
tl::unexpected<core::Error> badInput(const QString& message);

/// The exit status of a failure, as cli.md's contract has it. `cancelled` counts as 1: what was asked was not
/// reached.
int exitCodeOf(core::ErrorCode code);

} // namespace chiron::cli
