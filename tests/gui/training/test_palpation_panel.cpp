// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/lean_dial.h"
#include "app/exercises/palpation/desktop/palpation_map.h"
#include "app/exercises/palpation/desktop/palpation_panel.h"
#include "app/exercises/palpation/desktop/palpation_words.h"
#include "app/exercises/palpation/desktop/rating_row.h"
#include "app/exercises/palpation/desktop/size_row.h"
#include "app/exercises/palpation/session_report/finger_words.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/sound_sign.h"
#include "desktop/training/target_bar.h"
#include "modules/exercises/palpation/cues/findings_book.h"
#include "simulation/palpation/lean.h"

#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QtTest>
#include <cmath>
#include <numbers>
#include <set>

using namespace chiron;
using namespace chiron::desktop;
using simulation::ReportField;

namespace {

simulation::PalpationParameters level(bool everything = true) {
    simulation::PalpationParameters p;
    p.asksSize = p.asksHardness = p.asksConfidence = everything;
    return p;
}

session::LevelCues allCues() {
    session::LevelCues cues;
    cues.tool = cues.bars = cues.numbers = cues.plots = cues.coverage = true;
    return cues;
}

/// The panel on one side, what a session would do with its reports (FindingsBook) on the other.
struct Bench {
    explicit Bench(simulation::PalpationParameters with = level(), session::LevelCues cues = allCues())
        : parameters(std::move(with)), panel(theme, QLocale::c(), cues, parameters) {
        panel.resize(372, 900);
        panel.setVisible(true);
        QObject::connect(&panel.findings(), &FindingsBox::reported, &panel,
                         [this](ReportField field, unsigned value) {
                             sent.push_back(simulation::reportWord(field, value));
                             book.report(field, value);
                             answer();
                         });
        state.tools = parameters.tools();
        state.phase = core::TrialPhase::running;
        state.exercise.own<simulation::PalpationCues>().present = true;
        state.exercise.own<simulation::PalpationCues>().asksSize = parameters.asksSize;
        state.exercise.own<simulation::PalpationCues>().asksHardness = parameters.asksHardness;
        state.exercise.own<simulation::PalpationCues>().asksConfidence = parameters.asksConfidence;
        answer();
    }
    void mark() {
        book.found({0.01, 0.0, 0.0});
        answer();
    }
    void answer() {
        state.exercise.own<simulation::PalpationCues>().finding = book.list();
        state.exercise.own<simulation::PalpationCues>().selected = book.selected();
        panel.show(state, {});
    }
    template <class W> W* find(const char* name) { return panel.findChild<W*>(QLatin1String(name)); }
    QPushButton* button(const char* name) { return find<QPushButton>(name); }
    bool key(int key) { return panel.findings().key(key); }

    Theme theme = Theme::load(ThemeName::light, 1.0).value();
    simulation::PalpationParameters parameters;
    PalpationPanel panel;
    simulation::FindingsBook book;
    haptics::DisplayState state;
    std::vector<std::uint16_t> sent;
};

} // namespace

class TestPalpationPanel : public QObject {
    Q_OBJECT
private slots:
    void aFindingIsRatedByButtons() {
        Bench bench;
        QVERIFY(bench.find<QLabel>("training.no_findings")->isVisible());
        QVERIFY(!bench.find<RatingRow>("training.hardness")->isEnabled());
        bench.mark();
        QVERIFY(bench.button("training.finding_0")->isVisible() &&
                bench.button("training.finding_0")->isChecked());
        QVERIFY(!bench.button("training.finding_1")->isVisible());
        bench.find<RatingRow>("training.hardness")->findChild<QPushButton*>(QStringLiteral("4"))->click();
        bench.find<RatingRow>("training.confidence")->findChild<QPushButton*>(QStringLiteral("5"))->click();
        bench.find<SizeRow>("training.size")->findChild<QPushButton*>(QStringLiteral("larger"))->click();
        bench.find<SizeRow>("training.size")->findChild<QPushButton*>(QStringLiteral("larger"))->click();
        const simulation::Finding said = bench.book.list()[0];
        QCOMPARE(int(said.hardness), 4);
        QCOMPARE(int(said.confidence), 5);
        QCOMPARE(said.radius_m, 0.0055);
        QCOMPARE(bench.find<RatingRow>("training.hardness")->words(), QStringLiteral("Hardness: firm"));
        QCOMPARE(bench.find<SizeRow>("training.size")->words(), QStringLiteral("Size: 11 mm across"));
        QCOMPARE(bench.find<QLabel>("training.finding")->text(),
                 QStringLiteral("Finding 1: 11 mm across, firm, certain"));
    }

