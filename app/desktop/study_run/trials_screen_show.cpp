// SPDX-License-Identifier: GPL-3.0-or-later
// Updates what a participant sees of a study session in each frame: the objects, a break, the reason why no
// answer is accepted.
#include "desktop/study_run/trials_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_run/answer_panel.h"
#include "desktop/study_run/apex_stage.h"
#include "desktop/study_run/break_panel.h"
#include "desktop/study_run/places_view.h"
#include "desktop/study_run/study_controls.h"
#include "desktop/training/felt_words.h"
#include "desktop/training/force_words.h"
#include "desktop/training/key_filter.h"
#include "session/study/participant_view.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <cmath>

namespace chiron::desktop {

using State = session::LiveStudyView::State;

namespace {
constexpr int kFreeMinuteEnds_s = 10; // announced this long before the end, to finish the current action

/// In one line, without those that are empty.
QString sentences(QStringList texts) {
    texts.removeAll(QString());
    return texts.join(QLatin1Char(' '));
}

} // namespace

/// In large texts the code stays on one line: a line break within it looks like two words.
QString TrialsScreen::participantCode() const {
    constexpr QChar kWordJoiner(0x2060);
    return isLarge()
               ? QString(m_participant).replace(QLatin1Char('-'), QLatin1Char('-') + QString(kWordJoiner))
               : m_participant;
}

void TrialsScreen::showState(const session::LiveStudyView& view) {
    m_progress->setValue(view.ofAtMost > 0 ? 100 * view.trial / view.ofAtMost : 0);
    m_progress->setVisible(view.ofAtMost > 0 && !isLarge()); // the line below tells the trial
    const QString pilot =
        m_live->design().pilotOf.empty() ? QString() : tr("Pilot run") + QStringLiteral(" · ");
    const bool once = isLarge(); // the line below tells the rest
    m_note->setText(pilot + (once ? tr("Participant %1").arg(participantCode())
                             : view.tryLeft_s > 0.0
                                 ? tr("Participant %1 · free minute").arg(participantCode())
                             : view.practice ? tr("Participant %1 · practice").arg(participantCode())
                                             : tr("Participant %1").arg(participantCode())));
    const bool changed = view.state != m_state;
    m_state = view.state;
    const bool scene = view.state == State::trying || view.state == State::coming ||
                       view.state == State::arming || view.state == State::exploring ||
                       view.state == State::answering || view.state == State::feedback;
    if (scene) {
        if (m_stage->currentWidget() != m_trial) {
            m_stage->setCurrentWidget(m_trial);
            m_early.wentOn(m_clock.elapsed());
            // Enter answers, and cannot press a button that had the focus.
            area().setFocus(Qt::OtherFocusReason);
            capturePointer();
        }
        showScene(view);
    } else {
        const bool comes = m_stage->currentWidget() != m_break;
        if (comes)
            freePointer();
        showBreak(view);
        if ((comes || changed) && !(view.state == State::paused && m_pausedByKey))
            cameByItself();
    }
    m_pausedByKey = false;
    m_keys->setHeld(!scene);
    hearMasking(scene);
    if (changed && m_answers && view.state == State::coming)
        m_answers->clear();
}

/// A page has appeared that the participant did not call: a key that was pressed before it could be seen
/// presses nothing on it.
void TrialsScreen::cameByItself() {
    if (!m_page->isVisible())
        return;
    m_page->setFocus(Qt::OtherFocusReason);
    m_break->repaint(); // so that the time begins when the page can be seen
    m_changed.start();
}

bool TrialsScreen::noisePlays() const {
    return m_masking && m_live->design().trial.maskingSound && m_sound.works();
}

/// Plays the masking noise, and records in the run whether it was audible.
void TrialsScreen::hearMasking(bool scene) {
    using session::TrialCircumstances;
    const bool wanted = m_masking && m_live->design().trial.maskingSound;
    if (m_live->design().trial.maskingSound)
        m_sound.mask(wanted && scene);
    m_live->setMasking(!wanted        ? TrialCircumstances::kMaskingOff
                       : noisePlays() ? TrialCircumstances::kMaskingNoise
                                      : TrialCircumstances::kMaskingSilent);
}

void TrialsScreen::showSilence() {
    m_noSound->setVisible(m_live->design().trial.maskingSound && !m_sound.works());
}

/// Gives the number of trials, exact or at most, but not the state of a staircase.
QString TrialsScreen::trialText(const session::LiveStudyView& view) const {
    // The strip keeps the text of the trial that was just answered, or of the last one.
    if (view.state == State::feedback || (view.ofAtMost > 0 && view.trial >= view.ofAtMost))
        return m_strip->text();
    const QLocale locale = context().locale();
    const QString number = locale.toString(view.trial + 1);
    const QString most = locale.toString(view.ofAtMost);
    const bool fixed = session::trialsAreFixed(m_live->condition());
    const QString which = view.ofAtMost <= 0 ? tr("Trial %1").arg(number)
                          : fixed            ? tr("Trial %1 of %2").arg(number, most)
                                             : tr("Trial %1 of at most %2").arg(number, most);
    return view.trial == 0 ? tr("%1. From now on every answer counts.").arg(which) : which;
}

/// Updates the strip for the free minute and the feedback of practice.
void TrialsScreen::showStrip(const session::LiveStudyView& view) {
    const bool free = view.tryLeft_s > 0.0; // also while its objects come
    const bool trying = view.state == State::trying;
    const int left_s = static_cast<int>(std::ceil(view.tryLeft_s));
    const bool ends = free && left_s <= kFreeMinuteEnds_s;
    m_strip->setText(
        ends
            ? tr("The free minute ends in %n second(s). Then you say when the trials begin.", nullptr, left_s)
        : free ? tr("Free minute: try the controls. Nothing counts yet. %n second(s) left.", nullptr, left_s)
        : view.mayTakeBack ? tr("Practice: this answer does not count. Press Next to go on, or take it back "
                                "if it was a slip.")
        : view.practice    ? tr("Practice: nothing counts yet.")
                           : trialText(view));
    m_repeated->setText(free ? QString() : repeatedText(view));
    m_repeated->setVisible(!isLarge() || !m_repeated->text().isEmpty());
    if (view.mayTakeBack)
        m_takeBack->setText(takeBackText(view));
    m_takeBack->setVisible(view.mayTakeBack);
    m_enough->setText(trying ? tr("I am ready (Enter)") : tr("Next (Enter)"));
    const bool offered = trying || view.mayTakeBack;
    if (offered && m_enough->isHidden())
        m_changed.start(); // Enter presses this button from now on
    m_enough->setVisible(offered);
    const double most_s = m_live->design().trial.exploreLimit_s;
    m_time->setVisible(!free && view.timeLeft_s > 0.0);
    if (most_s > 0.0) {
        m_time->setFormat(
            tr("%1 s left").arg(context().locale().toString(static_cast<int>(std::ceil(view.timeLeft_s)))));
        m_time->setValue(static_cast<int>(std::lround(100.0 * view.timeLeft_s / most_s)));
    }
}

/// Names the answer, so that nobody takes back another one than they think.
QString TrialsScreen::takeBackText(const session::LiveStudyView& view) const {
    const psychophysics::Attribute attribute = m_live->condition().stimulus.attribute;
    const QString given = m_apex ? tr("the mark")
                                 : study_words::answer(view.task, attribute, view.practiceAnswer,
                                                       view.practiceValue, context().locale());
    return given.isEmpty() ? tr("Take back (⌫)") : tr("Take back: %1 (⌫)").arg(given);
}

/// Names of the objects in `places`, one bit per place.
static QString namesOfPlaces(const session::LiveStudyView& view, std::uint32_t places) {
    const QStringList names = AnswerPanel::placeNames(view.places);
    QStringList said;
    for (int place = 0; place < names.size(); ++place)
        if (((places >> place) & 1U) != 0)
            said << names.at(place);
    return said.join(QStringLiteral(", "));
}

/// Names of the objects that have not been touched yet.
static QString missingObjects(const session::LiveStudyView& view) {
    return namesOfPlaces(view, ~view.touched);
}

/// Says that objects that were only grazed, or are held without being pulled, need more force. It does not
/// say how far an object yields to that force. An object that is lifted always pulls with its whole weight.
static QString harderWords(const session::LiveStudyView& view, Handling handling, const QLocale& locale) {
    const std::uint32_t light = view.grazed & ~view.touched;
    const std::uint32_t here = view.place >= 0 ? light & (1U << view.place) : light;
    if (handling == Handling::lift || view.probe_N <= 0.0 || here == 0 ||
        (view.place < 0 && light != (~view.touched & ((1U << view.places) - 1U))))
        return {};
    const QString force = study_words::plainNumber(view.probe_N, locale);
    const bool pulls = handling == Handling::pull;
    if (view.places == 1)
        return pulls ? TrialsScreen::tr("Pull a little harder: at least %1 N.").arg(force)
                     : TrialsScreen::tr("Press a little harder: at least %1 N.").arg(force);
    return pulls ? TrialsScreen::tr("Pull a little harder on %1: at least %2 N.")
                       .arg(namesOfPlaces(view, here), force)
                 : TrialsScreen::tr("Press a little harder on %1: at least %2 N.")
                       .arg(namesOfPlaces(view, here), force);
}

/// Says what the tool holds or has just let go of, and what to do with it. Empty if it has held nothing in
/// this trial.
QString TrialsScreen::holdWords(const session::LiveStudyView& view) const {
    const int place = view.place >= 0 ? view.place : view.letGo;
    if (!takesHold(handling()) || place < 0)
        return {};
    const QString name = namesOfPlaces(view, 1U << place);
    const bool one = view.places == 1;
    if (view.place < 0)
        return one ? tr("You let go of the object. Raise the tool.")
                   : tr("You let go of object %1. Raise the tool.").arg(name);
    if (handling() == Handling::lift)
        return liftSentence(view.lift, one ? QString() : name, hand(), letGo(), context().locale());
    const QString holding =
        one ? tr("You are holding the object.") : tr("You are holding object %1.").arg(name);
    if (((view.touched >> place) & 1U) != 0)
        return holding + QLatin1Char(' ') +
               letGoSentence(m_live->condition().stimulus.attribute, hand(), letGo(), context().locale());
    return holding + QLatin1Char(' ') +
           (hand().pointer ? tr("Pull it up: roll the wheel away from you, or hold Page Up.")
                           : tr("Pull it up."));
}

QString TrialsScreen::gentlerText(const session::LiveStudyView& view) const {
    if (!view.nearForceLimit)
        return {};
    const bool trying = view.state == State::trying;
    switch (handling()) {
    case Handling::lift:
        return trying ? tr("Press the object less hard onto the table.")
                      : tr("Press the object less hard onto the table in this trial.");
    case Handling::pull:
        return trying ? tr("Pull less hard.") : tr("Pull less hard in this trial.");
    case Handling::press:
    case Handling::stroke:
        break;
    }
    return trying ? tr("Press less hard.") : tr("Press less hard in this trial.");
}

/// The reason that held, in words of the movement: an object that was not let go kept the others from being
/// explored, and no force was too small.
static QString untouchedWords(session::LiveStudyView::Missed missed, Handling handling, double probe_N,
                              const QLocale& locale) {
    using Missed = session::LiveStudyView::Missed;
    if (missed == Missed::held)
        return handling == Handling::lift
                   ? TrialsScreen::tr(
                         "The time ended while you were still holding an object: put it down and "
                         "let go of it to lift the next one.")
                   : TrialsScreen::tr(
                         "The time ended while you were still holding an object: let go of it to "
                         "explore the next one.");
    const bool light = missed == Missed::tooLight;
    if (handling == Handling::lift)
        return light
                   ? TrialsScreen::tr("The time ended before every object was lifted: one of them was held, "
                                      "but stayed on the table.")
                   : TrialsScreen::tr("The time ended before every object was lifted.");
    if (light && probe_N > 0.0) {
        const QString force = study_words::plainNumber(probe_N, locale);
        return (handling == Handling::pull
                    ? TrialsScreen::tr("You did not pull every object hard enough in time: at least %1 N.")
                    : TrialsScreen::tr("You did not press every object hard enough in time: at least %1 N."))
            .arg(force);
    }
    return handling == Handling::pull ? TrialsScreen::tr("The time ended before every object was pulled.")
                                      : TrialsScreen::tr("The time ended before every object was touched.");
}

/// Tells the participant how to move differently.
static QString handWords(const std::string& did, Handling handling) {
    if (did == "speed")
        return TrialsScreen::tr("You moved too fast. Move more slowly.");
    if (handling == Handling::lift)
        return TrialsScreen::tr("You pressed an object too hard onto the table. Put it down more gently.");
    return handling == Handling::pull ? TrialsScreen::tr("You pulled too hard. Pull more gently.")
                                      : TrialsScreen::tr("You pressed too hard. Press more gently.");
}

/// A procedure that depends on each answer repeats the same objects at once; a list continues and repeats
/// them later.
QString TrialsScreen::comesAgainText() const {
    return m_apex || session::trialsAreFixed(m_live->condition()) ? tr("It comes again later.")
                                                                  : tr("The same objects come again.");
}

/// A participant learns only the kind of reason: what they can do differently, or that it was not their
/// fault. The experimenter's view names the exceeded limit.
QString TrialsScreen::repeatedWords(const std::string& reason, session::LiveStudyView::Missed missed,
                                    Handling handling, double probe_N, const QLocale& locale) {
    if (reason == "untouched")
        return untouchedWords(missed, handling, probe_N, locale);
    if (reason == "speed" || reason == "peak_force")
        return handWords(reason, handling);
    if (reason == "time")
        return tr("No answer came in time.");
    if (reason == "experimenter")
        return tr("The experimenter discarded it.");
    return tr("The device did not work accurately enough. This was not your fault.");
}

QString TrialsScreen::repeatedText(const session::LiveStudyView& view) const {
    const auto words = [&](const std::string& reason) {
        return repeatedWords(reason, view.missed, handling(), view.probe_N, context().locale());
    };
    if (view.practice && !view.unanswered.empty())
        return tr("%1 This practice trial comes again.").arg(words(view.unanswered));
    if (view.repeated.empty() || view.practice)
        return {};
    return tr("The last trial did not count. %1 %2").arg(words(view.repeated), comesAgainText());
}

QString TrialsScreen::whyNoAnswer(const session::LiveStudyView& view) const {
    const QString comeOff = comeOffSentence(m_live->condition().stimulus.attribute, hand());
    switch (view.state) {
    case State::trying:
        return view.nearForceLimit ? gentlerText(view) : tryingWords(view);
    case State::coming:
        if (!repeatedText(view).isEmpty()) // the line above says what happened to the previous ones
            return sentences({tr("The next objects are coming."), comeOff});
        return sentences(
            {view.hand.empty() ? QString() : handWords(view.hand, handling()),
             view.hand.empty() ? tr("The next objects are coming.") : tr("These objects come again."),
             comeOff});
    case State::arming:
        return tr("Hold still for a moment, then you can go on.");
    case State::feedback:
        if (!view.hand.empty())
            return handWords(view.hand, handling());
        return !view.right ? QString() : *view.right ? tr("Correct.") : tr("Wrong.");
    case State::exploring:
        return exploringWords(view);
    case State::answering:
        return tr("The time to explore is over. Answer now.");
    default:
        return {};
    }
}

/// Each step of the free minute, at the moment at which it comes.
QString TrialsScreen::tryingWords(const session::LiveStudyView& view) const {
    if (const QString held = holdWords(view); !held.isEmpty())
        return held;
    const QString begin = beginSentence(m_live->condition().stimulus.attribute, hand());
    if (view.place < 0)
        return sentences({begin, tr("You will answer here once the trials begin.")});
    const QString raise = hand().pointer
                              ? tr("Raise the tool: roll the wheel away from you, or hold Page Up.")
                              : tr("Raise the handle.");
    if (handling() != Handling::stroke)
        return sentences({tr("You are pressing the object."), raise});
    return sentences({hand().pointer ? tr("You are touching the object. Move the mouse to stroke it.")
                                     : tr("You are touching the object. Move the handle to stroke it."),
                      raise});
}

/// Which objects still have to be explored, and how to begin with one. The verb is that of the movement.
QString TrialsScreen::missingWords(const session::LiveStudyView& view) const {
    const bool first = view.touched == 0;
    const QString missing = missingObjects(view);
    switch (handling()) {
    case Handling::lift:
        return view.places == 1 ? tr("Lift the object first.")
               : first          ? tr("Lift first: %1.").arg(missing)
                                : tr("Lift next: %1.").arg(missing);
    case Handling::pull:
        return view.places == 1 ? tr("Pull the object first.")
               : first          ? tr("Pull first: %1.").arg(missing)
                                : tr("Pull next: %1.").arg(missing);
    case Handling::press:
    case Handling::stroke:
        break;
    }
    return view.places == 1 ? tr("Touch the object first.")
           : first          ? tr("Touch first: %1.").arg(missing)
                            : tr("Touch next: %1.").arg(missing);
}

/// With what the force grows on a device whose handle cannot be pushed.
QString TrialsScreen::hardnessHow() const {
    if (!hand().pointer)
        return {};
    return handling() == Handling::pull ? tr("Roll the wheel away from you, or hold Page Up.")
                                        : tr("Roll the wheel towards you, or hold Page Down.");
}

/// The largest force is told beside what is missing, because it stays until the trial ends. Only a force that
/// is too small is told alone: both together would contradict each other. What is held is told until the end,
/// because somebody who can answer may want to explore an object again.
QString TrialsScreen::exploringWords(const session::LiveStudyView& view) const {
    const QString held = holdWords(view);
    if (view.canAnswer)
        return sentences({gentlerText(view), held.isEmpty()
                                                 ? tr("You can answer now, or explore further.")
                                                 : tr("You can answer now.") + QLatin1Char(' ') + held});
    if (missingObjects(view).isEmpty())
        return sentences({gentlerText(view), held});
    if (const QString harder = harderWords(view, handling(), context().locale()); !harder.isEmpty())
        return sentences({harder, hardnessHow()});
    const bool here = view.place >= 0 && ((view.touched >> view.place) & 1U) == 0;
    if (here && !held.isEmpty())
        return sentences({gentlerText(view), held});
    const QString begin = view.place < 0 && held.isEmpty()
                              ? beginSentence(m_live->condition().stimulus.attribute, hand())
                              : QString();
    return sentences({gentlerText(view), held, missingWords(view), begin});
}

/// How the tool meets what cannot be seen; empty once it did.
QString TrialsScreen::meetWords(const session::LiveStudyView& view) const {
    if (view.touched != 0)
        return {};
    return hand().pointer ? tr("Lower the tool until the force rises: roll the wheel towards you, or hold "
                               "Page Down.")
                          : tr("Lower the tip until it meets the sphere.");
}

QString TrialsScreen::apexWords(const session::LiveStudyView& view) const {
    switch (view.state) {
    case State::trying:
        return view.nearForceLimit ? gentlerText(view)
                                   : sentences({tr("Find the highest point, and mark it."), meetWords(view)});
    case State::coming:
        return sentences({tr("The next sphere is coming."),
                          comeOffSentence(m_live->condition().stimulus.attribute, hand())});
    case State::feedback:
        return tr("%1 mm from the highest point.")
            .arg(study_words::number(1e3 * view.beside_m.value_or(0.0), context().locale(), 2));
    case State::exploring:
        return sentences(
            {gentlerText(view),
             view.canAnswer ? tr("Click or press Enter at the highest point.") : tr("Find the sphere first."),
             meetWords(view)});
    default:
        return whyNoAnswer(view);
    }
}

/// Somebody who freed the pointer, to click an answer, wonders why the mouse moves the tool no more.
QString TrialsScreen::pointerWords(const session::LiveStudyView& view) const {
    const bool explores = view.state == State::trying || view.state == State::exploring;
    if (!explores || !m_pointer || m_pointer->captured())
        return {};
    return tr("The pointer is free: click in the scene to move the tool with the mouse again.");
}

void TrialsScreen::showScene(const session::LiveStudyView& view) {
    haptics::DisplayState state;
    m_live->training().display().read(state);
    showStrip(view);
    if (m_apex) {
        m_early.look(state, m_clock.elapsed());
        m_apex->show(state, view.canAnswer, sentences({apexWords(view), pointerWords(view)}));
        return;
    }
    PlacesView::Now now;
    now.objects =
        view.state == State::trying || view.state == State::exploring || view.state == State::arming;
    now.touched = view.touched;
    now.place = view.place;
    now.feltNothing = !m_live->training().felt();
    const core::Array6& tissue = state.tool[0].tissue;
    now.force_N = std::hypot(tissue[0], tissue[1], tissue[2]);
    now.limit_N = m_live->design().fidelity.peakForce_N;
    now.lift_m = view.lift_m;
    m_places->show(state, now);
    m_hasLetGo = m_hasLetGo || (view.state == State::trying && view.letGo >= 0);
    m_answers->setOpen(view.canAnswer, sentences({whyNoAnswer(view), pointerWords(view)}));
}

/// Why the supervisor removed force although nobody stopped it.
QString TrialsScreen::stoppedText() const {
    const haptics::DisplayState& state = m_live->training().display().latest();
    const QString kept = tr("The clock is stopped and everything so far is kept. Press R to go on, or Esc "
                            "to stop the session.");
    if (state.force != core::ForceState::fault)
        return kept;
    return forceWords(state, {}, context().locale()).title + QLatin1Char('\n') + kept;
}

/// Trials that count go on by themselves, other than those of practice.
QString TrialsScreen::countingText() const {
    return m_live->design().trial.practiceTrials > 0
               ? tr("Unlike in practice, the next trial comes by itself after each answer: there is no Next, "
                    "and no answer can be taken back. Press Continue when you are ready.")
               : tr("The next trial comes by itself after each answer, and no answer can be taken back. "
                    "Press "
                    "Continue when you are ready.");
}

/// Explains what follows the free minute.
QString TrialsScreen::triedText() const {
    const QString next =
        m_live->design().trial.practiceTrials > 0
            ? tr("What you tried does not count. Practice trials come next, and they do not count either; "
                 "after them every answer counts. Press Continue when you are ready.")
            : tr("What you tried does not count. From now on every answer counts.") + QLatin1Char(' ') +
                  countingText();
    if (!takesHold(handling()) || m_hasLetGo)
        return next;
    return tr("You have not let go of an object yet, which you need for the next one.") + QLatin1Char(' ') +
           letGoSentence(m_live->condition().stimulus.attribute, hand(), letGo(), context().locale()) +
           QStringLiteral("\n\n") + next;
}

/// Why the experimenter is needed: the reason of the last of several trials that did not count. The next one
/// can be helped by the experimenter only where the hand was the reason.
QString TrialsScreen::needsText(const session::LiveStudyView& view) const {
    const std::string& reason = view.unanswered.empty() ? view.repeated : view.unanswered;
    const QString why = repeatedWords(reason, view.missed, handling(), view.probe_N, context().locale());
    const QString several = tr("Several trials in a row did not count. The last one: %1").arg(why);
    if (reason == "untouched")
        return several + QLatin1Char(' ') +
               (takesHold(handling())
                    ? tr("Ask the experimenter to show how an object is explored and let go.")
                    : tr("Ask the experimenter to show how an object is explored."));
    return several + QLatin1Char(' ') + tr("The experimenter decides how to go on.");
}

void TrialsScreen::showBreak(const session::LiveStudyView& view) {
    m_stage->setCurrentWidget(m_break);
    switch (view.state) {
    case State::starting:
        m_break->say(tr("One moment …"), {}, {});
        break;
    case State::tried:
        m_break->say(tr("The free minute is over"), triedText(), tr("Continue (Enter)"));
        break;
    case State::practised:
        m_break->say(tr("Practice is over"),
                     tr("From now on every answer counts.") + QLatin1Char(' ') + countingText(),
                     tr("Continue (Enter)"));
        break;
    case State::breakDue:
        m_break->say(tr("Break"),
                     view.breakLeft_s > 0.0 ? tr("Rest your hand. You can continue in %n second(s).", nullptr,
                                                 static_cast<int>(std::ceil(view.breakLeft_s)))
                                            : tr("Continue when you are ready."),
                     tr("Continue (Enter)"));
        break;
    case State::needsExperimenter:
        m_break->say(tr("Please call the experimenter"), needsText(view), tr("Continue"));
        break;
    case State::stopped:
        m_break->say(felt_words::stopped(hand().felt), stoppedText(), tr("Go on (R)"));
        break;
    case State::paused:
        m_break->say(tr("Paused"),
                     tr("The clock is stopped and everything so far is kept. Press Continue to go on."),
                     tr("Continue (Enter)"));
        break;
    default:
        sayEnd();
        break;
    }
    m_break->countDown(view.state == State::breakDue ? view.breakLeft_s : -1.0,
                       m_live->design().trial.breakAtLeast_s);
}

} // namespace chiron::desktop
