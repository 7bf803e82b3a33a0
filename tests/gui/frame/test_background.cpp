// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/background.h"
#include "support/patience.h"

#include <QThread>
#include <QtTest>

#include <atomic>

using chiron::tests::kPatience_ms;

using namespace chiron;
using desktop::Background;
using desktop::WorkToken;

/// Background runs work off the GUI thread and delivers its result on it.
class TestBackground : public QObject {
    Q_OBJECT
private slots:
    void resultsAreToldOnTheGuiThread();
    void isBusyUntilTheResultIsTold();
    void tellsNobodyWhoIsGone();
    void workMayBeginWork();
    void endsEarlyWhenAsked();
    void saysHowFarItIs();
};

void TestBackground::resultsAreToldOnTheGuiThread() {
    Background background;
    QThread* worked = nullptr;
    QThread* told = nullptr;
    int result = 0;
    background.run(
        this,
        [&worked](WorkToken&) {
            worked = QThread::currentThread();
            return 7;
        },
        [&](int value) {
            told = QThread::currentThread();
            result = value;
        });
    QTRY_COMPARE_WITH_TIMEOUT(result, 7, kPatience_ms);
    QVERIFY(worked && worked != QThread::currentThread());
    QCOMPARE(told, QThread::currentThread());
}

/// When the work has ended, its result still waits in the event queue: the screen does not know it yet, so
/// this is not idle.
void TestBackground::isBusyUntilTheResultIsTold() {
    Background background;
    QVERIFY(background.idle());
    bool told = false;
    background.run(
        this, [](WorkToken&) { return 1; }, [&](int) { told = true; });
    background.cancelAndWait(); // the work has ended
    QVERIFY(!told && !background.idle());
    QTRY_VERIFY_WITH_TIMEOUT(background.idle(), kPatience_ms);
    QVERIFY(told);
}

void TestBackground::tellsNobodyWhoIsGone() {
    Background background;
    bool told = false;
    auto owner = std::make_unique<QObject>();
    background.run(
        owner.get(), [](WorkToken&) { return 1; }, [&](int) { told = true; });
    owner.reset();
    QTRY_VERIFY_WITH_TIMEOUT(background.idle(), kPatience_ms);
    QVERIFY(!told);
}

void TestBackground::workMayBeginWork() {
    Background background;
    int told = 0;
    background.run(
        this, [](WorkToken&) { return 1; },
        [&](int first) {
            background.run(
                this, [first](WorkToken&) { return first + 1; }, [&](int second) { told = second; });
            QVERIFY(!background.idle());
        });
    QTRY_VERIFY_WITH_TIMEOUT(background.idle(), kPatience_ms);
    QCOMPARE(told, 2);
}

void TestBackground::endsEarlyWhenAsked() {
    Background background;
    std::atomic<int> ended{0};
    const auto untilCancelled = [&ended](WorkToken& token) {
        while (!token.cancelled())
            QThread::msleep(1);
        return ++ended;
    };
    const auto one = background.run(this, untilCancelled, [](int) {});
    background.run(this, untilCancelled, [](int) {});
    one->cancel();
    QTRY_COMPARE_WITH_TIMEOUT(ended.load(), 1, kPatience_ms);
    QVERIFY(!background.idle()); // the other one is still running
    background.cancelAndWait();
    QCOMPARE(ended.load(), 2);
}

void TestBackground::saysHowFarItIs() {
    QCOMPARE(WorkToken().done(), 0);
    QCOMPARE(WorkToken().of(), 0); // of work that tells nothing no end is known
    Background background;
    std::atomic<bool> goOn{false};
    const auto token = background.run(
        this,
        [&goOn](WorkToken& now) {
            now.setProgress(3, 10);
            while (!goOn)
                QThread::msleep(1);
            return 0;
        },
        [](int) {});
    QTRY_COMPARE_WITH_TIMEOUT(token->done(), 3, kPatience_ms);
    QCOMPARE(token->of(), 10);
    goOn = true;
    QTRY_VERIFY_WITH_TIMEOUT(background.idle(), kPatience_ms);
}

QTEST_GUILESS_MAIN(TestBackground)
#include "test_background.moc"
