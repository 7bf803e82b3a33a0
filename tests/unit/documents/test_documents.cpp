// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/documents/document_tree.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QtTest>
#include <algorithm>

using namespace chiron::test;

namespace {
const QString kRoot = QStringLiteral(CHIRON_SOURCE_DIR);
constexpr qsizetype kPage_words = 600;        ///< of a README
constexpr qsizetype kTwoScreens_words = 1200; ///< of the README of the project
constexpr qsizetype kTwoPages_words = 1100;   ///< of a guide

QString textOf(const QString& file) {
    return contentOf(kRoot + QLatin1Char('/') + file);
}

/// The READMEs of the folders of code, and that of the project.
QStringList readmes() {
    QStringList files = ownTextFiles(kRoot).filter(QRegularExpression(QStringLiteral("(^|/)README\\.md$")));
    files.removeIf([](const QString& file) { return file.startsWith(QLatin1String("docs/")); });
    return files;
}
} // namespace

/// Whatever the tree cites or links is there.
class TestDocuments : public QObject {
    Q_OBJECT
private slots:
    void citationsAreRead();
    void headingsAreFound();
    void linksAreRead();
    void figuresAndPathsAreFound();
    void everyCitationResolves();
    void everyLinkResolves();
    void readmesAreOnOnePage();
    void readmesLeaveResultsToTheirPages();
    void readmesNameWhatIsThere();
    void guidesAreOnTwoPages();
    void walksLeadThroughTheCode();
    void testsWaitWithPatience();
};

void TestDocuments::citationsAreRead() {
    const auto read = [](const char* text) {
        QStringList list;
        for (const Citation& each : citationsIn(QString::fromUtf8(text)))
            list << each.document + QLatin1Char('|') + each.section + QLatin1Char('|') + each.heading;
        return list;
    };
    QCOMPARE(read("(models.md §2.2, §2.4; Hautus 1995)"), (QStringList{"models|2.2|", "models|2.4|"}));
    QCOMPARE(read("as data.md, Writing, says"), QStringList{"data||Writing"});
    QCOMPARE(read("data.md, Range of a law"), QStringList{"data||Range of a law"});
    QCOMPARE(read("speed.md: at most"), QStringList{"speed||"});
    QCOMPARE(read("see docs/README.md and [x](../data.md)"), QStringList());
}

void TestDocuments::headingsAreFound() {
    const Document document(QStringLiteral("# Models\n## 0. Frames\n### 2.2 Attributes of an "
                                           "object\ntext\n```\n## 9. Not one\n```\n## Range of a law\n"));
    QVERIFY(document.hasHeading("Range of a law and what lies beyond"));
    QVERIFY(document.hasSection("0") && document.hasSection("2.2") && document.hasHeading("Range of a law") &&
            document.hasHeading("Attributes"));
    QVERIFY(document.hasAnchor("22-attributes-of-an-object"));
    QVERIFY(!document.hasSection("2") && !document.hasSection("9") && !document.hasHeading("Rang") &&
            !document.hasAnchor("22"));
}

void TestDocuments::linksAreRead() {
    QCOMPARE(relativeLinks(QStringLiteral(
                 "[a](b.md) ![p](c.png \"C\") [w](https://x.org/y) `[n](o)`\n```\n[q](r)\n```\n[s](t.md#u)")),
             (QStringList{"b.md", "c.png", "t.md#u"}));
}

