// SPDX-License-Identifier: GPL-3.0-or-later
// Sources that are compiled several at a time see each other's unnamed namespaces. A call can then be bound
// to the function of another file, where its arguments fit that one better, and nobody is told. So what one
// source of a batch keeps to itself, no other of the batch may call by that name.
#include "support/source_text.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

using namespace chiron;

namespace {

QString textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// A source's code without comments, and with empty literals.
QString codeOf(const QString& text) {
    static const QRegularExpression literal(QStringLiteral("\"(\\\\.|[^\"\\\\\\n])*\""));
    return test::readSource(text).code.replace(literal, QStringLiteral("\"\""));
}

/// The functions of a source's unnamed namespaces, and its static ones. The formatter begins each at the
/// beginning of a line and closes the namespace with its comment.
QSet<QString> ownFunctions(const QString& text) {
    static const QRegularExpression space(QStringLiteral("^namespace \\{\\n(.*?)^\\} // namespace$"),
                                          QRegularExpression::MultilineOption |
                                              QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression function(
        QStringLiteral(
            "^(?!using|template|static_assert|return|#|\\})[A-Za-z_][^\\n;={}()]*?[\\s&*>](\\w+)\\("),
        QRegularExpression::MultilineOption);
    static const QRegularExpression unseen(QStringLiteral("^static [^\\n;={}()]*?(\\w+)\\("),
                                           QRegularExpression::MultilineOption);
    QSet<QString> names;
    for (auto spaces = space.globalMatch(text); spaces.hasNext();) {
        const QString body = codeOf(spaces.next().captured(1));
        for (auto it = function.globalMatch(body); it.hasNext();)
            names.insert(it.next().captured(1));
    }
    const QString code = codeOf(text);
    for (auto it = unseen.globalMatch(code); it.hasNext();)
        names.insert(it.next().captured(1));
    return names;
}

/// What a source calls or defines by a name alone: not of an object, a class or a namespace.
QSet<QString> plainCalls(const QString& text) {
    static const QRegularExpression call(QStringLiteral("(?<![\\w.:>~])(\\w+)\\("));
    QSet<QString> names;
    const QString code = codeOf(text);
    for (auto it = call.globalMatch(code); it.hasNext();)
        names.insert(it.next().captured(1));
    return names;
}

/// "name: a.cpp, b.cpp" for each function that a source keeps to itself and another one calls by that name.
QStringList sharedNames(const QMap<QString, QString>& textOfSource) {
    QMap<QString, QSet<QString>> calls;
    for (auto it = textOfSource.begin(); it != textOfSource.end(); ++it)
        calls[it.key()] = plainCalls(it.value());
    QStringList shared;
    for (auto owner = textOfSource.begin(); owner != textOfSource.end(); ++owner)
        for (const QString& name : ownFunctions(owner.value()))
            for (auto other = calls.begin(); other != calls.end(); ++other)
                if (other.key() != owner.key() && other->contains(name))
                    shared << QStringLiteral("%1: %2, %3").arg(name, owner.key(), other.key());
    return shared;
}

} // namespace

class TestBatches : public QObject {
    Q_OBJECT
private slots:
    void aSharedNameIsFound();
    void noSourceCallsWhatAnotherOfItsBatchKeeps();
};

void TestBatches::aSharedNameIsFound() {
    const QString owner = QStringLiteral("namespace {\n\ndouble half(double x) {\n    return x / 2.0;\n}\n\n"
                                         "} // namespace\ndouble a() {\n    return half(1.0);\n}\n");
    const auto with = [&](const char* other) {
        return sharedNames(
            {{QStringLiteral("a.cpp"), owner}, {QStringLiteral("b.cpp"), QString::fromLatin1(other)}});
    };
    QCOMPARE(with("int b() {\n    return half(1);\n}\n"), QStringList{QStringLiteral("half: a.cpp, b.cpp")});
    QCOMPARE(with("namespace {\nint half(int x) {\n    return x / 2;\n}\n} // namespace\n").size(), 2);
    QCOMPARE(with("static int half(int x) {\n    return x / 2;\n}\n").size(), 2);
    for (const char* other :
         {"int b() {\n    return c.half(1);\n}\n", "int b() {\n    return C::half(1);\n}\n",
          "int b() {\n    return c->half(1);\n}\n", "// half(1)\n", "const char* b = \"half(1)\";\n",
          "int b() {\n    return behalf(1);\n}\n"})
        QCOMPARE(with(other), QStringList());
}

void TestBatches::noSourceCallsWhatAnotherOfItsBatchKeeps() {
    static const QRegularExpression include(
        QStringLiteral("^#include \"(%1/[^\"]+\\.cpp)\"")
            .arg(QRegularExpression::escape(QStringLiteral(CHIRON_SOURCE_DIR))),
        QRegularExpression::MultilineOption);
    int batches = 0;
    QStringList shared;
    for (QDirIterator it(QStringLiteral(CHIRON_BINARY_DIR), {QStringLiteral("unity_*.cxx")}, QDir::Files,
                         QDirIterator::Subdirectories);
         it.hasNext();) {
        QMap<QString, QString> sources;
        const QString batch = textOf(it.next());
        for (auto line = include.globalMatch(batch); line.hasNext();) {
            const QString path = line.next().captured(1);
            if (QFile::exists(path)) // a batch that is no longer in use may name one that is gone
                sources[path.mid(qsizetype(sizeof CHIRON_SOURCE_DIR))] = textOf(path);
        }
        batches += sources.size() > 1 ? 1 : 0;
        shared << sharedNames(sources);
    }
    QVERIFY(batches > 50);
    QVERIFY2(shared.isEmpty(), qPrintable(shared.join(u'\n')));
}

QTEST_APPLESS_MAIN(TestBatches)
#include "test_batches.moc"
