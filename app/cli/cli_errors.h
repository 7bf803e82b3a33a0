// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>

namespace chiron::cli {

/// A value in the form in which messages show it: in double quotes, control characters escaped, at most 120
/// characters.
QString quoted(const QString& value);
/// The same text with every control character except the line feed escaped, so that text typed by users
/// cannot control a terminal.
QString printable(const QString& text);

tl::unexpected<core::Error> wrongUse(const QString& message);
tl::unexpected<core::Error> badInput(const QString& message);
/// The folder of an output could not be made. Code: storage.
tl::unexpected<core::Error> noFolder(const QString& path);
/// Stdout took only part of the output (a full disk, a closed pipe). Code: storage.
tl::unexpected<core::Error> stdoutBroke();

/// The exit status of a failure, as specified in cli.md. `cancelled` maps to 1, because the requested result
/// was not reached.
int exitCodeOf(core::ErrorCode code);

} // namespace chiron::cli
