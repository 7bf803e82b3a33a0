// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated observers, planning and estimates have one model of every task: what is planned comes back.
#include "psychophysics/planning/fisher_information.h"
#include "psychophysics/planning/study_plan.h"

#include <QtTest>
#include <cmath>

using namespace chiron::psychophysics;

class TestPlanCoverage : public QObject {
    Q_OBJECT
private slots:
    void everyTask_data();
    void everyTask();
    void informationOfYesNo();
};

void TestPlanCoverage::everyTask_data() {
    QTest::addColumn<int>("task");
    QTest::addColumn<int>("repeats");
    QTest::newRow("rank3") << static_cast<int>(Task::rank3) << 8;
    QTest::newRow("rank3_ties") << static_cast<int>(Task::rank3Ties) << 8;
    QTest::newRow("2afc") << static_cast<int>(Task::twoAfc) << 20;
    QTest::newRow("3afc") << static_cast<int>(Task::threeAfc) << 15;
    QTest::newRow("oddity") << static_cast<int>(Task::oddity) << 20;
    QTest::newRow("same_different") << static_cast<int>(Task::sameDifferent) << 30;
    QTest::newRow("yes_no") << static_cast<int>(Task::yesNo) << 30;
}

/// 40 runs: bias within three standard errors and 0.03 log10 units, at least 34 intervals hold the true Weber
/// fraction (fewer by chance: 1 in 600).
void TestPlanCoverage::everyTask() {
    QFETCH(int, task);
    QFETCH(int, repeats);
    Condition condition;
    condition.id = "plan";
    condition.task = static_cast<Task>(task);
    condition.stimulus.reference = 100.0;
    ConstantSpec constant;
    for (int i = 0; i < 8; ++i)
        condition.stimulus.differences.push_back(0.02 * std::pow(1.4, i));
    constant.levels = condition.stimulus.differences;
    constant.repeats = repeats;
    condition.scale = ProcedureScale::difference;
    condition.procedures = {constant};
    const ConditionPlan plan = planCondition(condition, {}, {.weber = 0.12, .lapse = 0.02}, 40, 7);
    qInfo("%s: bias %+.3f, sd %.3f log10, covered %.3f", QTest::currentDataTag(), plan.biasLog10,
          plan.sdLog10, plan.coverage);
    QCOMPARE(plan.withoutEstimate, 0);
    QVERIFY(std::abs(plan.biasLog10) < 0.03 + 3.0 * plan.sdLog10 / std::sqrt(40.0));
    QVERIFY(plan.coverage * 40.0 > 33.5);
}

/// The rule of yes-no on the half of its trials that show the difference is that of 2AFC: both percepts are
/// noisy.
void TestPlanCoverage::informationOfYesNo() {
    for (const double d : {0.5, 1.0, 2.0, 4.0})
        QVERIFY(std::abs(fisherInformation(Task::yesNo, d, 0.02) -
                         0.5 * fisherInformation(Task::twoAfc, d, 0.02)) < 1e-9);
}

QTEST_APPLESS_MAIN(TestPlanCoverage)
#include "test_plan_coverage.moc"
