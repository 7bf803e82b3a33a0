// SPDX-License-Identifier: GPL-3.0-or-later
// Scripted operators are what metrics, gates and the ladder are judged by: they stay as they are until
// somebody says why not. What each did, at every level, against what was stored. Laws move hands, too: after
// a change of either, look at the ladder, then store anew: CHIRON_STORE_OPERATOR_PATHS=1
// build/release/tests/replay/test_operators_are_kept
#include "support/session_fixture.h"

#include "core/fp_environment.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QtTest>

#include <algorithm>
#include <atomic>
#include <cmath>

using namespace chiron;

namespace {

const QString kFile = QStringLiteral(CHIRON_SOURCE_DIR "/tests/replay/operator_paths.json");
constexpr std::uint64_t kSeed = 20261126, kBlock_ticks = 1000;
constexpr std::uint64_t kAll_ticks = 12'000,
                        kLong_ticks = 150'000; ///< every level; the first of each exercise to its end
/// Of a mean over a block. Libraries of mathematics round differently, by some 1e-16 of what a hand
/// perceives.
constexpr double kSame_counts = 0.5, kSameShare = 1e-6;

/// What a session's hands did, in blocks: means of encoder counts, jaw and buttons, when something was marked
/// or done, and what the scene measured of it.
class Deeds final : public core::IFrameSink {
public:
    explicit Deeds(std::uint64_t ticks) : m_ticks(ticks) {}
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        if (m_seen >= m_ticks) {
            enough = true;
            return true;
        }
        const std::size_t per = 2 + core::kMaxQuantities + frame.tools * (core::kMaxCoordinates + 2);
        const std::size_t at = static_cast<std::size_t>(m_seen / kBlock_ticks) * per;
        if (m_sums.size() < at + per)
            m_sums.resize(at + per, 0.0);
        double* sum = m_sums.data() + at;
        const double when = 1.0 + static_cast<double>(m_seen % kBlock_ticks);
        *sum++ += frame.header.events * when;
        *sum++ += frame.header.trial;
        for (const double quantity : frame.header.quantities)
            *sum++ += quantity / kBlock_ticks;
        for (std::uint32_t i = 0; i < frame.tools; ++i) {
            const core::ToolFrame& tool = frame.tool[i];
            for (const std::int32_t count : tool.counts)
                *sum++ += static_cast<double>(count) / kBlock_ticks;
            *sum++ += static_cast<double>(tool.jawCounts) / kBlock_ticks;
            *sum++ += tool.buttons * when;
        }
        ++m_seen;
        return true;
    }
    QJsonArray json() const {
        QJsonArray array;
        for (const double sum : m_sums)
            array.append(QString::number(sum, 'g', 9).toDouble());
        return array;
    }
    std::atomic<bool> enough = false;

private:
    std::uint64_t m_ticks, m_seen = 0;
    std::vector<double> m_sums;
};

bool same(const QJsonArray& a, const QJsonArray& b) {
    if (a.size() != b.size())
        return false;
    for (qsizetype i = 0; i < a.size(); ++i) {
        const double x = a[i].toDouble(), y = b[i].toDouble(), most = std::max(std::abs(x), std::abs(y));
        // Counts are some thousands, quantities mostly below one: each by what it can be told by.
        if (!(std::abs(x - y) <= (most > 100.0 ? kSame_counts : kSameShare * most + 1e-9)))
            return false;
    }
    return true;
}

} // namespace

class TestOperatorsAreKept : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void doesWhatWasStored_data();
    void doesWhatWasStored();
    void cleanupTestCase();

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QSet<QString> m_asked; ///< keys that there are rows for
    QJsonObject m_now;
};

void TestOperatorsAreKept::doesWhatWasStored_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    QTest::addColumn<QString>("who");
    // Everybody at the first level of each exercise, and by turns at the others.
    const QStringList names{QStringLiteral("expert"), QStringLiteral("novice"),
                            QStringLiteral("intermediate"), QStringLiteral("unsafe")};
    for (const catalogue::Exercise& exercise : m_catalogue.exercises()) {
        const auto kind = session::exerciseKind(exercise.id);
        QVERIFY2(kind, exercise.id.c_str());
        const auto there = (*kind)->operatorNames(); // an exercise need not have all four
        const auto isThere = [&](const QString& name) {
            return std::find(there.begin(), there.end(), name.toStdString()) != there.end();
        };
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            for (qsizetype i = 0; i < names.size(); ++i)
                if (isThere(names[i]) && (level.number == 1 || i == level.number % names.size())) {
                    m_asked << QStringLiteral("%1/%2/%3")
                                   .arg(QString::fromStdString(exercise.id))
                                   .arg(level.number)
                                   .arg(names[i]);
                    QTest::addRow("%s %d %s", exercise.id.c_str(), level.number, qPrintable(names[i]))
                        << QString::fromStdString(exercise.id) << level.number << names[i];
                }
    }
}

void TestOperatorsAreKept::doesWhatWasStored() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    QFETCH(QString, who);
    tests::SessionFixture site;
    Deeds deeds(level == 1 && who == QLatin1String("expert") ? kLong_ticks : kAll_ticks);
    session::TrainingRequest request =
        site.request(*m_catalogue.find(exercise.toStdString(), level), who.toStdString(), kSeed);
    request.witness = &deeds;
    request.cancel = &deeds.enough;
    const auto result = site.run(std::move(request));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    const QString key = QStringLiteral("%1/%2/%3").arg(exercise).arg(level).arg(who);
    m_now[key] = deeds.json();
    if (qEnvironmentVariableIsSet("CHIRON_STORE_OPERATOR_PATHS"))
        return;
    QFile file(kFile);
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(kFile));
    const QJsonArray stored = QJsonDocument::fromJson(file.readAll()).object()[key].toArray();
    QVERIFY2(!stored.isEmpty(), "nothing is stored of this operator at this level");
    QVERIFY2(same(m_now[key].toArray(), stored),
             "the operator did something else than what is stored: see the head of this file");
}

void TestOperatorsAreKept::cleanupTestCase() {
    QFile file(kFile);
    if (!qEnvironmentVariableIsSet(
            "CHIRON_STORE_OPERATOR_PATHS")) { // no operator of a shipped exercise goes unnoticed
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(kFile));
        const QStringList stored = QJsonDocument::fromJson(file.readAll()).object().keys();
        QCOMPARE(m_asked, QSet<QString>(stored.begin(), stored.end()));
        return;
    }
    QVERIFY(file.open(QIODevice::WriteOnly));
    QByteArray text = QJsonDocument(m_now).toJson(QJsonDocument::Compact);
    file.write(text.replace("],\"", "],\n\"") + '\n');
}

QTEST_GUILESS_MAIN(TestOperatorsAreKept)
#include "test_operators_are_kept.moc"
