// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Marks a text in code without Qt, so that lupdate finds it. Screens and printed reports show the text in
/// the reader's language; the code that shows it translates it in the same context. It is spelled as Qt
/// spells it, so that a file may read both definitions.
#define QT_TRANSLATE_NOOP(scope, x) x