    /// The row shows what the session took, not what was pressed.
    void whatTheSessionRefusesIsNotShown() {
        Bench bench;
        bench.mark();
        bench.panel.findings().disconnect();
        auto* four = bench.find<RatingRow>("training.hardness")->findChild<QPushButton*>(QStringLiteral("4"));
        four->click();
        QVERIFY(!four->isChecked());
    }

    void theSameByKeys() {
        Bench bench;
        QVERIFY(bench.key(Qt::Key_3)); // nothing is selected: nothing is said
        QVERIFY(bench.sent.empty());
        bench.mark();
        bench.key(Qt::Key_2); // hardness first, then confidence by itself
        bench.key(Qt::Key_5);
        bench.key(Qt::Key_Plus);
        bench.key(Qt::Key_Minus);
        QCOMPARE(int(bench.book.list()[0].hardness), 2);
        QCOMPARE(int(bench.book.list()[0].confidence), 5);
        QCOMPARE(bench.book.list()[0].radius_m, 0.0045);
        bench.key(Qt::Key_V);
        bench.key(Qt::Key_4);
        QCOMPARE(int(bench.book.list()[0].hardness), 4);
        bench.mark();
        QCOMPARE(bench.book.selected(), 1);
        bench.key(Qt::Key_N);
        QCOMPARE(bench.book.selected(), 0);
        bench.key(Qt::Key_Delete);
        QVERIFY(!bench.book.has(0) && bench.book.has(1));
        QVERIFY(!bench.key(Qt::Key_Q));
        QVERIFY(!bench.key(Qt::Key_Space));
    }

    /// Where one rating alone is asked, every digit is that one's.
    void theOnlyRatingHasTheDigits() {
        for (const bool hardness : {true, false}) {
            simulation::PalpationParameters one = level(false);
            (hardness ? one.asksHardness : one.asksConfidence) = true;
            Bench bench(one);
            bench.mark();
            for (const int rating : {4, 2}) { // said, and said again
                bench.key(Qt::Key_0 + rating);
                QCOMPARE(int(bench.book.list()[0].hardness), hardness ? rating : 0);
                QCOMPARE(int(bench.book.list()[0].confidence), hardness ? 0 : rating);
            }
            auto* row = bench.find<RatingRow>(hardness ? "training.hardness" : "training.confidence");
            row->findChild<QPushButton*>(QStringLiteral("5"))->click();
            bench.key(Qt::Key_V); // there is no other row
            bench.key(Qt::Key_3);
            QCOMPARE(int(hardness ? bench.book.list()[0].hardness : bench.book.list()[0].confidence), 3);
        }
    }

    void sizeStaysInItsRange() {
        Bench bench;
        bench.mark();
        for (int i = 0; i < 60; ++i)
            bench.key(Qt::Key_Minus);
        QCOMPARE(bench.book.list()[0].radius_m, 0.5e-3 * SizeRow::kLeast_mm);
        for (int i = 0; i < 60; ++i)
            bench.key(Qt::Key_Plus);
        QCOMPARE(bench.book.list()[0].radius_m, 0.5e-3 * SizeRow::kMost_mm);
    }

    void theEndSaysFirstWhatIsMissing() {
        Bench bench;
        bench.mark();
        bench.button("training.done")->click();
        QVERIFY(!bench.book.done());
        QVERIFY(bench.find<QWidget>("training.missing")->isVisible());
        QVERIFY(bench.find<QLabel>("training.missing_text")
                    ->text()
                    .contains(QStringLiteral("Finding 1: size, hardness, confidence")));
        bench.key(Qt::Key_3); // something was said: the question is put anew
        QVERIFY(!bench.find<QWidget>("training.missing")->isVisible());
        bench.key(Qt::Key_D);
        QVERIFY(!bench.book.done());
        QVERIFY(bench.find<QLabel>("training.missing_text")
                    ->text()
                    .contains(QStringLiteral("Finding 1: size, confidence")));
        bench.key(Qt::Key_D);
        QVERIFY(bench.book.done());
    }

    void nothingFoundIsAnAnswer() {
        Bench bench;
        QVERIFY(bench.button("training.done")->text().contains(QStringLiteral("Nothing found")));
        bench.button("training.done")->click();
        QVERIFY(bench.book.done());
        QCOMPARE(bench.sent, (std::vector<std::uint16_t>{simulation::reportWord(ReportField::done, 0)}));
    }

