// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/problems.h"

#include <QByteArray>
#include <QHash>
#include <QSet>
#include <optional>

namespace chiron::catalogue {

/// Finds the place of every value in a JSON text, and the faults that QJsonDocument accepts: keys given
/// twice, deep nesting, numbers such as .5, 1. or 01, and escapes that JSON does not have. It is meant for
/// text that QJsonDocument has already accepted, but never reads outside the text, whatever that holds.
class JsonScanner {
public:
    static constexpr int kDeepest = 16;

    explicit JsonScanner(const QByteArray& text) : m_text(text) {}
    JsonScanner(const JsonScanner&) = delete;
    JsonScanner& operator=(const JsonScanner&) = delete;

    void scan();
    const QHash<QString, qsizetype>& offsets() const { return m_offsets; }
    const Problems& problems() const { return m_problems; }

private:
    void value(const QString& path, int depth);
    void object(const QString& path, int depth);
    void array(const QString& path, int depth);
    void scalar(const QString& path);
    QString string(const QString& path);
    void skipSpace();
    bool at(char c) const { return m_pos < m_text.size() && m_text[m_pos] == c; }

    const QByteArray& m_text;
    qsizetype m_pos = 0;
    QHash<QString, qsizetype> m_offsets;
    Problems m_problems;
};

/// The line and column of an offset, both counted from 1. The column counts bytes.
struct TextPlace {
    qsizetype line = 1;
    qsizetype column = 1;
};
TextPlace placeOf(const QByteArray& text, qsizetype offset);

} // namespace chiron::catalogue
