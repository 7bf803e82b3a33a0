// SPDX-License-Identifier: GPL-3.0-or-later
// What a score is told as: people read why a metric has no value in the words of the screens; programs read
// the reason as it is stored.
#include "cli/score_output.h"
#include "scoring/undefined_reason.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QtTest>

using namespace chiron;

class TestScoreOutput : public QObject {
    Q_OBJECT
private slots:
    void aMissingValueIsExplained();
    void everyReasonHasItsWords();
};

namespace {

scoring::MetricValue undefined(const std::string& reason) {
    return {"size_error", 1, "mm", {}, reason, {}};
}

} // namespace

void TestScoreOutput::aMissingValueIsExplained() {
    const std::vector<scoring::MetricValue> metrics{
        undefined("of no lump that was found the size was said"),
        undefined("only 2 regions with a lump and 1 without: 5 of each are needed"),
        undefined("a reason of a later version")};
    const QString text = cli::metricsText(metrics);
    QVERIFY2(text.contains(QStringLiteral("no lump found was given a size")) &&
                 !text.contains(QStringLiteral("was said")),
             qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("only 2 regions with a lump and 1 without: 5 of each are needed")),
             qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("a reason of a later version")), qPrintable(text));
    const QJsonArray json = cli::metricsJson(metrics);
    QCOMPARE(json[0].toObject()["reason"].toString(),
             QStringLiteral("of no lump that was found the size was said"));
}

void TestScoreOutput::everyReasonHasItsWords() {
    for (const scoring::UndefinedReason& reason : scoring::undefinedReasons()) {
        const std::string stored = scoring::storedText({reason, {3, 2, 1}});
        QString words = QString::fromUtf8(reason.words.data(), static_cast<qsizetype>(reason.words.size()));
        for (const int count : {3, 2, 1})
            if (scoring::countsOf(reason) > 0)
                words = words.arg(count);
        const QString text = cli::metricsText({undefined(stored)});
        QVERIFY2(text.contains(words), qPrintable(text + words));
    }
}

QTEST_GUILESS_MAIN(TestScoreOutput)
#include "test_score_output.moc"
