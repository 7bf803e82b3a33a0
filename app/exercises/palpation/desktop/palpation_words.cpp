// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_words.h"

#include "desktop/training/training_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PalpationWords)
};

struct KeyWords {
    Q_DECLARE_TR_FUNCTIONS(TrainingWords)
};

QStringList missingOf(const simulation::Finding& finding, const simulation::PalpationCues& cues) {
    QStringList missing;
    if (cues.asksSize && finding.radius_m <= 0.0)
        missing << Words::tr("size");
    if (cues.asksHardness && finding.hardness == 0)
        missing << Words::tr("hardness");
    if (cues.asksConfidence && finding.confidence == 0)
        missing << Words::tr("confidence");
    return missing;
}

} // namespace

QString hardnessWord(int rating) {
    switch (rating) {
    case 1:
        return Words::tr("soft");
    case 2:
        return Words::tr("rather soft");
    case 3:
        return Words::tr("medium");
    case 4:
        return Words::tr("firm");
    case 5:
        return Words::tr("stony hard");
    default:
        return Words::tr("not given");
    }
}

QString confidenceWord(int rating) {
    switch (rating) {
    case 1:
        return Words::tr("a guess");
    case 2:
        return Words::tr("unsure");
    case 3:
        return Words::tr("fairly sure");
    case 4:
        return Words::tr("sure");
    case 5:
        return Words::tr("certain");
    default:
        return Words::tr("not given");
    }
}

QString sizeText(double radius_m, const QLocale& locale) {
    return radius_m > 0.0 ? Words::tr("%1 mm across").arg(locale.toString(qRound(2e3 * radius_m)))
                          : Words::tr("not given");
}

QString findingText(int finding, const simulation::PalpationCues& cues, const QLocale& locale) {
    const simulation::Finding& said = cues.finding[static_cast<std::size_t>(finding)];
    QStringList parts;
    if (cues.asksSize)
        parts << (said.radius_m > 0.0 ? sizeText(said.radius_m, locale) : Words::tr("size not given"));
    if (cues.asksHardness)
        parts << (said.hardness > 0 ? hardnessWord(said.hardness) : Words::tr("hardness not given"));
    if (cues.asksConfidence)
        parts << (said.confidence > 0 ? confidenceWord(said.confidence) : Words::tr("confidence not given"));
    const QString number = locale.toString(finding + 1);
    return parts.isEmpty() ? Words::tr("Finding %1").arg(number)
                           : Words::tr("Finding %1: %2").arg(number, parts.join(QStringLiteral(", ")));
}

QStringList missingRatings(const simulation::PalpationCues& cues, const QLocale& locale) {
    QStringList all;
    for (std::size_t i = 0; i < cues.finding.size(); ++i) {
        if (!cues.finding[i].present)
            continue;
        const QStringList missing = missingOf(cues.finding[i], cues);
        if (!missing.isEmpty())
            all << Words::tr("Finding %1: %2")
                       .arg(locale.toString(static_cast<int>(i) + 1), missing.join(QStringLiteral(", ")));
    }
    return all;
}

int findingCount(const simulation::PalpationCues& cues) {
    return static_cast<int>(std::count_if(cues.finding.begin(), cues.finding.end(),
                                          [](const simulation::Finding& one) { return one.present; }));
}

QString palpationKeysInWords(bool ownHand, int hands, bool rates, bool pinches, devices::HandKind hand) {
    if (!ownHand)
        return keysInWords(false);
    const bool handle = hand == devices::HandKind::handle;
    QStringList all{
        handle
            ? KeyWords::tr("Move, press and lift: with the handle. Mark a finding: button of the handle or "
                           "Enter.")
            : KeyWords::tr("Move: mouse or arrow keys. Press and lift: wheel, right button and drag, or "
                           "Page Down and Page Up. Mark a finding: click or Enter.")};
    if (rates)
        all << KeyWords::tr("Rate the finding: 1 to 5, V for the other rating, + and − for the size.");
    if (pinches)
        all << (handle ? KeyWords::tr("Squeeze tissue between the jaws: open the grip in the air, lower it, "
                                      "close it.")
                       : KeyWords::tr("Squeeze tissue between the jaws: open them in the air with O, lower "
                                      "them, close them with G. They stay as they are when you let go."));
    all << KeyWords::tr("Next finding: N. Take it back: Delete. Nothing more to report: D.");
    if (handle)
        return (all << KeyWords::tr("Space: pause. Esc: stop force. F5: start again."))
            .join(QLatin1Char(' '));
    all << KeyWords::tr("Use the mouse in the panel: T. A click in the scene brings it back.");
    if (hands > 1)
        all << KeyWords::tr("Other hand: H.");
    all << KeyWords::tr("Space: pause, frees the pointer. Esc: stop force. F5: start again.");
    return all.join(QLatin1Char(' '));
}

QString activeHandInWords(int hand) {
    return hand == 0 ? KeyWords::tr("You move the right hand (H for the left)")
                     : KeyWords::tr("You move the left hand (H for the right)");
}

} // namespace chiron::desktop
