// SPDX-License-Identifier: GPL-3.0-or-later
// P3's verification on the station screen, started, shown, cancelled, printed.
#include "desktop/station/platform_card.h"
#include "desktop/station/platform_words.h"
#include "desktop/station/station_screen.h"
#include "report/plot_view.h"
#include "support/every_place.h"
#include "support/kept_text.h"
#include "support/screen_outline.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>

using namespace chiron;
using namespace chiron::desktop;
using namespace chiron::tests;

namespace {

PlatformCheck madeCheck(double rmse_N, double error_deg) {
    PlatformCheck check;
    check.verified.rmse_N = check.verified.rmseTrue_N = {rmse_N, rmse_N, rmse_N};
    check.verified.meanRmse_N = rmse_N;
    check.verified.meanError_deg = error_deg;
    check.verified.poses.resize(10);
    for (int i = 0; i < 300; ++i) {
        check.verified.series.time_s.push_back(0.01 * i);
        for (auto* values : {&check.verified.series.reference_N, &check.verified.series.measured_N,
                             &check.verified.series.true_N})
            values->push_back(0.5);
    }
    check.worse.push_back({"delay", 4.0, 0.09, 0.09, 1.2, 1.1, 3.5, false});
    check.fingers.push_back({"thick", check.verified});
    return check;
}

} // namespace

