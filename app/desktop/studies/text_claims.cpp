// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/text_claims.h"

#include "catalogue/language_words.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/interface_language.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/study_page.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "session/study/participant_view.h"

#include <QCoreApplication>
#include <QLabel>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::desktop {

namespace {

using psychophysics::Attribute;
using psychophysics::StudyDesign;
using psychophysics::StudyText;
using Where = FalseClaim::Where;

/// The translation context of the texts.
struct TextClaims {
    Q_DECLARE_TR_FUNCTIONS(TextClaims)
};

using Claims = catalogue::LanguageWords::Claims;

constexpr double kSameShare = 0.006; // tolerates 0.0803 for 0.08 s

QRegularExpression pattern(const QString& words) {
    return QRegularExpression(words, QRegularExpression::CaseInsensitiveOption |
                                         QRegularExpression::UseUnicodePropertiesOption);
}

/// One of these words, as a part of a pattern: "*" stands for any ending.
QString oneOf(const QStringList& words) {
    QStringList patterns;
    for (const QString& each : words)
        patterns << QRegularExpression::escape(each).replace(QLatin1String("\\*"), QLatin1String("\\w*"));
    return QStringLiteral("(?:") + patterns.join(QLatin1Char('|')) + QLatin1Char(')');
}

/// Those of all languages together: none of them has another meaning in another language.
QString inAnyLanguage(QStringList Claims::*words) {
    QStringList all;
    for (const catalogue::LanguageWords& each : catalogue::languageWords())
        all << each.claims.*words;
    return oneOf(all);
}

/// The words for numbers in all languages, in small letters.
const std::map<QString, int>& numberWords() {
    static const std::map<QString, int> numbers = [] {
        std::map<QString, int> read;
        for (const catalogue::LanguageWords& each : catalogue::languageWords())
            for (const auto& [number, words] : each.claims.numbers)
                for (const QString& word : words)
                    read.emplace(word.toLower(), number);
        return read;
    }();
    return numbers;
}

/// A statement in a text, and the setting that it requires.
struct Expected {
    QRegularExpression said;
    std::function<bool(const StudyDesign&)> holds;
    QString setting;
};

double numberIn(const QString& digits) {
    return QString(digits).replace(QLatin1Char(','), QLatin1Char('.')).toDouble();
}

bool same(double a, double b) {
    return std::abs(a - b) <= kSameShare * std::max(std::abs(a), std::abs(b));
}

/// The size of a unit in SI, and the attributes that it measures.
struct TitleUnit {
    double factor;
    std::vector<Attribute> of;
};

const std::map<QString, TitleUnit>& titleUnits() {
    static const std::map<QString, TitleUnit> units{
        {QStringLiteral("N/m"), {1.0, {Attribute::stiffness}}},
        {QStringLiteral("N·s/m"), {1.0, {Attribute::viscosity}}},
        {QStringLiteral("kg"), {1.0, {Attribute::mass}}},
        {QStringLiteral("g"), {1e-3, {Attribute::mass}}},
        {QStringLiteral("s"), {1.0, {Attribute::deformation}}},
        {QStringLiteral("ms"), {1e-3, {Attribute::deformation}}},
        {QStringLiteral("cm"), {1e-2, {Attribute::apex, Attribute::roughness}}},
        {QStringLiteral("mm"), {1e-3, {Attribute::apex, Attribute::roughness}}},
        {QStringLiteral("µm"), {1e-6, {Attribute::roughness}}}};
    return units;
}

void checkTitle(std::vector<FalseClaim>& claims, const psychophysics::Condition& condition, int at,
                const QLocale& locale) {
    static const QRegularExpression withUnit =
        pattern(QStringLiteral("(\\d+(?:[.,]\\d+)?)\\s*(N·s/m|N/m|kg|g|ms|s|cm|mm|µm)(?![\\w/·])"));
    static const QRegularExpression plain =
        pattern(QStringLiteral("(?<![\\w.,])(\\d+[.,]\\d+)(?![\\w.,]|\\s*(?:N|kg|g|m|s|c|µ|%))"));
    const psychophysics::StimulusDesign& stimulus = condition.stimulus;
    const QString setting = TextClaims::tr("the reference is %1")
                                .arg(study_words::value(stimulus.reference, stimulus.attribute, locale));
    for (const auto& [language, words] : condition.title) {
        // Both characters mean micro.
        const QString title = QString::fromStdString(words).replace(QChar(0x03BC), QChar(0x00B5));
        const auto tell = [&](const QString& said) {
            claims.push_back({Where::title, at, QString::fromStdString(language), said, setting});
        };
        for (auto each = withUnit.globalMatch(title); each.hasNext();) {
            const QRegularExpressionMatch match = each.next();
            const auto unit = titleUnits().find(match.captured(2));
            if (unit == titleUnits().end())
                continue;
            const std::vector<Attribute>& of = unit->second.of;
            if (std::find(of.begin(), of.end(), stimulus.attribute) == of.end() ||
                !same(numberIn(match.captured(1)) * unit->second.factor, stimulus.reference))
                tell(match.captured(0));
        }
        if (stimulus.attribute == Attribute::friction) // the only attribute without a unit
            for (auto each = plain.globalMatch(title); each.hasNext();)
                if (const QRegularExpressionMatch match = each.next();
                    !same(numberIn(match.captured(1)), stimulus.reference))
                    tell(match.captured(1));
    }
}

/// Statements that are true only with a certain setting.
std::vector<Expected> expectations() {
    return {{pattern(inAnyLanguage(&Claims::criterionThreeOfFour)),
             [](const StudyDesign& d) {
                 return std::any_of(d.conditions.begin(), d.conditions.end(),
                                    [](const auto& each) { return same(each.criterion, 0.75); });
             },
             TextClaims::tr("the criterion is not 75 %")},
            {pattern(inAnyLanguage(&Claims::objectsNotSeen)),
             [](const StudyDesign& d) { return !d.trial.visibleObjects; },
             TextClaims::tr("the objects are shown")},
            {pattern(inAnyLanguage(&Claims::objectsSeen)),
             [](const StudyDesign& d) { return d.trial.visibleObjects; },
             TextClaims::tr("the objects are not shown")},
            {pattern(inAnyLanguage(&Claims::timeNotLimited)),
             [](const StudyDesign& d) { return d.trial.exploreLimit_s <= 0.0; },
             TextClaims::tr("the time to explore is limited")}};
}

int numberOfWord(const QString& word) {
    const auto found = numberWords().find(word.toLower());
    return found == numberWords().end() ? word.toInt() : found->second;
}

/// A number, in digits or as a word, and what is counted.
QRegularExpression numberOf(QStringList Claims::*counted) {
    QStringList numbers;
    for (const auto& [word, ignored] : numberWords())
        numbers << word;
    return pattern(QStringLiteral("(?<!\\w)(\\d+|") + oneOf(numbers) + QStringLiteral(")\\s+") +
                   inAnyLanguage(counted) + QStringLiteral("(?!\\w)"));
}

/// The numbers and durations that sentences state.
struct Counts {
    std::vector<double> objects, trials, seconds;
};

Counts countsOf(const StudyDesign& design) {
    Counts counts;
    const session::ParticipantView view = session::participantView(design);
    for (const session::PartView& part : view.parts) {
        counts.objects.push_back(part.objects);
        counts.trials.insert(counts.trials.end(),
                             {static_cast<double>(part.trialsAtMost), static_cast<double>(part.practice)});
    }
    counts.trials.push_back(design.trial.breakEvery);
    counts.seconds = {design.trial.exploreLimit_s, design.trial.answerLimit_s, design.trial.breakAtLeast_s,
                      design.trial.betweenTrials_s};
    return counts;
}

void checkSentences(std::vector<FalseClaim>& claims, const StudyDesign& design, const StudyText& texts,
                    Where where, int condition = -1) {
    static const QRegularExpression objects = numberOf(&Claims::objects);
    static const QRegularExpression trials = numberOf(&Claims::trials);
    static const QRegularExpression seconds = numberOf(&Claims::seconds);
    const Counts counts = countsOf(design);
    for (const auto& [language, words] : texts) {
        const QString text = QString::fromStdString(words);
        const auto tell = [&](const QString& said, const QString& setting) {
            claims.push_back({where, condition, QString::fromStdString(language), said, setting});
        };
        const auto count = [&](const QRegularExpression& says, const std::vector<double>& set,
                               const QString& setting) {
            for (auto each = says.globalMatch(text); each.hasNext();) {
                const QRegularExpressionMatch match = each.next();
                const double number = numberOfWord(match.captured(1));
                if (std::none_of(set.begin(), set.end(),
                                 [number](double value) { return same(value, number); }))
                    tell(match.captured(0), setting);
            }
        };
        count(objects, counts.objects, TextClaims::tr("the task has a different number of objects"));
        count(trials, counts.trials, TextClaims::tr("a different number of trials is set"));
        count(seconds, counts.seconds, TextClaims::tr("a different time is set"));
        for (const Expected& each : expectations())
            if (const QRegularExpressionMatch match = each.said.match(text);
                match.hasMatch() && !each.holds(design))
                tell(match.captured(0), each.setting);
    }
}

} // namespace