void TestDocuments::figuresAndPathsAreFound() {
    const QString results =
        QStringLiteral("| who | N | s |\n|---|---|---|\n| a | 1.2 | −3 % |\n| b | 7 of 8 | **4** |\n");
    QCOMPARE(resultTables(results + QStringLiteral("text\n| what | why |\n|---|---|\n| a | 4 tools |\n\n") +
                          results),
             (QStringList{"| who | N | s |", "| who | N | s |"}));
    QCOMPARE(resultTables(QStringLiteral("```\n") + results + QStringLiteral("```\n")), QStringList());
    QCOMPARE(resultTables(QStringLiteral("| f | layer | what |\n|---|---|---|\n| a | 1 | x |\n| b | 2 | y |\n"
                                         "| c | 3 | z |\n| d | 4 | u |\n")),
             QStringList());
    QCOMPARE(wordCount(QStringLiteral(" one two\nthree ")), 3);
    QCOMPARE(pathsNamed(
                 QStringLiteral("`a/b` `c.h` `word` `x = y/z` `build/c` `<file>.lock` `_setup.cpp` `/<id>/d` "
                                "`e/<id>/*.json`\n```\n`f/g`\n```\n")),
             (QStringList{"a/b", "c.h", "e/<id>/*.json"}));
    const PathTree tree(kRoot);
    const QString readme = QStringLiteral("tests/unit/documents/README.md");
    for (const char* there :
         {"document_tree.h", "document_tree.cpp", "unit/documents/document_tree", "documents/", "../devices",
          "tests/unit/<folder>/document_*.h", "curriculum/content/schema"})
        QVERIFY2(tree.has(QLatin1String(there), readme), there);
    for (const char* gone : {"document_trees.h", "ument_tree.h", "documents/devices", "../documents/other",
                             "tests/<folder>/document_tree.h"})
        QVERIFY2(!tree.has(QLatin1String(gone), readme), gone);
}

void TestDocuments::everyCitationResolves() {
    QHash<QString, Document> documents; // by name
    QStringList wrong;
    int citations = 0;
    for (const QString& file : ownTextFiles(kRoot)) {
        if (file.startsWith(QLatin1String("tests/unit/documents/")))
            continue; // examples
        for (const Citation& each : citationsIn(contentOf(kRoot + QLatin1Char('/') + file))) {
            ++citations;
            if (!documents.contains(each.document))
                documents.insert(
                    each.document,
                    Document(contentOf(kRoot + QStringLiteral("/docs/%1.md").arg(each.document))));
            const Document& document = *documents.constFind(each.document);
            const bool there = !document.isEmpty() &&
                               (each.section.isEmpty() || document.hasSection(each.section)) &&
                               (each.heading.isEmpty() || document.hasHeading(each.heading));
            if (!there)
                wrong << QStringLiteral("%1: docs/%2.md %3%4")
                             .arg(file, each.document,
                                  each.section.isEmpty() ? QString() : QStringLiteral("§") + each.section,
                                  each.heading);
        }
    }
    QVERIFY(citations > 300);
    QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("not there:\n") + wrong.join(QLatin1Char('\n'))));
}

void TestDocuments::everyLinkResolves() {
    QStringList wrong;
    int links = 0;
    for (const QString& file : ownTextFiles(kRoot)) {
        if (!file.endsWith(QLatin1String(".md")))
            continue;
        for (const QString& target : relativeLinks(contentOf(kRoot + QLatin1Char('/') + file))) {
            ++links;
            const QString path = target.section(QLatin1Char('#'), 0, 0),
                          anchor = target.section(QLatin1Char('#'), 1);
            const QFileInfo to(path.isEmpty()
                                   ? kRoot + QLatin1Char('/') + file
                                   : QFileInfo(kRoot + QLatin1Char('/') + file).dir().filePath(path));
            if (!to.exists() || (!anchor.isEmpty() && to.suffix() == QLatin1String("md") &&
                                 !Document(contentOf(to.filePath())).hasAnchor(anchor)))
                wrong << file + QStringLiteral(" → ") + target;
        }
    }
    QVERIFY(links > 20);
    QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("lead nowhere:\n") + wrong.join(QLatin1Char('\n'))));
}

void TestDocuments::readmesAreOnOnePage() {
    const QStringList files = readmes();
    QVERIFY(files.size() > 50 && files.contains(QStringLiteral("README.md")));
    QStringList wrong;
    for (const QString& file : files) {
        const qsizetype words = wordCount(textOf(file)),
                        most = file == QLatin1String("README.md") ? kTwoScreens_words : kPage_words;
        if (words > most)
            wrong << QStringLiteral("%1: %2 words, at most %3").arg(file).arg(words).arg(most);
    }
    QVERIFY2(wrong.isEmpty(),
             qPrintable(QStringLiteral("too long; what is worth keeping belongs to a page of docs:\n") +
                        wrong.join(QLatin1Char('\n'))));
}

