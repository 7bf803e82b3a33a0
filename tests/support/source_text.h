// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace chiron::test {

/// A C++ file as the compiler sees it: without comments.
struct SourceText {
    QString code; ///< string literals included; of a raw one only the quotes
    /// What stands between the quotes of each string literal, escapes as they are written.
    QStringList literals;
};

SourceText readSource(const QString& text);

} // namespace chiron::test
