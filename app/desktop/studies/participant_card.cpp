// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/participant_card.h"

#include "desktop/frame/app_context.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "session/study/participant_view.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using psychophysics::Condition;
using psychophysics::StudyDesign;
using session::ParticipantView;
using session::PartView;

namespace {

struct CardWords {
    Q_DECLARE_TR_FUNCTIONS(ParticipantFacts)
};

QString conditionLine(const Condition& condition, const QLocale& locale, const QString& language) {
    const psychophysics::StimulusDesign& stimulus = condition.stimulus;
    const QString title = study_words::text(condition.title, language);
    const QString reference = study_words::value(stimulus.reference, stimulus.attribute, locale);
    if (stimulus.attribute == psychophysics::Attribute::apex || stimulus.differences.empty())
        return CardWords::tr("%1: %2").arg(title, reference);
    const QStringList ends = study_words::percents({study_words::ratioOf(stimulus.differences.front()),
                                                    study_words::ratioOf(stimulus.differences.back())},
                                                   locale);
    return CardWords::tr("%1: %2, differences of %3 to %4").arg(title, reference, ends.front(), ends.back());
}

QString conditionsWords(const StudyDesign& design, const QLocale& locale, const QString& language) {
    QStringList lines;
    for (const Condition& condition : design.conditions)
        lines << conditionLine(condition, locale, language);
    return lines.join(QLatin1Char('\n'));
}

QString askedWords(const ParticipantView& view) {
    QStringList questions;
    for (const PartView& part : view.parts) {
        const QString question = part.apex() ? CardWords::tr("Mark the highest point.")
                                             : study_words::question(part.task, part.attribute);
        if (!questions.contains(question))
            questions << question;
    }
    return questions.join(QLatin1Char('\n'));
}

QString trialsWords(const ParticipantView& view, const QLocale& locale) {
    int all = 0;
    bool fixed = true, alike = true;
    QStringList counts;
    for (const PartView& part : view.parts) {
        if (part.trialsAtMost == 0)
            return CardWords::tr("as many as the answers need");
        all += part.trialsAtMost;
        fixed = fixed && part.trialsFixed;
        alike = alike && part.trialsAtMost == view.parts.front().trialsAtMost;
        counts << locale.toString(part.trialsAtMost);
    }
    const auto most = [fixed](const QString& count) {
        return fixed ? count : CardWords::tr("at most %1").arg(count);
    };
    QString words = most(locale.toString(all));
    if (view.parts.size() > 1)
        words =
            alike
                ? CardWords::tr("%1 in each condition, %2 in all")
                      .arg(most(counts.front()), locale.toString(all))
                : CardWords::tr("%1 in all (by condition: %2)").arg(words, counts.join(QStringLiteral(", ")));
    const int practice = view.parts.front().practice * static_cast<int>(view.parts.size());
    if (practice > 0)
        words = CardWords::tr("%1, and %n for practice", nullptr, practice).arg(words);
    return words;
}

QString sequenceOf(const ParticipantView& view, const QLocale& locale) {
    const int practice = view.parts.front().practice;
    return practice > 0
               ? CardWords::tr(
                     "instructions, controls, a free minute, practice (%1), then the trials that count")
                     .arg(locale.toString(practice))
               : CardWords::tr("instructions, controls, a free minute, then the trials that count");
}

QString breakWords(const ParticipantView& view, const QLocale& locale) {
    if (!view.anyBreak())
        return CardWords::tr("none");
    return CardWords::tr("after every %1 trials, at least %2 s")
        .arg(locale.toString(view.breakEvery), locale.toString(view.breakAtLeast_s, 'g', 6));
}

QString timeWords(const ParticipantView& view, const QLocale& locale) {
    if (view.explore_s <= 0.0)
        return CardWords::tr("no limit");
    const QString explore = locale.toString(view.explore_s, 'g', 6);
    if (std::all_of(view.parts.begin(), view.parts.end(), [](const PartView& part) { return part.apex(); }))
        return CardWords::tr("%1 s per trial").arg(explore);
    return view.answer_s > 0.0 ? CardWords::tr("%1 s to explore, then %2 s to answer")
                                     .arg(explore, locale.toString(view.answer_s, 'g', 6))
                               : CardWords::tr("%1 s to explore, no limit to answer").arg(explore);
}

QString feedbackWords(const ParticipantView& view) {
    if (view.feedback)
        return CardWords::tr("after each trial");
    return view.parts.front().practice > 0 ? CardWords::tr("in practice only") : CardWords::tr("none");
}

QString questionWords(const ParticipantView& view, const QLocale& locale) {
    if (view.questionsAfterEach > 0)
        return CardWords::tr("%1 before, %2 after each condition, %3 after")
            .arg(locale.toString(view.questionsBefore), locale.toString(view.questionsAfterEach),
                 locale.toString(view.questionsAfter));
    if (view.questionsBefore + view.questionsAfter == 0)
        return CardWords::tr("none");
    return CardWords::tr("%1 before, %2 after")
        .arg(locale.toString(view.questionsBefore), locale.toString(view.questionsAfter));
}

/// The title of a line.
QString titleOf(const QString& name) {
    const std::pair<const char*, QString> titles[] = {
        {"conditions", CardWords::tr("Conditions")},
        {"asked", CardWords::tr("Asked")},
        {"sequence", CardWords::tr("Sequence in each condition")},
        {"trials", CardWords::tr("Trials")},
        {"minutes", CardWords::tr("Duration")},
        {"breaks", CardWords::tr("Breaks")},
        {"time", CardWords::tr("Time")},
        {"feedback", CardWords::tr("Feedback")},
        {"questions", CardWords::tr("Questions")}};
    for (const auto& [key, title] : titles)
        if (name == QLatin1String(key))
            return title;
    return {};
}

} // namespace

