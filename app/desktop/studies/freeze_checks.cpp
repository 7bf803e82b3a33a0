// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/freeze_checks.h"

#include "desktop/studies/general_page.h"
#include "desktop/studies/participant_card.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/plan_words.h"
#include "desktop/studies/study_device.h"
#include "desktop/studies/study_screen.h"
#include "desktop/studies/study_words.h"
#include "desktop/studies/text_claims.h"
#include "desktop/studies/weight_check.h"
#include "session/study/participant_view.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using psychophysics::ConditionPlan;
using psychophysics::OrderDesign;
using psychophysics::StudyDesign;
using State = FreezeCheck::State;

namespace {

constexpr double kLong_min = 60.0;     // concentration decreases after this time
constexpr double kPrecise_log10 = 0.1; // a factor of 1.26 between runs
constexpr double kPower = 0.8;

struct CheckWords {
    Q_DECLARE_TR_FUNCTIONS(FreezeChecks)
};

FreezeCheck checkOf(const char* name, const QString& title, int tab, const char* field) {
    FreezeCheck check;
    check.name = QLatin1String(name);
    check.title = title;
    check.tab = tab;
    check.field = QLatin1String(field);
    return check;
}

FreezeCheck found(FreezeCheck check, State state, const QString& words) {
    check.state = state;
    check.words = words;
    return check;
}

FreezeCheck designCheck(const FreezeFacts& facts) {
    FreezeCheck check = checkOf("design", CheckWords::tr("Entries"), StudyScreen::generalTab, "");
    if (facts.faults.empty())
        return found(check, State::good, CheckWords::tr("All entries are complete and fit together."));
    const DesignFault& first = facts.faults.front();
    check.tab = first.tab;
    check.condition = first.condition;
    check.field = first.field;
    return found(check, State::bad,
                 CheckWords::tr("%n entr(y/ies) must be corrected. The first: %1", nullptr,
                                static_cast<int>(facts.faults.size()))
                     .arg(first.words));
}

FreezeCheck aimCheck(const StudyDesign& design) {
    const FreezeCheck check =
        checkOf("aim", CheckWords::tr("Aim"), StudyScreen::generalTab, "design.objective");
    const bool written = !design.objective.empty() &&
                         std::all_of(design.objective.begin(), design.objective.end(), [](const auto& each) {
                             const QString words = QString::fromStdString(each.second);
                             return !words.trimmed().isEmpty() && !isPlaceholderAim(words);
                         });
    return written
               ? found(check, State::good, CheckWords::tr("The aim is written down."))
               : found(check, State::bad,
                       CheckWords::tr(
                           "Write what is to be found out and what you expect. It cannot be added later."));
}

/// Texts that contradict the settings, which participants would read or reports would contain.
FreezeCheck textsCheck(const StudyDesign& design, const QLocale& locale) {
    const std::vector<FalseClaim> claims = falseClaims(design, locale);
    if (claims.empty())
        return found(
            checkOf("texts", CheckWords::tr("Texts"), StudyScreen::generalTab, "design.objective"),
            State::good,
            CheckWords::tr("Nothing in the aim, the instructions or the titles contradicts the settings."));
    const FalseClaim& first = claims.front();
    const int tab = first.condition >= 0                    ? StudyScreen::conditionsTab
                    : first.where == FalseClaim::Where::aim ? StudyScreen::generalTab
                                                            : StudyScreen::trialsTab;
    FreezeCheck check = checkOf("texts", CheckWords::tr("Texts"), tab, qPrintable(fieldOf(first.where)));
    check.condition = first.condition;
    return found(check, State::advice, claimWords(first));
}

FreezeCheck ethicsCheck(const StudyDesign& design) {
    const FreezeCheck check =
        checkOf("ethics", CheckWords::tr("Ethics"), StudyScreen::generalTab, "design.ethics");
    return design.ethics.empty()
               ? found(check, State::bad, CheckWords::tr("Name the approval, or say why none is needed."))
               : found(check, State::good, QString::fromStdString(design.ethics));
}

FreezeCheck consentCheck(const StudyDesign& design) {
    const FreezeCheck check =
        checkOf("consent", CheckWords::tr("Consent"), StudyScreen::generalTab, "design.consent");
    const QString words = study_words::text(design.consent, QStringLiteral("en")).trimmed();
    if (words.isEmpty())
        return found(check, State::bad, CheckWords::tr("Write what participants agree to."));
    constexpr int kShort = 120;
    return words.size() < kShort
               ? found(check, State::advice,
                       CheckWords::tr("The text is very short. Check that it says what is recorded, for how "
                                      "long, and that stopping has no disadvantage."))
               : found(check, State::good,
                       CheckWords::tr("There is a text; participants read it before their first trial."));
}

FreezeCheck participantsCheck(const StudyDesign& design, const QLocale& locale) {
    const FreezeCheck check =
        checkOf("participants", CheckWords::tr("Participants"), StudyScreen::generalTab, "design.planned");
    const int planned = design.participantsPlanned;
    const QString count = locale.toString(planned);
    if (planned < 1)
        return found(check, State::bad, CheckWords::tr("Plan at least one participant."));
    if (planned == 1)
        return found(
            check, State::advice,
            CheckWords::tr(
                "One participant says nothing about others. Plan more, unless this is a case study."));
    const int by = balancedBy(design);
    if (planned % by != 0)
        return found(
            check, State::advice,
            CheckWords::tr(
                "%1 are planned. With a multiple of %2 every order of conditions comes equally often.")
                .arg(count, locale.toString(by)));
    return found(check, State::good, CheckWords::tr("%1 are planned.").arg(count));
}

FreezeCheck practiceCheck(const StudyDesign& design) {
    const FreezeCheck check =
        checkOf("practice", CheckWords::tr("Practice"), StudyScreen::trialsTab, "trial.practice_trials");
    return design.trial.practiceTrials > 0
               ? found(check, State::good,
                       CheckWords::tr("%n trial(s) before each condition.", nullptr,
                                      design.trial.practiceTrials))
               : found(check, State::advice,
                       CheckWords::tr("There are no practice trials. The first trials that count are then "
                                      "the participant's first ever."));
}

/// Designs of earlier versions count any touch. Returns nothing if objects need not be touched or nothing is
/// compared.
std::optional<FreezeCheck> probeCheck(const StudyDesign& design, const QLocale& locale) {
    const bool compares =
        std::any_of(design.conditions.begin(), design.conditions.end(), [](const auto& each) {
            return each.stimulus.attribute != psychophysics::Attribute::apex;
        });
    if (!compares || !design.trial.mustTouchAll)
        return std::nullopt;
    const FreezeCheck check =
        checkOf("probe", CheckWords::tr("Smallest force"), StudyScreen::trialsTab, "trial.probe_at_least");
    const bool lifts = std::all_of(design.conditions.begin(), design.conditions.end(), [](const auto& each) {
        return each.stimulus.attribute == psychophysics::Attribute::mass;
    });
    if (lifts) // an object that is lifted pulls with its whole weight
        return found(check, State::good,
                     CheckWords::tr("An object counts as explored once it is lifted off the table."));
    return design.trial.probeAtLeast_N > 0.0
               ? found(check, State::good,
                       CheckWords::tr("An object counts as touched from %1 N on.")
                           .arg(study_words::plainNumber(design.trial.probeAtLeast_N, locale)))
               : found(check, State::advice,
                       CheckWords::tr("Any graze counts as touching, so participants can answer without "
                                      "having felt anything. %1 N is usual.")
                           .arg(study_words::plainNumber(psychophysics::kUsualProbe_N, locale)));
}

/// Checks the sound that masks the device's own sounds. A missing sound output is reported before freezing,
/// not at the first participant. Returns nothing if the design requires the sound and nobody has tested the
/// output yet.
std::optional<FreezeCheck> maskingCheck(const StudyDesign& design, const FreezeFacts& facts) {
    const FreezeCheck check =
        checkOf("masking", CheckWords::tr("Masking sound"), StudyScreen::trialsTab, "trial.masking_sound");
    if (!design.trial.maskingSound)
        return found(check, State::advice,
                     CheckWords::tr("It is switched off. Participants may hear the device, and its sound "
                                    "may tell them which object is which."));
    if (!facts.hasSound)
        return std::nullopt;
    return *facts.hasSound
               ? found(check, State::good, CheckWords::tr("It is played during the trials."))
               : found(check, State::advice,
                       CheckWords::tr(
                           "This machine has no sound output, so participants would hear the device. Connect "
                           "headphones or loudspeakers, or run the study on another machine."));
}

FreezeCheck durationCheck(const StudyDesign& design, const FreezeFacts& facts, const QLocale& locale) {
    const FreezeCheck check =
        checkOf("duration", CheckWords::tr("Duration"), StudyScreen::trialsTab, "trial.break_every");
    double minutes = session::participantView(design).minutes();
    QString words = CheckWords::tr("For each participant: %1.").arg(durationWords(design, locale));
    if (facts.plans) {
        double expected = 0.0;
        for (const ConditionPlan& plan : *facts.plans)
            expected += plan.minutes;
        if (expected > 0.0) {
            minutes = expected;
            words = CheckWords::tr("About %1 minutes for each participant, as simulated.")
                        .arg(locale.toString(static_cast<int>(std::ceil(minutes))));
        }
    } else if (minutes <= 0.0) {
        return found(check, State::waiting,
                     CheckWords::tr("Simulated observers are still running through the study …"));
    }
    return minutes > kLong_min
               ? found(check, State::advice,
                       words + QLatin1Char(' ') +
                           CheckWords::tr(
                               "Attention wanes after an hour: plan fewer trials or several sessions."))
               : found(check, State::good, words);
}

/// The spread between runs of the worst condition and, with two conditions, the difference that can be
/// detected.
FreezeCheck precisionCheck(const StudyDesign& design, const FreezeFacts& facts, const QLocale& locale) {
    const FreezeCheck check =
        checkOf("precision", CheckWords::tr("Precision"), StudyScreen::previewTab, "preview.start");
    if (!facts.plans)
        return found(check, State::waiting,
                     CheckWords::tr("Simulated observers are still running through the study …"));
    const ConditionPlan* worst = nullptr;
    for (const ConditionPlan& plan : *facts.plans)
        if (std::isfinite(plan.sdLog10) && (worst == nullptr || plan.sdLog10 > worst->sdLog10))
            worst = &plan;
    if (worst == nullptr)
        return found(check, State::good,
                     CheckWords::tr("This kind of study estimates no threshold, so there is none to "
                                    "simulate. A pilot shows how much answers vary."));
    QString words =
        CheckWords::tr("The threshold of one run varies by a factor of %1.")
            .arg(study_words::withError(
                std::pow(10.0, worst->sdLog10),
                std::pow(10.0, worst->sdLog10 + worst->sdError) - std::pow(10.0, worst->sdLog10), locale));
    if (design.conditions.size() > 1) {
        psychophysics::PowerQuestion question;
        question.participants = std::max(2, design.participantsPlanned);
        question.runSdLog10 = worst->sdLog10;
        const auto smallest = [](const psychophysics::PowerQuestion& asked) {
            return psychophysics::detectableRatio(asked, kPower);
        };
        const double ratio = smallest(question);
        const double error = psychophysics::figureError(question, worst->sdError, smallest);
        words +=
            QLatin1Char(' ') +
            (std::isfinite(ratio)
                 ? CheckWords::tr("With %1 participants, a comparison of two conditions finds a difference "
                                  "with 80 % power if the Weber fraction of one is at least %2 times that "
                                  "of the other.")
                       .arg(locale.toString(question.participants),
                            study_words::withError(ratio, error, locale))
                 : CheckWords::tr("With so few participants, a comparison of two conditions would often fail "
                                  "to show even a Weber fraction that is ten times the other."));
    }
    return worst->sdLog10 <= kPrecise_log10
               ? found(check, State::good, words)
               : found(check, State::advice,
                       words + QLatin1Char(' ') +
                           CheckWords::tr("More trials make it more precise; the page “Expected precision” "
                                          "shows how many."));
}

/// Whole runs without a value, in the condition where they are the most. Returns nothing if no run was
/// simulated.
std::optional<FreezeCheck> valuesCheck(const FreezeFacts& facts, const QLocale& locale) {
    const FreezeCheck check =
        checkOf("values", CheckWords::tr("Usable values"), StudyScreen::previewTab, "preview.start");
    if (!facts.plans)
        return found(check, State::waiting,
                     CheckWords::tr("Simulated observers are still running through the study …"));
    const ConditionPlan* worst = nullptr;
    for (const ConditionPlan& plan : *facts.plans)
        if (plan.runs > 0 && plan.withoutValue &&
            (worst == nullptr || plan.withoutValue > worst->withoutValue))
            worst = &plan;
    if (worst == nullptr)
        return std::nullopt;
    return found(check, psychophysics::oftenWithoutValue(*worst) ? State::advice : State::good,
                 runsWithoutValueWords(*worst, locale));
}

/// The class of the device decides whether runs count. Returns nothing if nobody has looked at the device.
std::optional<FreezeCheck> forceCheck(const FreezeFacts& facts) {
    constexpr int kNoMatterOfTheDesign = -1;
    const FreezeCheck check = checkOf("force", CheckWords::tr("Force"), kNoMatterOfTheDesign, "");
    if (!facts.rendersForce)
        return std::nullopt;
    return *facts.rendersForce
               ? found(check, State::good, CheckWords::tr("The device of this station renders force."))
               : found(check, State::advice, shownOnlyWords());
}

FreezeCheck pilotCheck(const FreezeFacts& facts) {
    const FreezeCheck check = checkOf("pilot", CheckWords::tr("Pilot"), StudyScreen::checkTab, "check.pilot");
    return facts.pilots > 0
               ? found(check, State::good, CheckWords::tr("Tried %n time(s).", nullptr, facts.pilots))
               : found(check, State::advice,
                       CheckWords::tr("Nobody has tried this design yet. Try it yourself first: a few "
                                      "minutes show what is unclear."));
}

QStringList titlesOf(const std::vector<FreezeCheck>& checks, State state) {
    QStringList titles;
    for (const FreezeCheck& check : checks)
        if (check.state == state)
            titles << check.title;
    return titles;
}

} // namespace

