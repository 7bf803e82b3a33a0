// SPDX-License-Identifier: GPL-3.0-or-later
// One source of what metrics are called, and which of them go first.
#include "report/report_text.h"
#include "scoring/metric_catalogue.h"
#include "scoring/undefined_reason.h"
#include "session_report/metric_words.h"
#include "session_report/session_report.h"

#include <QtTest>
#include <set>

using namespace chiron;

class TestMetricWords : public QObject {
    Q_OBJECT
private slots:
    void everyMetricHasATitleOfItsOwnAndAMeaning() {
        std::map<QString, std::string> titles;
        for (const scoring::MetricDefinition& metric : scoring::metricCatalogue()) {
            const std::string id(metric.id);
            const QString title = session_report::metricTitle(QString::fromStdString(id));
            QVERIFY2(title.at(0).isUpper(), qPrintable(title)); // an id with spaces is no title
            QVERIFY2(!session_report::metricMeaning(QString::fromStdString(id)).isEmpty(), id.c_str());
            const auto [known, isNew] = titles.emplace(title, id);
            QVERIFY2(isNew || known->second == id, qPrintable(title));
        }
    }

    void oneValueIsNoMean() {
        const QString mean = QStringLiteral("apex_error_mean");
        QVERIFY(session_report::metricTitle(mean).contains(QStringLiteral("mean")));
        QCOMPARE(session_report::metricTitle(mean, 10), session_report::metricTitle(mean));
        QCOMPARE(session_report::metricTitle(mean, 1), QStringLiteral("Apex error"));
        QVERIFY(!session_report::metricMeaning(mean, 1).contains(QStringLiteral("mean")));
        for (const scoring::MetricDefinition& metric : scoring::metricCatalogue()) {
            const QString id = QString::fromStdString(std::string(metric.id));
            if (id.startsWith(QStringLiteral("force_")) || id.startsWith(QStringLiteral("apex_")) ||
                id == QLatin1String("offset_rms") || id == QLatin1String("alignment_rms") ||
                id == QLatin1String("torque_rms")) // those that lead to a moment of their own
                QVERIFY2(
                    !session_report::momentTitle(id).contains(QStringLiteral("mean"), Qt::CaseInsensitive),
                    qPrintable(session_report::momentTitle(id)));
        }
        QCOMPARE(session_report::momentTitle(QStringLiteral("force_rms")),
                 session_report::metricTitle(QStringLiteral("force_max")));
        QCOMPARE(session_report::momentTitle(QStringLiteral("reversals")),
                 session_report::metricTitle(QStringLiteral("reversals")));
    }

    /// A benchmark is that of the metric's row in this version; a metric without one has none.
    void aBenchmarkComesFromTheRowOfItsMetric() {
        int bands = 0;
        for (const scoring::MetricDefinition& metric : scoring::metricCatalogue()) {
            report::MetricRow row;
            row.id = QString::fromStdString(std::string(metric.id));
            session_report::addPublishedBand(row, metric.version);
            QCOMPARE(row.bandLow.has_value(), metric.published.has_value());
            QCOMPARE(row.bandHigh.has_value(), metric.published.has_value());
            QCOMPARE(row.bandSource.isEmpty(), !metric.published.has_value());
            if (!metric.published)
                continue;
            ++bands;
            QVERIFY(*row.bandLow == metric.published->low && *row.bandHigh == metric.published->high);
            QVERIFY(!session_report::bandSourceText(row.bandSource).isEmpty());
        }
        QVERIFY(bands > 0);
        report::MetricRow unknown;
        unknown.id = QStringLiteral("knitting");
        session_report::addPublishedBand(unknown, 1);
        QVERIFY(!unknown.bandLow && unknown.bandSource.isEmpty());
    }

    void everyReasonHasWords() {
        std::set<QString> said;
        for (const scoring::UndefinedReason& reason : scoring::undefinedReasons()) {
            const scoring::Undefined undefined{reason, {4, 5, 20}};
            const QString words =
                session_report::metricReason(QString::fromStdString(scoring::storedText(undefined)));
            QVERIFY2(!words.isEmpty() && !words.contains(QLatin1Char('%')) && said.insert(words).second,
                     qPrintable(words));
        }
        const QString counts = session_report::metricReason(
            QStringLiteral("only 4 regions with a lump and 5 without: 20 of each are needed"));
        QCOMPARE(counts, QStringLiteral("only 4 regions with a lump and 5 without: 20 of each are needed"));
        QCOMPARE(session_report::metricReason(QStringLiteral("a reason of a later version")),
                 QStringLiteral("a reason of a later version"));
    }

    void whatFailedGoesFirstAndAtMostThreeAreShown() {
        std::vector<report::MetricRow> rows;
        for (const auto& [id, passed] : {std::pair{"a", true}, std::pair{"b", true}, std::pair{"c", true},
                                         std::pair{"d", false}, std::pair{"e", false}}) {
            report::MetricRow row;
            row.id = QLatin1String(id);
            row.passed = passed;
            row.headline = true;
            rows.push_back(row);
        }
        QStringList shown;
        for (const report::MetricRow& row : report::headlineRows(rows))
            shown << row.id;
        QCOMPARE(shown, QStringList({"d", "e", "a"}));
        for (report::MetricRow& row : rows)
            row.headline = false;
        QVERIFY(report::headlineRows(rows).empty());
    }

    void chanceStandsWhereGuessingHasAValue() {
        scoring::ScoreCard card;
        card.metrics = {{"size_error", 1, "mm", 1.2, "", {}}, {"size_error_by_chance", 1, "mm", 1.5, "", {}}};
        QCOMPARE(session_report::chanceOf("size_error", card), std::optional(1.5));
        QCOMPARE(session_report::chanceOf("palpation_d_prime", card), std::optional(0.0));
        QCOMPARE(session_report::chanceOf("palpation_roc_area", card), std::optional(0.5));
        QCOMPARE(session_report::chanceOf("hardness_order", card), std::optional(50.0));
        QVERIFY(!session_report::chanceOf("force_max", card));
        QVERIFY(!session_report::chanceOf("size_error", {}));
    }

    void feltIsToldBesideTheTissue() {
        const QLocale locale = QLocale::c();
        report::ForceFacts force;
        force.tissue_N = 6.2;
        force.felt_N = 4.0;
        QVERIFY(report::feltWords(force, false, locale).contains(QStringLiteral("shown")));
        QVERIFY(!report::feltWords(force, true, locale).contains(QStringLiteral("limited")));
        force.limited_s = 1.25;
        force.firstLimited_s = 12.0;
        const QString words = report::feltWords(force, true, locale);
        for (const char* part : {"6.20", "4.00", "1.25", "12.0"})
            QVERIFY2(words.contains(QLatin1String(part)), qPrintable(words));
        force.beyondChecked = 0.01;
        QVERIFY(
            report::beyondCheckedWords(force, locale).isEmpty()); // one percent is not more than one percent
        force.beyondChecked = 0.0101;
        QVERIFY(!report::beyondCheckedWords(force, locale).isEmpty());
    }
};

QTEST_MAIN(TestMetricWords)
#include "test_metric_words.moc"
