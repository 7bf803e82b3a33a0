// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/json_scanner.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace chiron::catalogue {

namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Number of RFC 8259: -? (0 | [1-9][0-9]*) (\\. [0-9]+)? ([eE] [+-]? [0-9]+)?
bool isNumber(const QByteArray& text) {
    qsizetype i = text.startsWith('-') ? 1 : 0;
    const auto digits = [&] {
        const qsizetype before = i;
        while (i < text.size() && isDigit(text[i]))
            ++i;
        return i - before;
    };
    const bool zero = i < text.size() && text[i] == '0';
    if (const qsizetype whole = digits(); whole == 0 || (zero && whole > 1))
        return false;
    if (i < text.size() && text[i] == '.' && (++i, digits() == 0))
        return false;
    if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
        ++i;
        if (i < text.size() && (text[i] == '+' || text[i] == '-'))
            ++i;
        if (digits() == 0)
            return false;
    }
    return i == text.size();
}

} // namespace

void JsonScanner::scan() {
    if (m_text.startsWith("\xef\xbb\xbf"))
        m_pos = 3;
    value(QStringLiteral("$"), 1);
}

void JsonScanner::skipSpace() {
    while (at(' ') || at('\t') || at('\n') || at('\r'))
        ++m_pos;
}

void JsonScanner::value(const QString& path, int depth) {
    skipSpace();
    m_offsets.insert(path, m_pos);
    if (depth > kDeepest) {
        m_problems.push_back({path, QStringLiteral("nested deeper than %1").arg(kDeepest),
                              QStringLiteral("at most %1 levels").arg(kDeepest)});
        m_pos = m_text.size();
        return;
    }
    if (at('{')) {
        object(path, depth);
    } else if (at('[')) {
        array(path, depth);
    } else if (at('"')) {
        string(path);
    } else {
        scalar(path);
    }
    skipSpace();
}

void JsonScanner::scalar(const QString& path) {
    const qsizetype start = m_pos;
    while (m_pos < m_text.size() && !at(',') && !at('}') && !at(']'))
        ++m_pos;
    const QByteArray token = m_text.mid(start, m_pos - start).trimmed();
    if (token != "true" && token != "false" && token != "null" && !isNumber(token))
        m_problems.push_back(
            {path, QString::fromUtf8(token.left(40)), QStringLiteral("a number as JSON writes it")});
}

void JsonScanner::object(const QString& path, int depth) {
    QSet<QString> seen;
    ++m_pos;
    skipSpace();
    while (m_pos < m_text.size() && !at('}')) {
        const qsizetype keyAt = m_pos;
        const QString key = string(path);
        const QString member = memberPath(path, key);
        skipSpace();
        if (at(':'))
            ++m_pos;
        if (seen.contains(key)) {
            m_problems.push_back({member, QStringLiteral("given twice"), QStringLiteral("each key once")});
        }
        seen.insert(key);
        value(member, depth + 1);
        if (at(','))
            ++m_pos;
        skipSpace();
        if (m_pos == keyAt) // the text is not JSON after all: always advance
            ++m_pos;
    }
    ++m_pos;
}

void JsonScanner::array(const QString& path, int depth) {
    ++m_pos;
    skipSpace();
    for (qsizetype index = 0; m_pos < m_text.size() && !at(']'); ++index) {
        const qsizetype before = m_pos;
        value(elementPath(path, index), depth + 1);
        if (at(','))
            ++m_pos;
        skipSpace();
        if (m_pos == before)
            ++m_pos;
    }
    ++m_pos;
}

QString JsonScanner::string(const QString& path) {
    const qsizetype start = m_pos;
    if (!at('"'))
        return {};
    ++m_pos;
    bool escaped = false;
    while (m_pos < m_text.size() && !at('"')) {
        const bool escape = at('\\');
        escaped = escaped || escape;
        m_pos += escape ? 1 : 0;
        if (m_pos < m_text.size() && escape && !QByteArray("\"\\/bfnrtu").contains(m_text[m_pos]))
            m_problems.push_back(
                {path, QStringLiteral("an unknown escape"), QStringLiteral("an escape of JSON")});
        ++m_pos;
    }
    m_pos = qMin(m_pos + 1, m_text.size()); // Qt has already refused unterminated strings
    const QByteArray text = m_text.mid(start, m_pos - start);
    if (!escaped)
        return QString::fromUtf8(text.mid(1, text.size() - 2));
    return QJsonDocument::fromJson('[' + text + ']').array().at(0).toString();
}

TextPlace placeOf(const QByteArray& text, qsizetype offset) {
    const QByteArray before = text.left(qBound(qsizetype{0}, offset, text.size()));
    const qsizetype lineStart = before.lastIndexOf('\n') + 1;
    return {before.count('\n') + 1, before.size() - lineStart + 1};
}

} // namespace chiron::catalogue