std::vector<FalseClaim> falseClaims(const StudyDesign& design, const QLocale& locale) {
    std::vector<FalseClaim> claims;
    checkSentences(claims, design, design.objective, Where::aim);
    checkSentences(claims, design, ownSentences(design), Where::instructions);
    for (std::size_t i = 0; i < design.conditions.size(); ++i) {
        const int condition = static_cast<int>(i);
        checkTitle(claims, design.conditions[i], condition, locale);
        StudyDesign alone = design; // so that a statement about another condition does not count
        alone.conditions = {design.conditions[i]};
        checkSentences(claims, alone, design.conditions[i].instructions, Where::part, condition);
    }
    return claims;
}

QString claimWords(const FalseClaim& claim) {
    return TextClaims::tr("The text says “%1” (%2), but %3. Change one of them.")
        .arg(claim.said, languageName(claim.language), claim.setting);
}

QString fieldOf(Where where) {
    switch (where) {
    case Where::aim:
        return QStringLiteral("design.objective");
    case Where::instructions:
        return QStringLiteral("design.instructions");
    case Where::title:
        return QStringLiteral("condition.title");
    case Where::part:
        return QStringLiteral("condition.instructions");
    }
    return {};
}

QWidget* claimsNotice(const DesignPage& page, Where where, int condition) {
    auto* words = kit::label(page.app.theme(), {}, TextStyle::small, "warning");
    words->setObjectName(fieldOf(where) + QStringLiteral(".claims"));
    const auto show = [words, where, condition, &draft = page.draft, locale = page.app.locale()] {
        QStringList said;
        for (const FalseClaim& claim : falseClaims(draft.design(), locale))
            if (claim.where == where && claim.condition == condition)
                said << QStringLiteral("! ") + claimWords(claim);
        words->setText(said.join(QLatin1Char('\n')));
        words->setVisible(!said.isEmpty());
    };
    QObject::connect(&page.draft, &StudyDraft::changed, words, show);
    show();
    return words;
}

} // namespace chiron::desktop
