// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Marks a text in code without Qt, so that lupdate finds it. Screens and printed reports show the text in
/// the reader's language; the code that shows it translates it in the same context. The parameters have the
/// same names as in Qt's own definition, so that a file may include both.
#define QT_TRANSLATE_NOOP(scope, x) x
