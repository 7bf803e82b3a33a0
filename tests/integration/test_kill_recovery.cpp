// SPDX-License-Identifier: GPL-3.0-or-later
// kill -9 at random moments of real-time sessions: the next start opens, lists the session as interrupted,
// and has every sample but perhaps the one in the making. CHIRON_KILLS sets how many programs die (default 6;
// the long test: 200).
#include "kill_campaign.h"
#include "training_child.h"

#include <QCoreApplication>
#include <QtTest>
#include <atomic>
#include <mutex>
#include <thread>

namespace {
constexpr int kCampaigns = 3; // each with its own database; more would starve the loops of a small machine
constexpr int kFewKills = 6;
constexpr std::uint64_t kSeed = 20261120;
} // namespace

class TestKillRecovery : public QObject {
    Q_OBJECT
private slots:
    void everyKillIsRecovered();
};

void TestKillRecovery::everyKillIsRecovered() {
    const int asked = qEnvironmentVariableIntValue("CHIRON_KILLS");
    const int target = asked > 0 ? asked : kFewKills;
    std::atomic<int> rounds{0};
    std::atomic<int> kills{0};
    std::atomic<std::uint64_t> frames{0};
    std::mutex mutex;
    QStringList faults;
    std::vector<std::thread> campaigns;
    for (int c = 0; c < kCampaigns; ++c) {
        campaigns.emplace_back([&, c] {
            KillCampaign campaign(kSeed + static_cast<std::uint64_t>(c));
            while (kills.load() < target) {
                const int round = rounds++;
                if (target == kFewKills && round >= kFewKills)
                    break;
                const KillMoment moment = round < kKillMoments ? static_cast<KillMoment>(round)
                                                               : campaign.drawMoment(); // each at least once
                const int before = campaign.kills();
                const QString wrong = campaign.round(moment);
                kills += campaign.kills() - before;
                if (wrong.isEmpty())
                    continue;
                const std::lock_guard lock(mutex);
                faults
                    << QString("round %1, moment %2: %3").arg(round).arg(static_cast<int>(moment)).arg(wrong);
                break; // this database is what it is; the others go on
            }
            frames += campaign.frames();
        });
    }
    for (std::thread& campaign : campaigns)
        campaign.join();
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    QVERIFY(kills.load() >= target);
    QVERIFY2(frames.load() > 0, "nothing was recorded by any of them");
    qInfo("%d programs killed, %llu frames stored", kills.load(),
          static_cast<unsigned long long>(frames.load()));
}

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (const auto status = runAsChild(QCoreApplication::arguments()))
        return *status;
    TestKillRecovery test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_kill_recovery.moc"