std::vector<std::pair<QString, QString>> participantFacts(const StudyDesign& design, const QLocale& locale,
                                                          const QString& language) {
    const ParticipantView view = session::participantView(design);
    if (view.parts.empty())
        return {};
    return {{QStringLiteral("conditions"), conditionsWords(design, locale, language)},
            {QStringLiteral("asked"), askedWords(view)},
            {QStringLiteral("sequence"), sequenceOf(view, locale)},
            {QStringLiteral("trials"), trialsWords(view, locale)},
            {QStringLiteral("minutes"), durationWords(design, locale)},
            {QStringLiteral("breaks"), breakWords(view, locale)},
            {QStringLiteral("time"), timeWords(view, locale)},
            {QStringLiteral("feedback"), feedbackWords(view)},
            {QStringLiteral("questions"), questionWords(view, locale)}};
}

QString durationWords(const StudyDesign& design, const QLocale& locale) {
    const ParticipantView view = session::participantView(design);
    const double minutes = view.minutes();
    if (minutes <= 0.0)
        return CardWords::tr("as long as the answers take");
    const auto [shortest, longest] =
        std::minmax_element(view.parts.begin(), view.parts.end(),
                            [](const PartView& a, const PartView& b) { return a.trial_s < b.trial_s; });
    const auto seconds = [&locale](double s) { return locale.toString(std::round(s)); };
    const QString one = seconds(shortest->trial_s), other = seconds(longest->trial_s);
    return CardWords::tr("about %1 min for all trials, if each takes %2 s")
        .arg(locale.toString(static_cast<int>(std::ceil(minutes))),
             one == other ? one : CardWords::tr("%1 to %2").arg(one, other));
}

QString sequenceWords(const StudyDesign& design, const QLocale& locale) {
    const ParticipantView view = session::participantView(design);
    return view.parts.empty() ? QString() : sequenceOf(view, locale);
}

ParticipantCard::ParticipantCard(const DesignPage& page, QWidget* parent) : QFrame(parent), m_page(page) {
    const Theme& theme = page.app.theme();
    setProperty("kind", QStringLiteral("card"));
    setObjectName(QStringLiteral("study.card"));
    setAccessibleName(tr("What a participant will meet"));
    auto* column = new QVBoxLayout(this);
    const int padding = theme.px(14);
    column->setContentsMargins(padding, padding, padding, padding);
    column->setSpacing(theme.px(2));
    column->addWidget(kit::label(theme, tr("What a participant will meet"), TextStyle::strong));
    for (const char* name : {"conditions", "asked", "sequence", "trials", "minutes", "breaks", "time",
                             "feedback", "questions"}) {
        column->addSpacing(theme.px(4));
        column->addWidget(kit::label(theme, titleOf(QLatin1String(name)), TextStyle::small, "muted"));
        auto* words = kit::label(theme, {}, TextStyle::body);
        words->setObjectName(QStringLiteral("study.card.") + QLatin1String(name));
        column->addWidget(words);
        m_lines.emplace_back(QLatin1String(name), words);
    }
    column->addStretch();
    connect(&page.draft, &StudyDraft::changed, this, &ParticipantCard::renew);
    renew();
}

void ParticipantCard::renew() {
    const auto facts = participantFacts(m_page.draft.design(), m_page.app.locale(), m_page.app.language());
    for (const auto& [name, label] : m_lines) {
        const auto found = std::find_if(facts.begin(), facts.end(),
                                        [&, key = name](const auto& fact) { return fact.first == key; });
        label->setText(found == facts.end() ? QString() : found->second);
    }
}

} // namespace chiron::desktop
