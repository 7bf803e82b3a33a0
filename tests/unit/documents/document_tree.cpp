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

constexpr const char* kFolders[] = {".ci",     "app",     "curriculum",  "database",
                                    "docs",    "modules", "packaging",   "resources",
                                    "scripts", "tests",   "translations"};

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

qsizetype wordCount(const QString& markdown) {
    static const QRegularExpression space(QStringLiteral("\\s+"));
    return markdown.split(space, Qt::SkipEmptyParts).size();
}

QStringList resultTables(const QString& markdown) {
    static const QRegularExpression figure(QStringLiteral("^[ *]*[-−+±]?[0-9]"));
    constexpr int kFewest = 4; // cells, or a table of versions or layers would count
    QStringList found, rows;
    const auto look = [&] {
        qsizetype cells = 0, figures = 0;
        for (qsizetype row = 2; row < rows.size(); ++row) { // after the heading and its rule
            const QStringList all = rows[row].split(QLatin1Char('|'));
            for (qsizetype i = 2; i + 1 < all.size(); ++i) {
                ++cells;
                figures += figure.match(all[i]).hasMatch() ? 1 : 0;
            }
        }
        if (figures >= kFewest && 2 * figures > cells)
            found << rows.front();
        rows.clear();
    };
    for (const QString& line : withoutFences(markdown).split(QLatin1Char('\n'))) {
        if (line.startsWith(QLatin1Char('|')))
            rows << line;
        else if (!rows.isEmpty())
            look();
    }
    if (!rows.isEmpty())
        look();
    return found;
}

QStringList pathsNamed(const QString& markdown) {
    static const QRegularExpression span(QStringLiteral("`([A-Za-z.*][A-Za-z0-9_.*<>/-]*)`"));
    static const QRegularExpression ending(
        QStringLiteral("\\.(h|cpp|json|md|txt|cmake|py|sql|qml|frag|vert|sh|in|ts|svg|png|cff)$"));
    QStringList paths;
    for (auto it = span.globalMatch(withoutFences(markdown)); it.hasNext();)
        if (const QString named = it.next().captured(1);
            !named.startsWith(QLatin1String("build/")) &&
            (named.contains(QLatin1Char('/')) || ending.match(named).hasMatch()))
            paths << named;
    return paths;
}

PathTree::PathTree(const QString& root) {
    const QDir top(root);
    for (const QString& name : top.entryList(QDir::Files))
        add(name);
    for (const char* folder : kFolders) {
        if (!top.exists(QLatin1String(folder)))
            continue;
        add(QLatin1String(folder));
        for (QDirIterator it(top.filePath(QLatin1String(folder)),
                             QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot,
                             QDirIterator::Subdirectories);
             it.hasNext();)
            add(top.relativeFilePath(it.next()));
    }
}

void PathTree::add(const QString& path) {
    static const QRegularExpression source(QStringLiteral("\\.(h|cpp)$"));
    QString stem = path;
    stem.remove(source);
    for (const QString& each : {path, stem}) {
        m_paths << each;
        m_ends << each;
        for (qsizetype slash = each.indexOf(QLatin1Char('/')); slash >= 0;
             slash = each.indexOf(QLatin1Char('/'), slash + 1))
            m_ends << each.mid(slash + 1);
    }
}

bool PathTree::has(const QString& named, const QString& document) const {
    QString path = named;
    while (path.endsWith(QLatin1Char('/')))
        path.chop(1);
    if (path.contains(QLatin1Char('*')) || path.contains(QLatin1Char('<'))) {
        static const QRegularExpression any(QStringLiteral("<[^>]*>|\\*"));
        QStringList parts;
        for (const QString& part : path.split(any))
            parts << QRegularExpression::escape(part);
        const QRegularExpression like(QLatin1Char('^') + parts.join(QStringLiteral("[^/]*")) +
                                      QLatin1Char('$'));
        return std::any_of(m_ends.begin(), m_ends.end(),
                           [&](const QString& end) { return like.match(end).hasMatch(); });
    }
    return m_ends.contains(path) ||
           m_paths.contains(QDir::cleanPath(QFileInfo(document).path() + QLatin1Char('/') + path));
}

QStringList ownTextFiles(const QString& root) {
    static const QSet<QString> endings{"h",   "cpp", "c",    "json", "md", "txt", "cmake", "py",
                                       "sql", "qml", "frag", "vert", "sh", "in",  "cff",   "yml"};
    QStringList files;
    const QDir top(root);
    for (const QString& name : top.entryList(QDir::Files))
        if (endings.contains(QFileInfo(name).suffix()))
            files << name;
    for (const char* folder : kFolders)
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
