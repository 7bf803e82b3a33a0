// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a sitting, against what was read and kept: how each task is asked and answered key by key,
// what a break says, what the experimenter is told trial after trial, what the places look like. Moments are
// given to them by hand, since a running sitting is of the moment. A change that is meant is kept anew, and
// the difference is read in review: CHIRON_STORE_OUTLINES=1 QT_QPA_PLATFORM=offscreen
// build/release/tests/gui/studies/test_kept_sitting
#include "desktop/questionnaire/questionnaire_form.h"
#include "desktop/study_run/answer_panel.h"
#include "desktop/study_run/break_panel.h"
#include "desktop/study_run/experimenter_panel.h"
#include "desktop/study_run/places_view.h"
#include "desktop/study_run/trials_screen.h"
#include "support/kept_text.h"
#include "support/made_study.h"
#include "support/paint_outline.h"
#include "support/screen_outline.h"

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>

using namespace chiron;
using psychophysics::Task;
using State = session::LiveStudyView::State;

class TestKeptSitting : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_lines.clear();
        m_changes.forget();
    }

    /// Each key that means something to any task, one after the other, open and closed.
    void everyTaskIsAskedAndAnswered() {
        for (int t = 0; t < psychophysics::kTasks; ++t)
            for (const psychophysics::Attribute attribute :
                 {psychophysics::Attribute::stiffness, psychophysics::Attribute::roughness}) {
                const Task task = static_cast<Task>(t);
                desktop::AnswerPanel panel(m_theme, task, attribute);
                say(QStringLiteral("## %1 of %2").arg(t).arg(static_cast<int>(attribute)));
                m_changes.forget();
                connect(&panel, &desktop::AnswerPanel::answered, &panel,
                        [this](int answer, std::optional<double> value) {
                            say(QStringLiteral("answers %1%2")
                                    .arg(answer)
                                    .arg(value ? QStringLiteral(" with %1").arg(*value) : QString()));
                        });
                connect(&panel, &desktop::AnswerPanel::adjusted, &panel,
                        [this](int steps) { say(QStringLiteral("adjusts %1").arg(steps)); });
                connect(&panel, &desktop::AnswerPanel::marksChanged, &panel, [this, &panel] {
                    say(QStringLiteral("marks %1").arg(panel.marks().join(QLatin1Char('/'))));
                });
                panel.show();
                take("as it is made", panel);
                panel.setOpen(false, QStringLiteral("Not yet."));
                take("closed, with a reason", panel);
                panel.enterKey();
                panel.key(Qt::Key_1);
                panel.setOpen(true);
                take("open", panel);
                for (const int key :
                     {int(Qt::Key_2), int(Qt::Key_Equal), int(Qt::Key_2), int(Qt::Key_Backspace),
                      int(Qt::Key_1), int(Qt::Key_Backspace), int(Qt::Key_3), int(Qt::Key_Equal),
                      int(Qt::Key_1), int(Qt::Key_2), int(Qt::Key_4), int(Qt::Key_0), int(Qt::Key_Minus),
                      int(Qt::Key_Plus), int(Qt::Key_N), int(Qt::Key_Y)}) {
                    say(QStringLiteral("key %1%2")
                            .arg(QKeySequence(key).toString(),
                                 panel.key(key) ? QString() : QStringLiteral(" means nothing")));
                    take("then", panel);
                }
                for (const char* number : {"", "0", "-3", "words", "2.5"})
                    if (auto* field = panel.findChild<QLineEdit*>(QStringLiteral("answer.number"))) {
                        field->setText(QLatin1String(number));
                        say(QStringLiteral("types \"%1\"").arg(QLatin1String(number)));
                        panel.enterKey();
                        take("then", panel);
                    }
                panel.enterKey();
                for (auto* button : panel.findChildren<QPushButton*>()) {
                    say(QStringLiteral("clicks ") + button->objectName());
                    button->click();
                    take("then", panel);
                }
                panel.clear();
                take("cleared", panel);
                panel.setOpen(false);
                take("closed again", panel);
            }
        hold("answers");
    }

    void breaksCountDown() {
        desktop::BreakPanel panel(m_theme);
        int acted = 0;
        connect(&panel, &desktop::BreakPanel::acted, &panel, [&acted] { ++acted; });
        take("as it is made", panel);
        panel.say(QStringLiteral("A title"), QStringLiteral("A text"), QStringLiteral("An action"));
        panel.countDown(-1.0, 60.0);
        take("a question", panel);
        panel.show();
        panel.focusButton();
        say(panel.findChild<QPushButton*>(QStringLiteral("break.button"))->hasFocus()
                ? QStringLiteral("the button has the focus")
                : QStringLiteral("no focus"));
        panel.findChild<QPushButton*>(QStringLiteral("break.button"))->click();
        for (const auto& [left_s, of_s] :
             {std::pair{60.0, 60.0}, {44.96, 60.0}, {0.04, 60.0}, {0.0, 60.0}, {5.0, 0.0}}) {
            panel.countDown(left_s, of_s);
            const auto* bar = panel.findChild<QProgressBar*>();
            say(QStringLiteral("-- %1 of %2 s: bar %3 of %4 to %5%6")
                    .arg(left_s)
                    .arg(of_s)
                    .arg(bar->value())
                    .arg(bar->minimum())
                    .arg(bar->maximum())
                    .arg(bar->isHidden() ? QStringLiteral(" hidden") : QString()));
            take("then", panel);
            panel.findChild<QPushButton*>(QStringLiteral("break.button"))->click();
        }
        panel.say(QStringLiteral("No more"), {}, {});
        take("nothing to do", panel);
        say(QStringLiteral("acted %1").arg(acted));
        hold("breaks");
    }

    /// Trial after trial, blind and not, of comparisons and of the apex.
    void theExperimenterIsTold() {
        psychophysics::Condition condition;
        condition.id = "soft";
        condition.title = {{"en", "Soft pads"}, {"de", "Weiche Kissen"}};
        for (const bool blind : {false, true}) {
            say(blind ? QStringLiteral("## blind") : QStringLiteral("## open"));
            m_changes.forget();
            desktop::ExperimenterPanel panel(m_theme, m_locale);
            QStringList asked;
            connect(&panel, &desktop::ExperimenterPanel::spoilAsked, &panel,
                    [&] { asked << QStringLiteral("spoil"); });
            connect(&panel, &desktop::ExperimenterPanel::pauseAsked, &panel,
                    [&] { asked << QStringLiteral("pause"); });
            connect(&panel, &desktop::ExperimenterPanel::stopAsked, &panel,
                    [&] { asked << QStringLiteral("stop"); });
            session::LiveStudyView view;
            session::LiveStudyNumbers numbers;
            numbers.condition = "soft";
            numbers.sealedCode = "QX2";
            numbers.blind = blind;
            numbers.limits = {310.0, 20.0, 4.0, 0.0123, true};
            view.ofAtMost = 40;
            const auto now = [&](const char* moment) {
                panel.show(view, numbers, condition);
                take(moment, panel);
                for (const char* name : {"experimenter.spoil", "experimenter.pause", "experimenter.stop"})
                    panel.findChild<QPushButton*>(QLatin1String(name))->click();
                say(QStringLiteral("asks ") + asked.join(QLatin1Char(' ')));
                asked.clear();
            };
            now("before the first trial");
            view.practice = true;
            view.state = State::exploring;
            numbers.practice = 1;
            numbers.lastFidelity = fidelity(1.0);
            if (blind)
                numbers.lastFidelity = session::withoutForces(numbers.lastFidelity);
            now("a trial of practice");
            view.practice = false;
            view.state = State::answering;
            numbers.lastFidelity = fidelity(1.3);
            numbers.lastFidelity.measured = true;
            if (blind)
                numbers.lastFidelity = session::withoutForces(numbers.lastFidelity);
            else
                numbers.estimates = {estimate("log10_sigma", -1.2, 0.2), estimate("threshold", -0.9, 0.1),
                                     estimate("slope", 2.0, 0.4)};
            numbers.scored = 1;
            now("the first that counts");
            for (const char* spoiled :
                 {"force_error", "stiffness_error", "late_ticks", "saturation", "speed", "peak_force", "time",
                  "untouched", "experimenter", "stopped", "withheld", "of_another_program"}) {
                ++numbers.spoiled;
                numbers.lastSpoiled = spoiled;
                now(spoiled);
            }
            numbers.lastSpoiled.clear();
            numbers.scored = 2;
            numbers.limited = true;
            numbers.candidates = 7;
            numbers.limits.measured = false;
            if (!blind)
                numbers.estimates = {estimate("log10_sigma", -1.1, std::nan("")),
                                     estimate("threshold", -0.8, 0.1), estimate("slope", 2.0, 0.4)};
            now("fewer differences, no interval");
            view.state = State::paused;
            view.ofAtMost = 0;
            numbers.spoiling = true;
            numbers.scored = 3;
            numbers.limits.largestStiffness_N_per_m = std::numeric_limits<double>::infinity();
            condition.scale = psychophysics::ProcedureScale::logDifference;
            now("paused, of no number of trials, shown");
            condition.scale = {};
        }
        for (const auto& [parameter, value] :
             {std::pair{"log10_sigma", -1.3}, {"threshold", 0.05}, {"threshold", -1.1}, {"slope", 1.0}})
            for (const auto scale :
                 {psychophysics::ProcedureScale::logDifference, psychophysics::ProcedureScale{}})
                say(QStringLiteral("Weber of %1 %2 on %3: %4")
                        .arg(QLatin1String(parameter))
                        .arg(value)
                        .arg(static_cast<int>(scale))
                        .arg(desktop::weberOf(parameter, value, scale), 0, 'g', 5));
        hold("experimenter");
    }
    void theExperimenterIsToldOfTheApex() {
        desktop::ExperimenterPanel panel(m_theme, m_locale);
        psychophysics::Condition condition;
        condition.id = "sphere";
        session::LiveStudyView view;
        session::LiveStudyNumbers numbers;
        numbers.condition = "sphere";
        numbers.limits = {310.0, 20.0, 4.0, 0.0123, true};
        std::vector<psychophysics::ApexTrial> marks;
        for (int i = 0; i < 3; ++i) {
            numbers.apex = psychophysics::summariseApex(marks, 0.02, 3);
            numbers.scored = i;
            numbers.spoiled = 1;
            panel.show(view, numbers, condition);
            take("so many marks", panel);
            marks.push_back({0, 0.003 + 0.001 * i, -0.0015 * i});
        }
        hold("experimenter of the apex");
    }

    void placesAreDrawn() {
        for (const bool hooked : {false, true})
            for (const int places : {1, 2, 3}) {
                desktop::PlacesSetup setup;
                setup.places = places;
                setup.hooked = hooked;
                setup.names = desktop::AnswerPanel::placeNames(places);
                desktop::PlacesView view(m_theme, setup);
                view.resize(places == 2 ? QSize(300, 420) : QSize(640, 360));
                haptics::DisplayState state;
                desktop::PlacesView::Now now;
                draw("nothing there yet", view);
                state.tools = 1;
                state.tool[0].p_WT_m = {0.021, 0.006, 0.018};
                state.tool[0].p_WProxy_m = {0.020, 0.005, 0.024};
                state.tool[0].rendersForce = hooked;
                now.objects = true;
                now.place = places - 1;
                now.touched = 1;
                view.show(state, now);
                view.setMarks({QStringLiteral("1 ="), QStringLiteral("2")});
                draw("a place is touched", view);
                now.feltNothing = true;
                now.force_N = 9.0;
                now.place = -1;
                now.objects = false;
                view.show(state, now);
                draw("over the limit, the objects gone", view);
            }
        desktop::PlacesSetup setup;
        setup.visible = false;
        desktop::PlacesView view(m_theme, setup);
        view.resize(640, 360);
        desktop::PlacesView::Now now;
        now.objects = true;
        view.show({}, now);
        draw("not to be seen", view);
        hold("places", &m_drawn);
    }

    void refusalsHaveTheirWords() {
        session::SittingError error(core::Error{core::ErrorCode::badInput, "words of another kind"});
        const auto words = [&] {
            say(QLatin1Char('"') + desktop::TrialsScreen::refusalWords(error, m_locale) + QLatin1Char('"'));
        };
        words();
        error.tooStiff = session::TooStiff{812.4, 311.6};
        words();
        error.otherVersion = true;
        words();
        error.device = session::DeviceRefusal::rendersLess;
        words();
        error.device = session::DeviceRefusal::rendersNone;
        words();
        hold("refusals");
    }

    /// Question after question is answered, wrongly first.
    void questionsAreAsked() {
        psychophysics::StudyDesign study = tests::smallStudy("one");
        study.questionnaires.front().items.push_back({"hours",
                                                      {{"en", "Hours of sleep"}},
                                                      psychophysics::QuestionnaireItem::Kind::number,
                                                      5,
                                                      {},
                                                      {},
                                                      {},
                                                      "",
                                                      0,
                                                      0,
                                                      false});
        desktop::QuestionnaireForm form(m_theme, m_locale, study.questionnaires.front(),
                                        QStringLiteral("en"));
        int changes = 0;
        connect(&form, &desktop::QuestionnaireForm::changed, &form, [&changes] { ++changes; });
        const auto now = [&](const char* moment) {
            const bool missing = form.showMissing();
            take(moment, form);
            QStringList given;
            for (const database::QuestionnaireAnswer& answer : form.answers(4))
                given << QStringLiteral("%1 %2 %3=%4\"%5\"%6")
                             .arg(answer.participant)
                             .arg(QString::fromStdString(answer.questionnaire),
                                  QString::fromStdString(answer.item),
                                  answer.number ? QString::number(*answer.number) : QString(),
                                  QString::fromStdString(answer.text),
                                  answer.utc.empty() ? QStringLiteral(" never") : QString());
            say(QStringLiteral("answered %1 missing %2 changed %3: %4")
                    .arg(form.answered())
                    .arg(missing)
                    .arg(changes)
                    .arg(given.join(QLatin1Char('/'))));
        };
        now("nothing answered");
        form.findChild<QRadioButton*>(QStringLiteral("questionnaire.realism.1"))->click();
        now("the lowest");
        for (const char* years : {"-1", "61", "sixty", "0", "60", " 7.5 "}) {
            form.findChild<QLineEdit*>(QStringLiteral("questionnaire.years"))->setText(QLatin1String(years));
            now(years);
        }
        form.findChild<QRadioButton*>(QStringLiteral("questionnaire.hand.0"))->click();
        now("the first choice");
        form.findChild<QPlainTextEdit*>(QStringLiteral("questionnaire.remarks"))
            ->setPlainText(QStringLiteral("  longer \n"));
        form.findChild<QLineEdit*>(QStringLiteral("questionnaire.hours"))->setText(QStringLiteral("-3"));
        now("all of it, one without bounds");
        hold("questions");
    }

    void nothingElseIsKept() {
        if (m_held > 1)
            QCOMPARE(m_kept.unseen() + m_drawn.unseen(), QStringList());
    }

