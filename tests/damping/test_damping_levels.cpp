// SPDX-License-Identifier: GPL-3.0-or-later
// The stricture, where friction, viscosity and injected damping once added up to more than the five-bar
// carries: quiet as the product is, and shaking in some session with the sum left free.
#include "ladder/ladder.h"

#include <QtTest>
#include <algorithm>
#include <cstdio>
#include <random>

using namespace chiron;

class TestDampingLevels : public QObject {
    Q_OBJECT
private slots:
    void theStrictureDoesNotShake();
    void withoutTheBudgetItDoes();

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    std::uint64_t m_first = 1 + std::random_device{}() % 1000000;
};

void TestDampingLevels::theStrictureDoesNotShake() {
    tests::LadderSettings settings;
    settings.seeds = 6 * std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK"));
    settings.first = m_first;
    settings.checkEvery = 0;
    std::printf("seeds from %llu\n", static_cast<unsigned long long>(m_first));
    const tests::LadderLevel climbed = tests::climb(*m_catalogue.find("urethra_insertion", 4), settings);
    std::printf("%s%s", tests::heading().c_str(), tests::lines(climbed).c_str());
    for (const auto& [name, sessions] : climbed.byOperator)
        for (const tests::LadderSession& session : sessions) {
            const QString who = QStringLiteral("%1, seed %2: %3 N")
                                    .arg(QString::fromStdString(name))
                                    .arg(session.seed)
                                    .arg(session.fast_N);
            QVERIFY2(session.fast_N <= 0.1, qPrintable(who));
            QVERIFY2(climbed.law.conservative && session.acted == 0,
                     qPrintable(who)); // nothing to inject for
        }
}

void TestDampingLevels::withoutTheBudgetItDoes() {
    tests::LadderSettings settings;
    settings.seeds = 4;
    settings.first = m_first;
    settings.checkEvery = 0;
    settings.budget_Ns_per_m = 100.0; // friction up to the level's own 50, viscosity 4, injection the rest,
                                      // as when each was bounded alone
    const tests::LadderLevel climbed = tests::climb(*m_catalogue.find("urethra_insertion", 4), settings);
    std::printf("%s%s", tests::heading().c_str(), tests::lines(climbed).c_str());
    double worst = 0.0;
    for (const auto& [name, sessions] : climbed.byOperator)
        for (const tests::LadderSession& session : sessions)
            worst = std::max(worst, session.fast_N);
    QVERIFY2(worst > 0.5, qPrintable(QString::number(worst)));
}

QTEST_GUILESS_MAIN(TestDampingLevels)
#include "test_damping_levels.moc"
