// SPDX-License-Identifier: GPL-3.0-or-later
// The training screen of every level, against what was looked at and kept: how it is made
// (support/screen_outline.h), and what its panels say and draw of moments that are given to them by hand, so
// that nothing is of this run: no session begins, since the screen begins one when it has been painted. A
// change that is meant is kept anew, and the difference is read in review: CHIRON_STORE_OUTLINES=1
// QT_QPA_PLATFORM=offscreen build/release/tests/gui/training/test_kept_training
#include "cues/laparoscopy_cues.h"
#include "desktop/training/control_bar.h"
#include "desktop/training/force_notice.h"
#include "desktop/training/force_words.h"
#include "desktop/training/header_bar.h"
#include "desktop/training/info_view.h"
#include "desktop/training/sound_sign.h"
#include "desktop/training/training_screen.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "support/desktop_fixture.h"
#include "support/drawing_outline.h"
#include "support/kept_text.h"
#include "support/screen_outline.h"

#include <QProgressBar>

#include <algorithm>

using namespace chiron;

namespace {

/// What each panel needs of a moment; each shows what its level lets it show.
haptics::DisplayState working(const QString& exercise) {
    haptics::DisplayState state;
    state.now_ns = 4'000'000'000;
    state.tools = core::kMaxTools;
    for (std::size_t i = 0; i < core::kMaxTools; ++i) {
        haptics::ToolDisplay& tool = state.tool[i];
        const double k = 1.0 + 0.25 * double(i);
        tool.p_WT_m = {0.0123 * k, -0.0342 + 0.004 * double(i), 0.0251 * k};
        tool.p_WProxy_m = {0.0113 * k, -0.0322, 0.0271 * k};
        tool.q_WT = {std::cos(0.35), std::sin(0.35) * 0.6, 0.0, std::sin(0.35) * 0.8};
        tool.tissue = {0.31 * k, -0.42, 0.85 * k, 0.011, -0.024 * k, 0.0042};
        tool.displayPose = {1.23 * k, 0.21, -0.14 * k};
        tool.jaw_rad = 0.31 * k;
        tool.rendersForce = i % 2 == 0;
    }
    state.force = core::ForceState::on;
    state.gain = 1.0;
    state.trial = 1;
    state.phase = core::TrialPhase::running;
    state.timeLeft_s = 12.3;
    state.started = state.objectShown = true;
    if (exercise == "urethra_insertion") {
        auto& scope = state.exercise.own<simulation::EndoscopeCues>();
        scope.present = scope.pictureShown = scope.guided = true;
        scope.stage = simulation::ProcedureStage::insertion;
        scope.depth_m = 0.0612;
        scope.landmarks = 5;
    }
    if (exercise == "elastic_tube" || exercise == "object_handling") {
        auto& grasp = state.exercise.own<core::LaparoscopyCues>();
        grasp.present = grasp.objectShown = grasp.tube = true;
        grasp.step = core::LaparoscopyStep::hold;
        grasp.dwell = 0.41;
        grasp.grips = 2;
        grasp.gripHeldBy = {0, 1, 0};
        grasp.bodies = 3;
        grasp.body[1].heldBy = 1;
        grasp.restLength_m = 0.045;
        grasp.stretch_m = 0.0137;
        grasp.tensionShown = grasp.squeezeShown = grasp.retractionShown = true;
        grasp.tension_N = 1.17;
        grasp.bandLow_N = 1.05;
        grasp.bandHigh_N = 1.35;
        grasp.squeeze_N = {1.3, 0.4, 0.0, 0.0};
        grasp.squeezeLimit_N = 2.0;
        grasp.retraction_N = 0.72;
        grasp.retractionLow_N = 0.6;
        grasp.retractionHigh_N = 1.0;
    }
    if (exercise == "palpation") {
        auto& felt = state.exercise.own<simulation::PalpationCues>();
        felt.present = felt.bandShown = felt.coverageShown = felt.squeezeShown = true;
        felt.asksSize = felt.asksHardness = felt.asksConfidence = true;
        felt.finding[0] = {true, {0.01, 0.02, 0.0}, 0.006, 4, 3};
        felt.finding[2] = {true, {-0.01, 0.01, 0.0}, 0.0, 0, 0};
        felt.selected = 0;
        felt.coverage = 0.374;
        felt.bandLow_N = 0.8;
        felt.bandHigh_N = 2.5;
        felt.depth_m = {0.0041, 0.0023, 0.0, 0.0};
        felt.lean_rad = {0.31, 0.62, 0.0, 0.0};
        felt.squeeze_N = {0.9, 0.2};
    }
    return state;
}

/// The next trial, over every limit, with what went wrong.
haptics::DisplayState overLimits(const QString& exercise) {
    haptics::DisplayState state = working(exercise);
    state.now_ns += 60'000'000;
    for (haptics::ToolDisplay& tool : state.tool) {
        for (double& f : tool.tissue)
            f *= -5.5;
        tool.p_WT_m[2] -= 0.012;
        tool.rendersForce = !tool.rendersForce; // drawn at the surface
        tool.jaw_rad = 0.04;
    }
    state.trial = 2;
    state.timeLeft_s = 3.0;
    state.tick = 4'000;
    state.lateTicks = 3;
    if (exercise == "urethra_insertion") {
        auto& scope = state.exercise.own<simulation::EndoscopeCues>();
        scope.stage = simulation::ProcedureStage::inspection;
        scope.landmarksSeen = 0b101;
        scope.dwell = 0.5;
        scope.depth_m = 0.151;
    }
    if (exercise == "elastic_tube" || exercise == "object_handling") {
        auto& grasp = state.exercise.own<core::LaparoscopyCues>();
        grasp.step = core::LaparoscopyStep::carry;
        grasp.gripHeldBy = {2, 1, 0};
        grasp.foldHeldBy = 4;
        grasp.body[1].heldBy = 2;
        grasp.dwell = 1.3;
        grasp.tension_N = 1.93;
        grasp.squeeze_N = {0.2, 2.6, 0.0, 0.0};
        grasp.retraction_N = 1.4;
    }
    if (exercise == "palpation") {
        auto& felt = state.exercise.own<simulation::PalpationCues>();
        felt.finding[0].present = false;
        felt.finding[2].radius_m = 0.0093;
        felt.finding[2].confidence = 5;
        felt.selected = 2;
        felt.leanSaturated = 0b10;
        felt.coverage = 0.998;
        felt.squeeze_N = {0.3, 4.4};
    }
    return state;
}

/// Between two trials: nothing is shown, and samples were lost.
haptics::DisplayState between(const QString& exercise) {
    haptics::DisplayState state;
    state.now_ns = 9'000'000'000;
    state.trial = 2;
    state.phase = core::TrialPhase::between;
    state.paused = true;
    state.droppedFrames = 2;
    if (exercise == "urethra_insertion") {
        auto& scope = state.exercise.own<simulation::EndoscopeCues>();
        scope.present = true;
        scope.stage = simulation::ProcedureStage::completed;
        scope.landmarks = 5;
        scope.landmarksSeen = 0b11111;
    }
    if (exercise == "elastic_tube" || exercise == "object_handling") {
        auto& grasp = state.exercise.own<core::LaparoscopyCues>();
        grasp.present = true;
        grasp.step = core::LaparoscopyStep::done;
    }
    if (exercise == "palpation") {
        auto& felt = state.exercise.own<simulation::PalpationCues>();
        felt.present = true;
    }
    return state;
}

/// Two seconds of work, as the recorder hands them over; a missed deadline in the middle.
std::vector<session::LiveSample> samplesOf(const haptics::DisplayState& state, double from_s) {
    std::vector<session::LiveSample> samples;
    for (int i = 0; i < 2000; ++i) {
        session::LiveSample sample;
        const double share = i / 2000.0;
        sample.t_s = from_s + 1e-3 * i + (i > 1200 ? 0.4 : 0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            sample.tissue_N[k] = static_cast<float>(share * state.tool[0].tissue[k]);
            sample.p_WT_m[k] = static_cast<float>(state.tool[0].p_WT_m[k]);
        }
        for (std::size_t k = 0; k < 4; ++k)
            sample.q_WT[k] = static_cast<float>(state.tool[0].q_WT[k]);
        sample.tissueNorm_N = static_cast<float>(
            share * std::hypot(state.tool[0].tissue[0], state.tool[0].tissue[1], state.tool[0].tissue[2]));
        sample.speed_m_per_s = static_cast<float>(0.02 * (1.0 - share) + (i % 200 < 100 ? 0.01 : 0.0));
        sample.phase = state.phase;
        sample.paused = state.paused;
        samples.push_back(sample);
    }
    return samples;
}

} // namespace