private:
    void say(const QString& line) { m_lines << line; }
    /// What has changed since it was looked at last; all of it at first.
    void take(const char* moment, const QWidget& widget) {
        say(QStringLiteral("-- ") + QLatin1String(moment));
        m_lines << m_changes.of(tests::ScreenOutline::of(widget));
    }
    void draw(const char* moment, desktop::PlacesView& view) {
        say(QStringLiteral("-- ") + QLatin1String(moment));
        m_lines << tests::OutlineDevice::of(view);
    }
    void hold(const char* name, tests::KeptText* kept = nullptr) {
        const QString differs = (kept ? *kept : m_kept).differs(QLatin1String(name), m_lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        ++m_held;
    }
    static session::TrialFidelity fidelity(double k) {
        session::TrialFidelity trial;
        trial.forceErrorRms_N = 0.031 * k;
        trial.lateTicks = 0.0042 * k;
        trial.saturated = 0.017 * k;
        trial.duration_s = 7.3 * k;
        trial.peakForce_N = 1.91 * k;
        trial.meanSpeed_m_per_s = 0.0412 * k;
        trial.contacts = 5;
        trial.stiffnessError = 0.033 * k;
        return trial;
    }
    static psychophysics::ProcedureEstimate estimate(const char* name, double mean, double half) {
        psychophysics::ProcedureEstimate made;
        made.known = true;
        made.parameters = {{name, mean, 0.5 * half, mean - half, mean + 1.5 * half}};
        return made;
    }

    desktop::Theme m_theme = *desktop::Theme::load(desktop::ThemeName::light, 1.0);
    QLocale m_locale{QLocale::English, QLocale::UnitedKingdom};
    QStringList m_lines;
    tests::LineChanges m_changes;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/studies/kept_sitting.txt")};
    tests::KeptText m_drawn{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/studies/kept_places.txt"),
                            &tests::KeptText::nearly};
    int m_held = 0;
};

QTEST_MAIN(TestKeptSitting)
#include "test_kept_sitting.moc"