QString whyNotFrozen(const std::vector<FreezeCheck>& checks, bool seen) {
    if (const QStringList bad = titlesOf(checks, State::bad); !bad.isEmpty())
        return CheckWords::tr("Not possible yet. Correct first: %1. “Show” beside the red line leads there.")
            .arg(bad.join(QStringLiteral(", ")));
    if (!titlesOf(checks, State::waiting).isEmpty())
        return CheckWords::tr(
            "Please wait a moment: simulated observers are still running through the study.");
    return !seen && !titlesOf(checks, State::advice).isEmpty()
               ? CheckWords::tr("Tick the box above first: it confirms what is marked as worth a look.")
               : QString();
}

int balancedBy(const StudyDesign& design) {
    const int conditions = static_cast<int>(design.conditions.size());
    if (conditions < 2)
        return 1;
    switch (design.order) {
    case OrderDesign::williams:
        return conditions % 2 == 0 ? conditions : 2 * conditions; // an odd number needs two squares
    case OrderDesign::latinSquare:
        return conditions;
    case OrderDesign::fixed:
    case OrderDesign::random:
        break;
    }
    return 1;
}

std::vector<FreezeCheck> freezeChecks(const StudyDesign& design, const FreezeFacts& facts,
                                      const QLocale& locale) {
    std::vector<FreezeCheck> checks{designCheck(facts),         aimCheck(design),
                                    textsCheck(design, locale), ethicsCheck(design),
                                    consentCheck(design),       participantsCheck(design, locale),
                                    practiceCheck(design)};
    if (const auto probe = probeCheck(design, locale))
        checks.push_back(*probe);
    if (const auto weight = weightCheck(design, locale))
        checks.push_back(*weight);
    if (const auto sound = maskingCheck(design, facts))
        checks.push_back(*sound);
    if (const auto force = forceCheck(facts))
        checks.push_back(*force);
    checks.push_back(durationCheck(design, facts, locale));
    checks.push_back(precisionCheck(design, facts, locale));
    if (const auto values = valuesCheck(facts, locale))
        checks.push_back(*values);
    checks.push_back(pilotCheck(facts));
    return checks;
}

} // namespace chiron::desktop