class TestKeptTraining : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_desktop = std::make_unique<tests::DesktopFixture>();
        m_desktop->logIn("tina");
        m_desktop->window->resize(1280, 720);
    }
    void isMadeAsItWas_data() {
        QTest::addColumn<QVariantMap>("plan");
        QTest::addColumn<double>("scale");
        for (const catalogue::Exercise& exercise : m_desktop->site.catalogue().exercises())
            for (const catalogue::ExerciseLevel& level : exercise.levels) {
                QVariantMap plan{{QStringLiteral("exercise"), QString::fromStdString(exercise.id)},
                                 {QStringLiteral("level"), level.number}};
                const std::string name = exercise.id + " " + std::to_string(level.number);
                QTest::newRow(name.c_str()) << plan << 1.0;
                if (level.number == 1) {
                    plan[QStringLiteral("device")] = QStringLiteral("demonstration");
                    plan[QStringLiteral("operator")] = QStringLiteral("expert");
                    QTest::newRow((name + " watched").c_str()) << plan << 2.0;
                    plan.remove(QStringLiteral("device"));
                    plan[QStringLiteral("familiarisation")] = true;
                    QTest::newRow((name + " familiarisation").c_str()) << plan << 1.0;
                }
            }
    }
    void isMadeAsItWas() {
        QFETCH(QVariantMap, plan);
        QFETCH(double, scale);
        if (m_desktop->context.settings().scale() != scale)
            m_desktop->settings.setScale(scale);
        m_desktop->go(QStringLiteral("training"), plan);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        auto* screen = m_desktop->screen<desktop::TrainingScreen>();
        QVERIFY(screen);
        for (QWidget* widget : screen->findChildren<QWidget*>())
            widget->ensurePolished();
        QStringList now, before;
        const auto take = [&](const char* moment) {
            now << QStringLiteral("-- ") + QLatin1String(moment);
            const QStringList all = outline(*screen);
            for (const QString& line : all)
                if (!before.contains(line))
                    now << line;
            for (const QString& line : before)
                if (!all.contains(line) && std::none_of(all.begin(), all.end(), [&](const QString& other) {
                        return nameIn(other) == nameIn(line);
                    }))
                    now << QStringLiteral("no more ") + nameIn(line);
            before = all;
        };
        take("as it is made");
        const QLocale& locale = m_desktop->context.locale();
        double from_s = 0.0;
        const QString exercise = plan[QStringLiteral("exercise")].toString();
        for (const auto& [moment, state] : {std::pair{"working", working(exercise)},
                                            {"over the limits", overLimits(exercise)},
                                            {"between", between(exercise)},
                                            {"working again", working(exercise)}}) {
            const auto samples = samplesOf(state, from_s);
            from_s += 3.0;
            for (auto* info : screen->findChildren<QFrame*>())
                if (auto* view = dynamic_cast<desktop::InfoView*>(info))
                    for (int frame = 0; frame < 6; ++frame) // what is read in numbers comes every sixth
                        view->show(state, frame == 0 ? std::span<const session::LiveSample>(samples)
                                                     : std::span<const session::LiveSample>());
            screen->findChild<desktop::HeaderBar*>()->show(state);
            screen->findChild<desktop::ForceNotice*>()->show(
                desktop::forceWords(state, {.paused = state.paused}, locale));
            if (auto* sign = screen->findChild<desktop::SoundSign*>()) {
                desktop::SoundCues cues;
                cues.force_N = std::abs(state.tool[0].tissue[2]);
                cues.contacts = state.trial;
                sign->show(cues, !state.paused, state.now_ns);
            }
            auto* controls = screen->findChild<desktop::ControlBar*>();
            controls->setRunning(!state.ended);
            controls->setMain(state.paused          ? desktop::ControlBar::Main::resume
                              : state.lateTicks > 0 ? desktop::ControlBar::Main::rearm
                                                    : desktop::ControlBar::Main::pause);
            controls->setResumeHere(state.paused);
            take(moment);
        }
        QVERIFY2(!screen->feed(), "a session has begun");
        const QString name = QLatin1String(QTest::currentDataTag());
        m_desktop->go(QStringLiteral("settings"));
        const QString differs = m_kept.differs(name, now);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        ++m_held;
    }
    /// What nobody asks for again is no longer kept.
    void keepsNothingOfNoLevel() {
        if (m_held > 1) // not of one row alone
            QCOMPARE(m_kept.unseen(), QStringList());
    }
    void cleanupTestCase() { m_desktop.reset(); }

