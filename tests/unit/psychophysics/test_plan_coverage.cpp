// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated observers, planning and estimates have one model of every task: what is planned comes back.
#include "core/random.h"
#include "psychophysics/measures/run_curve.h"
#include "psychophysics/measures/sample_moments.h"
#include "psychophysics/planning/fisher_information.h"
#include "psychophysics/planning/study_plan.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <tuple>

using namespace chiron::psychophysics;

class TestPlanCoverage : public QObject {
    Q_OBJECT
private slots:
    void everyTask_data();
    void everyTask();
    void informationOfYesNo();
    void quantilesHaveTheirErrors();
    void aFigureHasTheErrorOfTheSpread();
    void shortRunsWithoutValuesAreCounted();
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
    // Of a median of normal logarithms: √(π/2) of the mean's.
    const double ofMedian =
        std::sqrt(0.5 * std::acos(-1.0)) * std::log(10.0) * plan.sdLog10 * plan.weber50 / std::sqrt(40.0);
    QVERIFY2(plan.weber50Error > 0.4 * ofMedian && plan.weber50Error < 2.5 * ofMedian,
             qPrintable(QString::number(plan.weber50Error / ofMedian)));
    QVERIFY(plan.weber10Error > 0.0 && plan.weber90Error > 0.0);
}

/// Runs of six trials often leave the threshold open; a plan says how often, and how many trials it takes.
/// Long runs do not, and nothing more is simulated for them.
void TestPlanCoverage::shortRunsWithoutValuesAreCounted() {
    Condition condition;
    condition.id = "short";
    condition.task = Task::twoAfc;
    condition.stimulus.reference = 100.0;
    for (int i = 0; i < 8; ++i)
        condition.stimulus.differences.push_back(0.02 * std::pow(1.4, i));
    condition.procedures = {kindFor(StaircaseSpec{}).usual(condition)};
    const ObserverSpec observer{.weber = 0.1, .lapse = 0.02};
    const auto planned = [&](int trials) {
        const auto of = withTrials(condition, trials);
        ConditionPlan plan = planCondition(of.value(), {}, observer, 40, 7);
        examineLength(plan, *of, observer, 7);
        return plan;
    };
    const ConditionPlan six = planned(6);
    qInfo("6 trials: %d of %d without a value; enough: %d", six.withoutValue.value_or(-1), six.runs,
          six.trialsForValues);
    QVERIFY(oftenWithoutValue(six) && six.withoutValue >= six.withoutEstimate);
    QVERIFY(six.trialsForValues > 6 && six.trialsForValues <= 100);
    const ConditionPlan enough = planned(six.trialsForValues);
    QVERIFY(!oftenWithoutValue(enough));
    QCOMPARE(enough.trialsForValues, 0); // there was nothing to look for
    ConditionPlan few = planCondition(withTrials(condition, 6).value(), {}, observer, 39, 7);
    examineLength(few, condition, observer, 7);
    QVERIFY(oftenWithoutValue(few));
    QCOMPARE(few.trialsForValues, 0); // so few runs do not show a rate of 1 in 20
    ConditionPlan apex;
    apex.runs = 40; // nothing is left out of marks
    examineLength(apex, condition, observer, 7);
    QVERIFY(!oftenWithoutValue(apex) && apex.trialsForValues == 0);
    condition.stimulus.attribute = Attribute::apex;
    QVERIFY(!planCondition(condition, {}, observer, 2, 7).withoutValue);
    for (const auto& [without, runs, often] :
         {std::tuple{0, 0, false}, {0, 40, false}, {1, 40, false}, {2, 40, true}, {40, 40, true}}) {
        ConditionPlan plan;
        plan.withoutValue = without;
        plan.runs = runs;
        QCOMPARE(oftenWithoutValue(plan), often);
    }
}

/// The rule of yes-no on the half of its trials that show the difference is that of 2AFC: both percepts are
/// noisy.
void TestPlanCoverage::informationOfYesNo() {
    for (const double d : {0.5, 1.0, 2.0, 4.0})
        QVERIFY(std::abs(fisherInformation(Task::yesNo, d, 0.02) -
                         0.5 * fisherInformation(Task::twoAfc, d, 0.02)) < 1e-9);
}

/// What a quantile varies by when the values are drawn anew, found by drawing them anew; less of more values.
void TestPlanCoverage::quantilesHaveTheirErrors() {
    chiron::core::Random random(7);
    double before = HUGE_VAL;
    for (const std::size_t count : {20u, 80u, 320u}) {
        double errorOfMedian = 0.0;
        for (const double share : {0.1, 0.5, 0.9}) {
            std::vector<double> quantiles, errors;
            for (int again = 0; again < 400; ++again) {
                std::vector<double> values(count);
                std::generate(values.begin(), values.end(),
                              [&] { return 0.12 * std::exp(0.3 * random.normal()); });
                std::sort(values.begin(), values.end());
                quantiles.push_back(quantileOf(values, share));
                errors.push_back(quantileErrorOf(values, share));
            }
            const double told = momentsOf(errors).mean, is = momentsOf(quantiles).sd;
            QVERIFY2(told > 0.75 * is && told < 1.4 * is,
                     qPrintable(QStringLiteral("%1 values, %2: %3").arg(count).arg(share).arg(told / is)));
            errorOfMedian = share == 0.5 ? told : errorOfMedian;
        }
        QVERIFY(errorOfMedian < 0.65 * before);
        before = errorOfMedian;
    }
    QVERIFY(std::isnan(quantileErrorOf({0.1}, 0.5)) && std::isnan(quantileErrorOf({}, 0.5)));
    QCOMPARE(quantileErrorOf(std::vector<double>(30, 0.1), 0.1), 0.0);
}

/// To first order the derivative by the spread, times its error.
void TestPlanCoverage::aFigureHasTheErrorOfTheSpread() {
    const PowerQuestion question{.runSdLog10 = 0.1, .participants = 12};
    const auto linear = [](const PowerQuestion& q) { return 3.0 * q.runSdLog10; };
    QVERIFY(std::abs(figureError(question, 0.02, linear) - 0.06) < 1e-12);
    const auto smallest = [](const PowerQuestion& q) { return detectableRatio(q, 0.8); };
    const double error = figureError(question, 0.02, smallest);
    QVERIFY(error > 0.0 && figureError(question, 0.04, smallest) > error);
    QVERIFY(std::isnan(figureError(question, std::nan(""), smallest)));
    PowerQuestion few = question;
    few.participants = 2;
    few.runSdLog10 = 2.0; // finds nothing
    QVERIFY(std::isnan(figureError(few, 0.02, smallest)));
}

QTEST_APPLESS_MAIN(TestPlanCoverage)
#include "test_plan_coverage.moc"
