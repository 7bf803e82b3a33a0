// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/documents/document_tree.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>

namespace chiron::test {

namespace {

/// Fenced blocks hold examples, whose brackets are no links and whose # are no headings.
QString withoutFences(const QString& markdown) {
    QStringList kept;
    bool fenced = false;
    for (const QString& line : markdown.split(QLatin1Char('\n'))) {
        if (line.trimmed().startsWith(QLatin1String("```")))
            fenced = !fenced;
        else if (!fenced)
            kept << line;
    }
    return kept.join(QLatin1Char('\n'));
}

QString anchorOf(const QString& heading) {
    QString anchor;
    for (const QChar c : heading.toLower()) {
        if (c.isLetterOrNumber() || c == QLatin1Char('-') || c == QLatin1Char('_'))
            anchor += c;
        else if (c == QLatin1Char(' '))
            anchor += QLatin1Char('-');
    }
    return anchor;
}

} // namespace

Document::Document(const QString& markdown) {
    static const QRegularExpression heading(QStringLiteral("^#{1,6} +(.+?) *#* *$"),
                                            QRegularExpression::MultilineOption);
    for (auto it = heading.globalMatch(withoutFences(markdown)); it.hasNext();)
        m_headings << it.next().captured(1);
}

bool Document::hasSection(const QString& number) const {
    const QRegularExpression numbered(QStringLiteral("^%1(\\.? |$)").arg(QRegularExpression::escape(number)));
    return !m_headings.filter(numbered).isEmpty();
}

bool Document::hasHeading(const QString& words) const {
    static const QRegularExpression number(QStringLiteral("^[0-9.]+ "));
    const auto begins = [](const QString& whole, const QString& part) {
        return !part.isEmpty() && whole.startsWith(part, Qt::CaseInsensitive) &&
               (whole.size() == part.size() || !whole.at(part.size()).isLetterOrNumber());
    };
    return std::any_of(m_headings.begin(), m_headings.end(), [&](QString heading) {
        heading.remove(number);
        return begins(heading, words) || begins(words, heading);
    });
}

bool Document::hasAnchor(const QString& anchor) const {
    return std::any_of(m_headings.begin(), m_headings.end(),
                       [&](const QString& heading) { return anchorOf(heading) == anchor; });
}

QList<Citation> citationsIn(const QString& text) {
    static const QRegularExpression cited(
        QStringLiteral("(?<![\\w/.-])(?<!\\]\\()([a-z][a-z-]*)\\.md\\b((?:(?:,| and|,? "
                       "or)?\\s*§\\s*[0-9]+(?:\\.[0-9]+)*)*)(?:, ([A-Z][a-z]+(?: [a-z]+){0,3}))?"));
    static const QRegularExpression number(QStringLiteral("[0-9]+(?:\\.[0-9]+)*"));
    QList<Citation> citations;
    for (auto it = cited.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        const Citation whole{
            match.captured(1), {}, match.captured(2).isEmpty() ? match.captured(3) : QString()};
        if (match.captured(2).isEmpty())
            citations << whole;
        for (auto section = number.globalMatch(match.captured(2)); section.hasNext();)
            citations << Citation{whole.document, section.next().captured(0), {}};
    }
    return citations;
}

QStringList relativeLinks(const QString& markdown) {
    static const QRegularExpression code(QStringLiteral("`[^`\n]*`"));
    static const QRegularExpression link(QStringLiteral("\\]\\(([^)\\s]+)(?: \"[^\"]*\")?\\)"));
    QString text = withoutFences(markdown);
    text.remove(code);
    QStringList targets;
    for (auto it = link.globalMatch(text); it.hasNext();)
        if (const QString target = it.next().captured(1);
            !target.contains(QLatin1String("://")) && !target.startsWith(QLatin1String("mailto:")))
            targets << target;
    return targets;
}

QStringList ownTextFiles(const QString& root) {
    static const QSet<QString> endings{"h",   "cpp", "c",    "json", "md", "txt", "cmake", "py",
                                       "sql", "qml", "frag", "vert", "sh", "in",  "cff",   "yml"};
    QStringList files;
    const QDir top(root);
    for (const QString& name : top.entryList(QDir::Files))
        if (endings.contains(QFileInfo(name).suffix()))
            files << name;
    for (const char* folder : {"app", "curriculum", "database", "docs", "modules", "packaging", "resources",
                               "scripts", "tests", "translations"})
        for (QDirIterator it(top.filePath(QLatin1String(folder)), QDir::Files, QDirIterator::Subdirectories);
             it.hasNext();)
            if (const QFileInfo file(it.next()); endings.contains(file.suffix()) || file.suffix().isEmpty())
                files << top.relativeFilePath(file.filePath());
    files.sort();
    return files;
}

QString contentOf(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? QString::fromUtf8(in.readAll()) : QString();
}

} // namespace chiron::test