private:
    /// Of what a line tells.
    static QString nameIn(const QString& line) {
        const QStringList words = line.trimmed().split(QLatin1Char(' '));
        return words.front() == QLatin1String("drawn") || words.front() == QLatin1String("progress")
                   ? words.mid(0, 2).join(QLatin1Char(' '))
                   : words.front();
    }
    /// The screen, and of what draws itself what it draws at a size of its own.
    static QStringList outline(desktop::TrainingScreen& screen) {
        QStringList lines = tests::ScreenOutline::of(screen);
        lines.removeIf([](const QString& line) {
            return line.contains(QLatin1String("QScrollBar")) || line.contains(QLatin1String("524287"));
        }); // Qt's own
        for (QWidget* widget : screen.findChildren<QWidget*>()) {
            const QString kind = QString::fromLatin1(widget->metaObject()->className());
            if (const auto* progress = qobject_cast<QProgressBar*>(widget))
                lines << QStringLiteral("progress %1 \"%2\" \"%3\" \"%4\" %5 of %6 to %7%8")
                             .arg(progress->objectName(), progress->accessibleName(), progress->toolTip(),
                                  progress->format())
                             .arg(progress->value())
                             .arg(progress->minimum())
                             .arg(progress->maximum())
                             .arg(progress->isHidden() ? QStringLiteral(" hidden") : QString());
            if (!kind.startsWith(QLatin1String("chiron::desktop::")) || widget->layout() ||
                !widget->findChildren<QWidget*>().isEmpty() || qobject_cast<QLabel*>(widget) ||
                qobject_cast<QAbstractButton*>(widget))
                continue;
            const QSize size =
                widget->sizeHint().expandedTo(widget->minimumSize()).expandedTo(QSize(240, 16));
            widget->resize(size);
            tests::DrawingOutline drawing(size);
            widget->render(&drawing, {}, {}, QWidget::RenderFlags());
            lines << QStringLiteral("drawn %1#%2 %3x%4: ") // as large as the layout made it for what it says
                             .arg(kind.section(QStringLiteral("::"), -1), widget->objectName())
                             .arg(widget->width())
                             .arg(widget->height()) +
                         drawing.said();
        }
        return lines;
    }

    std::unique_ptr<tests::DesktopFixture> m_desktop;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/training/kept_training.txt")};
    int m_held = 0;
};

QTEST_MAIN(TestKeptTraining)
#include "test_kept_training.moc"
