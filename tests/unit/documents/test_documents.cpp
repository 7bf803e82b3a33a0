// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/documents/document_tree.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QtTest>

using namespace chiron::test;

namespace {
const QString kRoot = QStringLiteral(CHIRON_SOURCE_DIR);
}

/// Whatever the tree cites or links is there.
class TestDocuments : public QObject {
    Q_OBJECT
private slots:
    void citationsAreRead();
    void headingsAreFound();
    void linksAreRead();
    void everyCitationResolves();
    void everyLinkResolves();
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