class TestPlatformCheck : public QObject {
    Q_OBJECT
private slots:
    void theScreenVerifiesOffItsOwnThread() {
        DesktopFixture desktop;
        desktop.logIn("ada");
        desktop.go(QStringLiteral("station"), {{QStringLiteral("verify_poses"), 3}});
        QVERIFY(waitUntilLoaded(desktop));
        auto* screen = desktop.screen<StationScreen>();
        QSignalSpy ended(screen, &StationScreen::verificationEnded);
        auto* button = desktop.find<QPushButton>(QStringLiteral("station.verify"));
        QVERIFY(button && button->isEnabled());
        QVERIFY(!desktop.find<QPushButton>(QStringLiteral("station.record"))->isEnabled());
        button->click();
        QVERIFY(!button->isEnabled()); // at once: the window goes on
        QVERIFY(ended.wait(60'000));
        QVERIFY(button->isEnabled());
        QVERIFY(desktop.find<QWidget>(QStringLiteral("station.verdict")));
        QVERIFY(desktop.find<QLabel>(QStringLiteral("station.serial"))
                    ->text()
                    .contains(QStringLiteral("not reported by the device"))); // it is a simulation
        QCOMPARE(desktop.find<QTableWidget>(QStringLiteral("station.fingers"))->rowCount(), 8);
        QVERIFY(desktop.find<report::PlotView>(QStringLiteral("station.sine")));
        QCOMPARE(desktop.find<QTableWidget>(QStringLiteral("station.figures"))->rowCount(), 6);
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("record.pdf"));
        const auto written =
            desktop.find<PlatformCard>(QStringLiteral("station.platform"))
                ->writeRecord(path, {QStringLiteral("ada"), QDateTime::currentDateTime(), {}, {}, {}, {}, 0});
        QVERIFY(written);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.read(5) == "%PDF-" && file.size() > 10'000);
        QVERIFY(!desktop.find<PlatformCard>(QStringLiteral("station.platform"))
                     ->writeRecord(QStringLiteral("/no/such/folder/x.pdf"), {}));
    }

    void whoMayNotRunItLooks() {
        DesktopFixture desktop;
        desktop.logIn("tina");
        desktop.go(QStringLiteral("station"));
        QVERIFY(waitUntilLoaded(desktop));
        if (auto* card = desktop.find<PlatformCard>(QStringLiteral("station.platform")))
            QVERIFY(!card->button());
    }

    void cancelledIsNotAFault() {
        WorkToken token;
        token.cancel();
        const auto check = runPlatformCheck({.poses = 1, .degrade = false}, token);
        QVERIFY(!check);
        QCOMPARE(int(check.error().code), int(core::ErrorCode::cancelled));
    }

    void theVerdictIsInWords() {
        const QLocale locale = QLocale::c();
        QVERIFY(platformVerdict(madeCheck(0.05, 1.0), locale)
                    .contains(QStringLiteral("on 2 of 2 simulated fingers")));
        QVERIFY(platformVerdict(madeCheck(0.08, 1.0), locale).contains(QStringLiteral("on 0 of 2")));
        QVERIFY(platformVerdict(madeCheck(0.05, 2.0), locale).contains(QStringLiteral("on 0 of 2")));
        PlatformCheck one = madeCheck(0.05, 1.0);
        one.fingers[0].verified.largest_N = 4.1;
        QVERIFY(!one.holds() && platformVerdict(one, locale).contains(QStringLiteral("on 1 of 2")));
        QVERIFY(platformVerdict(one, locale).contains(QStringLiteral("at most 4.10 N")));
        for (const PlatformCheck& check : {madeCheck(0.05, 1.0), one}) { // never without saying what it is
            QVERIFY(platformVerdict(check, locale).startsWith(QStringLiteral("A simulation")));
            QVERIFY(!platformVerdict(check, locale).contains(QStringLiteral("better than published")));
        }
        for (const QStringList& line : platformFingers(one, locale).lines)
            QCOMPARE(line.size(), 7);
        const auto table = platformDegradation(madeCheck(0.05, 1.0), locale);
        QCOMPARE(table.lines.at(1),
                 QStringList({"Delay of the force sensors", "× 4", "0.0900 N", "1.20°", "no"}));
        for (const QStringList& line : platformFigures(madeCheck(0.05, 1.0), locale).lines)
            QCOMPARE(line.size(), 4);
    }

    /// The largest error lies within the axis, with room for its bin.
    void theErrorPlotHoldsEveryPose() {
        PlatformCheck check = madeCheck(0.05, 1.0);
        check.verified.poses.back().measuredPitch_rad = core::radFromDeg(5.0);
        const auto drawn = [](const PlatformCheck& of) {
            auto plot = platformErrorPlot(of, report::lightTheme(QLocale::c()));
            plot->resize(400, 300);
            (void)plot->grab();
            return plot;
        };
        const auto plot = drawn(check);
        QVERIFY2(plot->xHigh() > 5.0 && plot->xHigh() < 6.0, qPrintable(QString::number(plot->xHigh())));
        QCOMPARE(plot->xLow(), 0.0);
        check.verified.poses.back().measuredPitch_rad = 0.0;
        QCOMPARE(drawn(check)->xHigh(), 2.5);
    }

    void aCheckIsShownAndReplaced() {
        const Theme theme = Theme::load(ThemeName::dark, 2.0).value();
        PlatformCard card(theme, QLocale::c(), true);
        card.show(madeCheck(0.05, 1.0));
        QVERIFY(card.findChild<QTableWidget*>(QStringLiteral("station.worse")));
        card.showStopped();
        QVERIFY(!card.findChild<QTableWidget*>(QStringLiteral("station.worse")));
        card.showError({core::ErrorCode::badInput, "no such plant"});
    }

    /// Words, tables and plots of the card, against what was read and kept: CHIRON_STORE_OUTLINES=1
    /// QT_QPA_PLATFORM=offscreen build/release/tests/gui/lists/test_platform_check
    void theCardIsMadeAsItWas() {
        tests::KeptText kept(QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/lists/kept_platform.txt"));
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        const QLocale locale(QLocale::English, QLocale::UnitedKingdom);
        PlatformCheck check = madeCheck(0.05, 1.0);
        for (std::size_t i = 0; i < check.verified.poses.size(); ++i) {
            mechanisms::FingertipPosed& pose = check.verified.poses[i];
            const double step = static_cast<double>(i);
            pose.referencePitch_rad = core::radFromDeg(5.0 * step - 20.0);
            pose.measuredPitch_rad = core::radFromDeg(5.1 * step - 20.2);
            pose.referenceRoll_rad = core::radFromDeg(12.0 - 2.0 * step);
            pose.measuredRoll_rad = core::radFromDeg(12.1 - 1.9 * step);
        }
        for (std::size_t i = 0; i < check.verified.series.time_s.size(); ++i) {
            check.verified.series.measured_N[i] = 0.4 + 1e-3 * static_cast<double>(i);
            check.verified.series.true_N[i] = 0.3 + 2e-3 * static_cast<double>(i);
        }
        PlatformCard card(theme, locale, true), seenOnly(theme, locale, false);
        const auto differs = [&kept](const char* name, const QWidget& shown) {
            return kept.differs(QLatin1String(name), tests::ScreenOutline::of(shown));
        };
        QStringList all{differs("nothing is verified yet", card), differs("by a trainee", seenOnly)};
        card.setReady(false);
        all << differs("not ready", card);
        card.show(check);
        all << differs("verified", card);
        check.worse.clear();
        check.serialNumber = "FP-7";
        check.fingers[0].verified.largest_N = 4.1;
        card.show(check);
        all << differs("not on every finger", card);
        card.showStopped();
        all << differs("stopped", card);
        card.showError({core::ErrorCode::badInput, "no such plant"});
        all << differs("failed", card);
        all.removeAll(QString());
        QVERIFY2(all.isEmpty(), qPrintable(all.join(QLatin1Char('\n'))));
        QCOMPARE(kept.unseen(), QStringList());
    }
};

QTEST_MAIN(TestPlatformCheck)
#include "test_platform_check.moc"
