// SPDX-License-Identifier: GPL-3.0-or-later
// kill -9 at random moments of a rendered study: each start goes on at the trial; no answer that was stored
// is lost or given twice; at the end the log chooses the same stimuli again, every sitting replays to the
// same bits, and the database is sound. CHIRON_KILLS sets how many programs die at least (default 6; the long
// test: 60).
#include "cli_process.h"

#include "core/random.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTemporaryDir>
#include <QtTest>

namespace {

constexpr int kFewKills = 6;
constexpr std::uint64_t kSeed = 20261123;
constexpr int kSoonest_ms = 60,
              kLatest_ms = 900; // from making the database to well within a sitting, on a machine at rest
constexpr int kMostParticipants = 24;

} // namespace

class TestStudyKill : public QObject {
    Q_OBJECT
private slots:
    void goesOnAtTheTrial();

private:
    QStringList with(const QStringList& arguments) const {
        return arguments + QStringList{"--database", m_folder.filePath("kill.db"), "--json"};
    }
    QStringList run(int participant) const {
        return with({"study", "run", "stiffness_elastic_tube", "--participant",
                     QStringLiteral("S%1").arg(participant, 2, 10, QLatin1Char('0')), "--observer",
                     "weber:0.12,lapse:0.02", "--seed", QString::number(participant)});
    }
    /// Empty, or what is wrong with a run that came to its end.
    QString finish(int participant);
    QTemporaryDir m_folder;
    int m_sittings = 0;
};

QString TestStudyKill::finish(int participant) {
    const CliRun done = runCli(run(participant));
    const QJsonObject told = QJsonDocument::fromJson(done.out).object();
    if (done.exitCode != 0 || !told["runs"][0]["completed"].toBool())
        return QStringLiteral("not completed: ") + QString::fromUtf8(done.err);
    QSet<int> sessions;
    int ordinal = 0;
    for (const QJsonValue& trial : told["trials"].toArray()) {
        if (trial["ordinal"].toInt(-1) != ordinal++)
            return QStringLiteral("trial %1 comes as number %2")
                .arg(trial["ordinal"].toInt())
                .arg(ordinal - 1);
        sessions.insert(trial["session_id"].toInt());
    }
    m_sittings += static_cast<int>(sessions.size());
    for (const int session : sessions)
        if (const CliRun replay = runCli(with({"replay", QString::number(session)})); replay.exitCode != 0)
            return QStringLiteral("session %1 replays otherwise: ").arg(session) +
                   QString::fromUtf8(replay.err);
    return {};
}

void TestStudyKill::goesOnAtTheTrial() {
    const int asked = qEnvironmentVariableIntValue("CHIRON_KILLS");
    const int target = asked > 0 ? asked : kFewKills;
    chiron::core::Random random(kSeed);
    int kills = 0, participants = 0, latest_ms = kLatest_ms;
    while (kills < target || (m_sittings == participants && participants < kMostParticipants)) {
        ++participants;
        bool died = true;
        for (int tries = 0; tries < kFewKills && died; ++tries) { // then whoever it is comes to the end
            died = killCli(run(participants),
                           kSoonest_ms + static_cast<int>(random.below(
                                             static_cast<std::uint64_t>(latest_ms - kSoonest_ms))));
            kills += died ? 1 : 0;
        }
        if (m_sittings == participants - 1) // a busy machine: none got as far as a trial yet
            latest_ms += latest_ms / 2;
        const QString wrong = finish(participants);
        QVERIFY2(
            wrong.isEmpty(),
            qPrintable(
                QStringLiteral("participant %1 after %2 kills: %3").arg(participants).arg(kills).arg(wrong)));
    }
    const CliRun rerun = runCli(with({"study", "rerun", "stiffness_elastic_tube"}));
    QVERIFY2(rerun.exitCode == 0, rerun.err.constData());
    const CliRun verify = runCli(with({"verify"}));
    QVERIFY2(verify.exitCode == 0, (verify.out + verify.err).constData());
    QVERIFY2(m_sittings > participants,
             "no run was ever gone on with: every program died before its first trial");
    qInfo("%d programs killed in %d participants' %d sittings", kills, participants, m_sittings);
}

QTEST_GUILESS_MAIN(TestStudyKill)
#include "test_study_kill.moc"