void TestDocuments::readmesLeaveResultsToTheirPages() {
    QStringList wrong;
    for (const QString& file : readmes())
        for (const QString& table : resultTables(textOf(file)))
            wrong << file + QStringLiteral(": ") + table;
    QVERIFY2(wrong.isEmpty(),
             qPrintable(QStringLiteral("results belong to docs/results:\n") + wrong.join(QLatin1Char('\n'))));
}

void TestDocuments::readmesNameWhatIsThere() {
    const PathTree tree(kRoot);
    QVERIFY(tree.size() > 3000);
    QStringList wrong;
    int paths = 0;
    for (const QString& file : readmes())
        for (const QString& path : pathsNamed(textOf(file))) {
            ++paths;
            if (!tree.has(path, file))
                wrong << QStringLiteral("%1: `%2`").arg(file, path);
        }
    QVERIFY(paths > 300);
    QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("not there:\n") + wrong.join(QLatin1Char('\n'))));
}

/// A stranger reads a guide while doing what it says.
void TestDocuments::guidesAreOnTwoPages() {
    const QStringList guides =
        QDir(kRoot + QStringLiteral("/docs/guides")).entryList({QStringLiteral("*.md")}, QDir::Files);
    QVERIFY(guides.size() > 3);
    QStringList wrong;
    for (const QString& guide : guides)
        if (const qsizetype words = wordCount(textOf(QStringLiteral("docs/guides/") + guide));
            words > kTwoPages_words)
            wrong << QStringLiteral("%1: %2 words, at most %3").arg(guide).arg(words).arg(kTwoPages_words);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

/// Each step of a walk names functions: they stand in a file to which the step leads.
void TestDocuments::walksLeadThroughTheCode() {
    QString walks = textOf(QStringLiteral("docs/architecture.md"));
    walks.remove(0, std::max<qsizetype>(0, walks.indexOf(QLatin1String("\n## Where to start reading"))));
    walks.truncate(walks.indexOf(QLatin1String("\n## "), 1));
    static const QRegularExpression step(QStringLiteral("\\n(?=[0-9]\\. )"));
    static const QRegularExpression function(QStringLiteral("`(?:[A-Za-z]+::)?([A-Za-z]+)(?:\\(\\))?`"));
    QStringList wrong;
    int functions = 0;
    for (const QString& each : walks.split(step)) {
        QString code;
        for (const QString& target : relativeLinks(each))
            if (target.endsWith(QLatin1String(".cpp")) || target.endsWith(QLatin1String(".h")))
                code += textOf(QStringLiteral("docs/") + target);
        for (auto it = function.globalMatch(each); it.hasNext();) {
            const auto match = it.next();
            const QString name = match.captured(1);
            if (!match.captured().contains(QLatin1String("::")) &&
                !match.captured().contains(QLatin1String("()")))
                continue; // a key, a type or a field
            ++functions;
            if (!code.contains(name + QLatin1Char('(')))
                wrong << match.captured() + QStringLiteral(" in: ") + each.section(QLatin1Char('\n'), 0, 0);
        }
    }
    QVERIFY(functions > 10);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

/// Qt's macros without a time give up after 5 s, which a machine with other work may need for anything: tests
/// say kPatience_ms.
void TestDocuments::testsWaitWithPatience() {
    static const QRegularExpression impatient(QStringLiteral(R"(\bQTRY_(VERIFY2?|COMPARE)\()"));
    int patient = 0;
    for (const QString& file : ownTextFiles(kRoot)) {
        if (!file.startsWith(QLatin1String("tests/")) ||
            !(file.endsWith(QLatin1String(".cpp")) || file.endsWith(QLatin1String(".h"))))
            continue;
        const QString text = contentOf(kRoot + QLatin1Char('/') + file);
        patient += static_cast<int>(text.count(QLatin1String("kPatience_ms)")));
        const auto found = impatient.match(text);
        QVERIFY2(!found.hasMatch(),
                 qPrintable(file + QStringLiteral(": ") + found.captured() +
                            QStringLiteral(": say _WITH_TIMEOUT and kPatience_ms (support/patience.h)")));
    }
    QVERIFY(patient > 300); // the files were read
}

QTEST_GUILESS_MAIN(TestDocuments)
#include "test_documents.moc"
