// SPDX-License-Identifier: GPL-3.0-or-later
// A station that cannot be heard: it says why, and a session is shown and recorded as ever.
#include "desktop/sound/sound_loader.h"
#include "gui/training/training_bench.h"
#include "session/session_view.h"
#include "support/looked_back.h"
#include "support/patience.h"

using namespace chiron;
using namespace chiron::tests;

class TestSoundLoader : public QObject {
    Q_OBJECT
private slots:
    void init() { qunsetenv("CHIRON_NO_SOUND"); }

    void silenceSaysWhy_data() {
        QTest::addColumn<QByteArray>("folder");
        QTest::addColumn<QString>("why");
        QTest::newRow("no output") << QByteArray(CHIRON_NO_OUTPUT)
                                   << QStringLiteral("This station has no sound output.");
        QTest::newRow("another version")
            << QByteArray(CHIRON_OTHER_VERSION) << QStringLiteral("another version");
        QTest::newRow("not installed") << QByteArray("/nowhere") << QStringLiteral("not installed");
    }
    void silenceSaysWhy() {
        QFETCH(QByteArray, folder);
        QFETCH(QString, why);
        qputenv("CHIRON_PLUGINS", folder);
        const desktop::LoadedSound sound = desktop::loadSound();
        QVERIFY(!sound.output);
        QVERIFY2(sound.whySilent.contains(why), qPrintable(sound.whySilent));
    }

    void silentAndStillRecorded() {
        qputenv("CHIRON_PLUGINS", CHIRON_NO_OUTPUT);
        TrainingBench bench(1);
        bench.train();
        QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
        auto* mute = bench.desktop.find<QPushButton>(QStringLiteral("training.mute"));
        QVERIFY(mute && !mute->isEnabled());
        QVERIFY2(mute->toolTip().contains(QStringLiteral("no sound output")), qPrintable(mute->toolTip()));
        QVERIFY(bench.text("training.keys").contains(QStringLiteral("no sound output")));
        QTest::keyPress(bench.screen(), Qt::Key_PageDown);
        QTRY_VERIFY_WITH_TIMEOUT(bench.state().tool[0].tissue[2] > 0.1,
                                 kPatience_ms); // something to be heard
        QTest::keyRelease(bench.screen(), Qt::Key_PageDown);
        bench.key(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
        const auto id = bench.desktop.context.navigator()
                            .current()
                            .parameters.value(QStringLiteral("session"))
                            .toLongLong();
        auto connection = bench.desktop.database().openReader();
        QVERIFY(connection);
        auto stored = session::SessionView::open(**connection, bench.desktop.context.actor(), id);
        QVERIFY(stored);
        const auto trace = tests::traceOf(**stored);
        QVERIFY(trace && trace->trials.size() == 1);
        double most_N = 0.0;
        for (const core::Vec3& tissue_N : trace->trials[0].tools[0].tissue_N)
            most_N = std::max(most_N, tissue_N.norm());
        QVERIFY(most_N > 0.1);
    }
};

QTEST_MAIN(TestSoundLoader)
#include "test_sound_loader.moc"
