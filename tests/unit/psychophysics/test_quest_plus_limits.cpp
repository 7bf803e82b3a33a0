// SPDX-License-Identifier: GPL-3.0-or-later
// QUEST+ where the same stimulus stands in the grid more than once.
#include "procedure_runs.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;

class TestQuestPlusLimits : public QObject {
    Q_OBJECT
private slots:
    void repeatLimitCountsStimuliNotRows();
};

/// A stimulus that stands in the grid twice is one stimulus; a run that is limited so is another version's.
void TestQuestPlusLimits::repeatLimitCountsStimuliNotRows() {
    QuestPlusSpec spec = weibull();
    spec.stimuli[0].second = {-2.0, -1.5, -1.0, -1.0, -0.5, 0.0};
    spec.parameters[0].values = even(-1.2, -0.8, 20);
    for (const bool general : {false, true}) {
        spec.parameters[1].nuisance = general;
        for (const int limit : {1, 2}) {
            spec.repeatLimit = limit;
            auto capped = *makeProcedure(spec, 1);
            QCOMPARE(capped->id(), std::string_view("quest_plus@2"));
            double last = 1.0;
            int inARow = 0, most = 0;
            for (int trial = 0; !capped->done(); ++trial) {
                const Choice choice = capped->next();
                inARow = choice.stimulus[0] == last ? inARow + 1 : 1;
                last = choice.stimulus[0];
                most = std::max(most, inARow);
                QVERIFY(capped->record(trial % 3 == 1 ? 0 : 1, choice.stimulus));
            }
            QCOMPARE(most, limit);
        }
    }
    spec.stimuli[0].second = {-1.0, -1.0}; // no other: it has to come again
    auto only = *makeProcedure(spec, 1);
    for (int trial = 0; trial < 5; ++trial)
        QVERIFY(only->next().candidate >= 0 && only->record(1, only->next().stimulus));
    spec.repeatLimit = 0; // no limit, or nothing twice: as ever
    QCOMPARE((*makeProcedure(spec, 1))->id(), std::string_view("quest_plus@1"));
    spec = weibull();
    spec.repeatLimit = 1;
    QCOMPARE((*makeProcedure(spec, 1))->id(), std::string_view("quest_plus@1"));
    Rank3Spec rank3;
    rank3.differences = {0.05, 0.1, 0.1, 0.2};
    rank3.repeatLimit = 1;
    auto ranks = *makeProcedure(rank3, 1);
    QCOMPARE(ranks->id(), std::string_view("rank3_quest_plus@2"));
    for (double last = 0.0; ranks->trials() < 20;) {
        const Stimulus asked = ranks->next().stimulus;
        QVERIFY(asked[0] != last && ranks->record(0, asked));
        last = asked[0];
    }
}

QTEST_APPLESS_MAIN(TestQuestPlusLimits)
#include "test_quest_plus_limits.moc"
