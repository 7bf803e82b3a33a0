// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Marks a text that screens and papers show in the reader's language, so that lupdate finds it, in code without Qt. Who shows the text
/// translates it in the same context.
#define QT_TRANSLATE_NOOP(context, text) text
