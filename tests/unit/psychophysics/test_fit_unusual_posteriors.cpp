// SPDX-License-Identifier: GPL-3.0-or-later
#include "unusual_data.h"

#include <QtTest>

using namespace chiron::psychophysics;
using namespace chiron::tests;

/// Computes the posterior of every function for unusual experiments, with a known and with a free guess rate.
class TestFitUnusualPosteriors : public QObject {
    Q_OBJECT
private slots:
    void isSane_data();
    void isSane();
};

void TestFitUnusualPosteriors::isSane_data() {
    QTest::addColumn<int>("number");
    for (std::size_t i = 0; i < unusualExperiments().size(); ++i) {
        QTest::newRow(unusualExperiments()[i].name) << static_cast<int>(i);
    }
}

void TestFitUnusualPosteriors::isSane() {
    QFETCH(int, number);
    const UnusualData& experiment = unusualExperiments()[static_cast<std::size_t>(number)];
    const PsychometricData data = counts(experiment.right, experiment.of);
    for (int function = 0; function < kSigmoids; ++function) {
        mustBeSane(fitBayesian(data, twoChoices(static_cast<Sigmoid>(function))));
        mustBeSane(fitBayesian(data, yesNo(static_cast<Sigmoid>(function))));
    }
}

QTEST_GUILESS_MAIN(TestFitUnusualPosteriors)
#include "test_fit_unusual_posteriors.moc"