    void onlyWhatTheLevelAsksIsThere() {
        Bench bench(level(false), {});
        bench.mark();
        QVERIFY(!bench.find<QWidget>("training.hardness") && !bench.find<QWidget>("training.size") &&
                !bench.find<QWidget>("training.confidence"));
        QVERIFY(bench.panel.findChildren<TargetBar*>().isEmpty() &&
                bench.panel.findChildren<LeanDial*>().isEmpty());
        QVERIFY(bench.panel.findChildren<LivePlot*>().isEmpty() && !bench.find<QLabel>("training.coverage"));
        bench.key(Qt::Key_4);
        QVERIFY(bench.sent.empty());
        bench.button("training.done")->click();
        QVERIFY(bench.book.done());
    }

    void betweenTrialsNothingCanBeSaid() {
        Bench bench;
        bench.mark();
        bench.state.phase = core::TrialPhase::between;
        bench.answer();
        bench.key(Qt::Key_3);
        bench.key(Qt::Key_D);
        QVERIFY(bench.sent.empty());
        QVERIFY(!bench.button("training.done")->isEnabled() &&
                !bench.button("training.take_back")->isEnabled());
    }

    void everyValueIsShown() {
        simulation::PalpationParameters two = level();
        two.hands = 2;
        Bench bench(two);
        bench.state.tool[0].tissue[2] = 1.2;
        bench.state.tool[1].displayPose = {1.15, 0.3, -0.1};
        bench.state.exercise.own<simulation::PalpationCues>().bandShown = true;
        bench.state.exercise.own<simulation::PalpationCues>().bandLow_N = 0.8;
        bench.state.exercise.own<simulation::PalpationCues>().bandHigh_N = 2.5;
        bench.state.exercise.own<simulation::PalpationCues>().coverage = 0.427;
        bench.state.exercise.own<simulation::PalpationCues>().lean_rad[1] = 0.7;
        bench.state.exercise.own<simulation::PalpationCues>().depth_m[1] = 0.0034;
        bench.state.exercise.own<simulation::PalpationCues>().leanSaturated = 2;
        for (int frame = 0; frame < 12; ++frame)
            bench.answer();
        QCOMPARE(bench.find<TargetBar>("training.force_bar_0")->words(),
                 QStringLiteral("1.20 N, in the band"));
        QCOMPARE(bench.find<QLabel>("training.coverage")->text(), QStringLiteral("Searched: 42 %"));
        QCOMPARE(bench.find<QLabel>("training.finger_1_0")->text(), QStringLiteral("1.15"));
        QCOMPARE(bench.find<QLabel>("training.finger_1_1")->text(), QStringLiteral("40"));
        QCOMPARE(bench.find<QLabel>("training.finger_1_2")->text(), QStringLiteral("3.4"));
        QCOMPARE(bench.find<LeanDial>("training.lean")->accessibleDescription(),
                 QStringLiteral("1: 0°\n2: 18°, at its limit"));
        QVERIFY(bench.find<LivePlot>("training.force_plot") && bench.find<LivePlot>("training.lean_plot"));
    }

    /// Seen from above with the finger pointing up (y_F), the dot goes where the lateral force does.
    void theDotGoesWhereThePlatformLeans() {
        const auto dotUnder = [](double x_N, double y_N) {
            const auto lean = simulation::leanOf({x_N, y_N, 2.0}, core::Vec3::UnitZ(), core::Vec3::UnitX());
            return LeanDial::dotOf(lean.display.pitch_rad, lean.display.roll_rad);
        };
        QVERIFY(dotUnder(0.5, 0.0).x() > 0.1 && std::abs(dotUnder(0.5, 0.0).y()) < 1e-12);
        QVERIFY(dotUnder(-0.5, 0.0).x() < -0.1);
        QVERIFY(dotUnder(0.0, 0.5).y() < -0.1 &&
                std::abs(dotUnder(0.0, 0.5).x()) < 1e-12); // away from the trainee: up on the screen
        QVERIFY(dotUnder(0.0, -0.5).y() > 0.1);
        const QPointF both = dotUnder(0.3, 0.4);
        QVERIFY(std::abs(both.x() / both.y() + 0.75) < 1e-9);
    }

    void theDotStaysInWhatThePlatformCan() {
        constexpr double kDegree = std::numbers::pi / 180.0;
        QVERIFY(std::abs(LeanDial::dotOf(0.0, 40.0 * kDegree).x() - 20.0 * kDegree) < 1e-6);
        QVERIFY(std::abs(LeanDial::dotOf(-40.0 * kDegree, 0.0).y() + 30.0 * kDegree) < 1e-6);
        const QPointF corner = LeanDial::dotOf(30.0 * kDegree, 20.0 * kDegree);
        QVERIFY(std::abs(std::hypot(corner.x(), corner.y()) - 30.0 * kDegree) < 1e-6);
        QVERIFY(std::abs(corner.x() / corner.y() - 2.0 / 3.0) < 1e-9); // shorter, the same way
    }

