// SPDX-License-Identifier: GPL-3.0-or-later
// What the passivity stage does to ordinary work: an expert's sessions are not rendered softer.
#include "support/laparoscopy_session.h"

#include <QtTest>

using namespace chiron;

namespace {

struct Softened final : core::IFrameSink {
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        ++ticks;
        acted += (frame.header.guards & core::guard_bits::kPassivity) != 0 ? 1 : 0;
        most_J = std::max(most_J, frame.header.energyStored_J - frame.header.energySupplied_J);
        return true;
    }
    std::uint64_t ticks = 0, acted = 0;
    double most_J = 0.0; ///< held beyond the plain work put in
};

} // namespace

class TestLaparoscopySoftening : public QObject {
    Q_OBJECT
private slots:
    void anExpertIsLeftAlone_data();
    void anExpertIsLeftAlone();
};

void TestLaparoscopySoftening::anExpertIsLeftAlone_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    for (int level = 1; level <= 5; ++level)
        QTest::addRow("elastic_tube %d", level) << "elastic_tube" << level;
    for (int level = 1; level <= 3; ++level)
        QTest::addRow("object_handling %d", level) << "object_handling" << level;
}

void TestLaparoscopySoftening::anExpertIsLeftAlone() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    Softened seen;
    const auto outcome = support::runLaparoscopy(
        {support::contentLevel(exercise.toStdString(), level, 2), "expert", 3, {}}, &seen);
    qInfo("%llu of %llu ticks softened; at most %.3f mJ held beyond the work put in",
          static_cast<unsigned long long>(seen.acted), static_cast<unsigned long long>(seen.ticks),
          1e3 * seen.most_J);
    QVERIFY(outcome.ran);
    QVERIFY(seen.acted * 1000 <= seen.ticks); // one tick in a thousand
}

QTEST_APPLESS_MAIN(TestLaparoscopySoftening)
#include "test_laparoscopy_softening.moc"
