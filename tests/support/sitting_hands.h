// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_run/participant_window.h"
#include "desktop/study_run/trials_screen.h"
#include "support/every_place.h"
#include "support/patience.h"

#include <QLineEdit>

namespace chiron::tests {

/// A button of a sitting, wherever the participant's page is.
inline QPushButton* sittingButton(desktop::TrialsScreen* screen, const char* name) {
    QWidget* page = screen->participantWindow() ? static_cast<QWidget*>(screen->participantWindow()) : screen;
    auto* found = page->findChild<QPushButton*>(QLatin1String(name));
    return found ? found : screen->findChild<QPushButton*>(QLatin1String(name));
}

/// Past the instructions and the card, into the free minute or the trials.
inline bool pastTheCard(desktop::TrialsScreen* screen) {
    QPushButton* read = sittingButton(screen, "break.button");
    if (!read)
        return false;
    read->click();
    QPushButton* go = sittingButton(screen, "training.ready.go");
    if (!go)
        return false;
    go->click();
    return true;
}

/// Past the free minute as well: the first trial comes.
inline bool beginTrials(desktop::TrialsScreen* screen, int patience_ms = kPatience_ms) {
    using State = session::LiveStudyView::State;
    if (!pastTheCard(screen))
        return false;
    return QTest::qWaitFor(
        [screen] {
            const session::LiveStudyView view = screen->live()->view();
            if (view.state == State::trying)
                sittingButton(screen, "trials.enough")->click();
            return view.tryLeft_s <= 0.0 && view.state != State::starting && view.state != State::paused;
        },
        patience_ms);
}

/// What the experimenter types into the question for their password. False where it is not asked, or does not
/// go.
inline bool typePassword(DesktopFixture& desktop, const char* password = kTestPassword) {
    if (!QTest::qWaitFor(
            [&desktop] { return desktop.find<QLineEdit>(QStringLiteral("gate.password")) != nullptr; },
            kPatience_ms))
        return false;
    desktop.find<QLineEdit>(QStringLiteral("gate.password"))->setText(QLatin1String(password));
    desktop.find<QPushButton>(QStringLiteral("gate.accept"))->click();
    return QTest::qWaitFor(
        [&desktop] {
            return desktop.context.background().idle() &&
                   !desktop.find<QLineEdit>(QStringLiteral("gate.password"));
        },
        kPatience_ms);
}

/// The sitting is stopped by the participant's button; the experimenter comes and goes on. Whoever stops a
/// pilot run goes on at once. True on the page `to`: the study's, or of a pilot the design's.
inline bool stopSitting(DesktopFixture& desktop, desktop::TrialsScreen* screen,
                        int patience_ms = kPatience_ms, const QString& to = QStringLiteral("study_run")) {
    QTimer look; // the question comes when it comes
    QObject::connect(&look, &QTimer::timeout, &desktop.context, [&desktop] {
        if (auto* button = desktop.find<QPushButton>(QStringLiteral("trials.ask.stop")))
            button->click();
    });
    look.start(200);
    const bool pilot = !screen->live()->design().pilotOf.empty();
    const bool goesOn = pilot && !screen->live()->finished();
    if (auto* stop = sittingButton(screen, "trials.stop"); stop && !stop->isHidden())
        stop->click();
    if (goesOn)
        return QTest::qWaitFor([&] { return desktop.context.navigator().current().screen == to; },
                               patience_ms);
    if (!QTest::qWaitFor([screen] { return screen->live()->finished() && !screen->isBusy(); }, patience_ms))
        return false;
    if (pilot && !screen->atDesk()) // nobody is called: whoever tried it goes on
        sittingButton(screen, "break.button")->click();
    else if (screen->atDesk())
        screen->findChild<QPushButton*>(QStringLiteral("trials.leave"))->click();
    else {
        sittingButton(screen, "trials.experimenter")->click();
        (void)typePassword(desktop);
    }
    return QTest::qWaitFor([&] { return desktop.context.navigator().current().screen == to; }, patience_ms);
}

} // namespace chiron::tests