    void whatSoundsIsSeen() {
        Bench bench;
        SoundSign sign(bench.theme);
        SoundCues cues{.force_N = 0.0, .limit_N = 2.0};
        constexpr std::int64_t kFrame_ns = 16'000'000;
        std::int64_t now_ns = kFrame_ns;
        const auto shown = [&](double force_N, std::uint32_t contacts, bool sounding = true) {
            cues.force_N = force_N;
            cues.contacts = contacts;
            sign.show(cues, sounding, now_ns += kFrame_ns);
            return sign.words();
        };
        QCOMPARE(shown(0.0, 0), QStringLiteral("No tone"));
        QCOMPARE(shown(0.1, 1), QStringLiteral("Contact"));
        now_ns += 500'000'000;
        QCOMPARE(shown(0.1, 1), QStringLiteral("Low tone"));
        QCOMPARE(shown(1.2, 1), QStringLiteral("Medium tone"));
        QCOMPARE(shown(1.9, 1), QStringLiteral("High tone"));
        QCOMPARE(shown(2.01, 2), QStringLiteral("Warning: pressed too hard")); // before a contact
        QCOMPARE(sign.accessibleDescription(), sign.words());
        QCOMPARE(shown(2.01, 3, false), QStringLiteral("No tone")); // paused
        QVERIFY2(!sign.words().contains(QRegularExpression(QStringLiteral("\\d"))),
                 "no numbers: the level has none");
        QCOMPARE(SoundSign::stepsOf(std::nan(""), 2.0), 0);
        QCOMPARE(SoundSign::stepsOf(0.03, 2.0), 1);
        QCOMPARE(SoundSign::stepsOf(50.0, 2.0), SoundSign::kSteps);
    }

    void everyRatingHasItsOwnWord() {
        std::set<QString> words;
        for (int rating = 0; rating <= 5; ++rating) {
            words.insert(hardnessWord(rating));
            words.insert(confidenceWord(rating));
        }
        QCOMPARE(words.size(), std::size_t(11)); // "not given" is shared
        std::set<QString> fingers;
        for (int tool = 0; tool < 4; ++tool)
            fingers.insert(fingerName(tool, 2, 2));
        QCOMPARE(fingers.size(), std::size_t(4));
        // The second finger is on the first one's right: of a right hand the middle one, of a left hand the
        // index finger.
        QCOMPARE(fingerName(1, 2, 2), QString("Right middle finger"));
        QCOMPARE(fingerName(2, 2, 2), QString("Left middle finger"));
        QCOMPARE(fingerName(3, 2, 2), QString("Left index finger"));
        QCOMPARE(fingerName(1, 2, 1), QString("Left index finger"));
        QCOMPARE(fingerName(1, 1, 2), QString("Middle finger"));
    }

    void everyControlHasANameAndAPlaceInTheTabOrder() {
        Bench bench;
        bench.mark();
        for (const auto* button : bench.panel.findChildren<QPushButton*>()) {
            QVERIFY2(!button->accessibleName().isEmpty() || !button->text().isEmpty(),
                     qPrintable(button->objectName()));
            QVERIFY2((button->focusPolicy() & Qt::TabFocus) != 0, qPrintable(button->objectName()));
        }
    }

    /// The live map is of the trial that runs, of every finger, and of nothing outside a running trial.
    void theMapIsThatOfTheTrial() {
        PalpationMap map(level());
        std::vector<session::LiveSample> samples(2);
        samples[0].phase = core::TrialPhase::ready;
        samples[0].press[0] = {0.02f, 0.02f, 1.0f};
        map.take(0, samples);
        QCOMPARE(map.map().coverage(), 0.0);
        samples[1].phase = core::TrialPhase::running;
        samples[1].press[0] = {0.0f, 0.0f, 1.0f};
        samples[1].press[3] = {0.02f, 0.0f, 0.3f}; // too light to count, but touched
        map.take(0, samples);
        const double covered = map.map().coverage();
        QVERIFY(covered > 0.005 && covered < 0.02); // pi 5 mm² of 80 mm squared: 1.2 %
        const double twelfth_m = 0.02 + 1e-6;
        const int column = static_cast<int>((twelfth_m / 0.08 + 0.5) * simulation::SurfaceMap::kColumns);
        QVERIFY(map.map().force_N(column, 24) > 0.29);
        map.take(1, {});
        QCOMPARE(map.map().coverage(), 0.0);
    }
};

QTEST_MAIN(TestPalpationPanel)
#include "test_palpation_panel.moc"
