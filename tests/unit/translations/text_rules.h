// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "unit/translations/ts_file.h"

namespace chiron::test {

/// What is wrong with one text of a catalogue whose language has so many plural forms; empty when nothing is.
/// The words of a translation are its own, but not what the program or the layout relies on: placeholders,
/// line breaks, spaces at the ends, the final punctuation and the number of keyboard mnemonics.
QStringList faultsOf(const TsMessage& message, int pluralForms);

} // namespace chiron::test
