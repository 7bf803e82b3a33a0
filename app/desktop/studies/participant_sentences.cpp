// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/participant_sentences.h"

#include "core/languages.h"
#include "session/study/participant_view.h"

#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <array>
#include <set>
#include <string>

/// The catalogues are part of a static library, and the linker leaves out its resources unless they are
/// requested.
static void initialiseParticipantCatalogues() {
    Q_INIT_RESOURCE(i18n);
}

namespace chiron::desktop {

using psychophysics::StudyDesign;
using psychophysics::StudyText;
using psychophysics::Task;
using session::ParticipantView;
using session::PartView;

namespace {

constexpr const char* kContext = "ParticipantSentences";

/// Translates texts into a language that may differ from the program's.
class LanguageWords {
public:
    explicit LanguageWords(const QString& language)
        : m_locale(QString::fromStdString(std::string(core::languageOf(language.toStdString()).locale))) {
        initialiseParticipantCatalogues();
        // Without a catalogue the texts stay English.
        (void)m_translator.load(QStringLiteral(":/i18n/chiron_%1.qm").arg(language));
    }
    QString operator()(const char* text, int n = -1) const {
        QString words = m_translator.translate(kContext, text, nullptr, n);
        if (words.isEmpty())
            words = QString::fromUtf8(text);
        return n < 0 ? words : words.replace(QStringLiteral("%n"), m_locale.toString(n));
    }
    QString number(double value) const { return m_locale.toString(value, 'g', 6); }

private:
    QTranslator m_translator;
    QLocale m_locale;
};

QString withUnit(const LanguageWords& words, double number,
                 const char* unit) { // no line begins with the unit
    return words.number(number) + QChar(QChar::Nbsp) + QLatin1String(unit);
}

const char* sentenceOf(const PartView& part) {
    if (part.apex())
        return QT_TRANSLATE_NOOP(
            "ParticipantSentences",
            "In each trial you search for the highest point of an object with the tip and mark it.");
    switch (part.task) {
    case Task::rank3:
        return QT_TRANSLATE_NOOP("ParticipantSentences",
                                 "In each trial you explore three objects and put them in order.");
    case Task::rank3Ties:
        return QT_TRANSLATE_NOOP("ParticipantSentences",
                                 "In each trial you explore three objects and put them in order; you may "
                                 "mark those that seem the same as equal.");
    case Task::twoAfc:
    case Task::sameDifferent:
        return QT_TRANSLATE_NOOP("ParticipantSentences",
                                 "In each trial you explore two objects and choose one of two answers.");
    case Task::threeAfc:
    case Task::oddity:
        return QT_TRANSLATE_NOOP("ParticipantSentences",
                                 "In each trial you explore three objects and choose one of three answers.");
    case Task::yesNo:
        return QT_TRANSLATE_NOOP("ParticipantSentences",
                                 "In each trial you explore one object and compare it with the reference, "
                                 "which the experimenter shows you before the trials; you answer yes or no.");
    case Task::adjustment:
        return QT_TRANSLATE_NOOP(
            "ParticipantSentences",
            "In each trial you change one object until it seems like the other, and confirm.");
    case Task::magnitude:
        return QT_TRANSLATE_NOOP("ParticipantSentences",
                                 "In each trial you explore one object and give it a number.");
    }
    return "";
}

/// That every object has to be explored, in words of the movement; null if it need not be.
const char* everyObject(const ParticipantView& view) {
    bool lifts = true, pulls = true, presses = true, compares = false;
    for (const PartView& part : view.parts) {
        if (part.apex() || part.objects < 2)
            continue;
        compares = true;
        const bool mass = part.attribute == psychophysics::Attribute::mass;
        const bool held = session::isTakenHold(part.attribute);
        lifts = lifts && mass;
        pulls = pulls && held && !mass;
        presses = presses && !held;
    }
    if (!view.mustTouchAll || !compares)
        return nullptr;
    if (lifts) // it pulls with its whole weight
        return QT_TRANSLATE_NOOP("ParticipantSentences", "Lift every object before you answer.");
    if (pulls)
        return view.probes
                   ? QT_TRANSLATE_NOOP("ParticipantSentences",
                                       "Pull every object before you answer; the screen says when "
                                       "more force is needed.")
                   : QT_TRANSLATE_NOOP("ParticipantSentences", "Pull every object before you answer.");
    if (presses)
        return view.probes
                   ? QT_TRANSLATE_NOOP("ParticipantSentences",
                                       "Touch every object before you answer; a graze is not enough, "
                                       "and the screen says when more force is needed.")
                   : QT_TRANSLATE_NOOP("ParticipantSentences", "Touch every object before you answer.");
    return view.probes
               ? QT_TRANSLATE_NOOP("ParticipantSentences",
                                   "Explore every object before you answer; the screen says when more force "
                                   "is needed.")
               : QT_TRANSLATE_NOOP("ParticipantSentences", "Explore every object before you answer.");
}

QStringList whatToDo(const ParticipantView& view, const LanguageWords& words) {
    QStringList said;
    if (view.parts.size() > 1)
        said << words(QT_TRANSLATE_N_NOOP("ParticipantSentences", "The study has %n part(s)."),
                      static_cast<int>(view.parts.size()));
    QStringList tasks;
    for (const PartView& part : view.parts)
        if (const QString sentence = words(sentenceOf(part)); !tasks.contains(sentence))
            tasks << sentence;
    if (tasks.size() > 1)
        said << words(QT_TRANSLATE_NOOP("ParticipantSentences", "What you do differs from part to part:"));
    said << tasks;
    if (const char* every = everyObject(view))
        said << words(every);
    return said;
}

QString howMany(const ParticipantView& view, const LanguageWords& words) {
    int most = 0;
    bool fixed = true;
    for (const PartView& part : view.parts) {
        if (part.trialsAtMost == 0)
            return words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                           "How many trials there are depends on your answers."));
        fixed = fixed && part.trialsFixed && (most == 0 || most == part.trialsAtMost);
        most = std::max(most, part.trialsAtMost);
    }
    if (view.parts.size() > 1)
        return fixed
                   ? words(QT_TRANSLATE_N_NOOP("ParticipantSentences", "Each part has %n trial(s)."), most)
                   : words(QT_TRANSLATE_N_NOOP("ParticipantSentences", "Each part has at most %n trial(s)."),
                           most);
    return fixed ? words(QT_TRANSLATE_N_NOOP("ParticipantSentences", "There are %n trial(s)."), most)
                 : words(QT_TRANSLATE_N_NOOP("ParticipantSentences", "There are at most %n trial(s)."), most);
}

QStringList time(const ParticipantView& view, const LanguageWords& words) {
    if (view.explore_s <= 0.0)
        return {words(
            QT_TRANSLATE_NOOP("ParticipantSentences", "You may take as long as you like over each trial."))};
    const bool compares =
        std::any_of(view.parts.begin(), view.parts.end(), [](const PartView& part) { return !part.apex(); });
    if (!compares)
        return {words(QT_TRANSLATE_NOOP("ParticipantSentences", "You have %1 seconds for each trial."))
                    .arg(words.number(view.explore_s))};
    QStringList said{
        words(QT_TRANSLATE_NOOP("ParticipantSentences", "You have %1 seconds to explore in each trial."))
            .arg(words.number(view.explore_s)),
        view.answer_s > 0.0
            ? words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                      "Then the objects go away, and you have another %1 seconds to answer."))
                  .arg(words.number(view.answer_s))
            : words(QT_TRANSLATE_NOOP(
                  "ParticipantSentences",
                  "Then the objects go away, and you may take as long as you like to answer."))};
    if (std::any_of(view.parts.begin(), view.parts.end(), [](const PartView& part) { return part.apex(); }))
        said << words(QT_TRANSLATE_NOOP(
                          "ParticipantSentences",
                          "Where you search for the highest point, the trial ends after these %1 seconds."))
                    .arg(words.number(view.explore_s));
    return said;
}

QStringList feedback(const ParticipantView& view, const LanguageWords& words) {
    const bool judged = std::any_of(view.parts.begin(), view.parts.end(),
                                    [](const PartView& part) { return part.rightOrWrong; });
    const bool apex =
        std::any_of(view.parts.begin(), view.parts.end(), [](const PartView& part) { return part.apex(); });
    // Practice always gives feedback.
    const bool inPractice = !view.feedback && view.parts.front().practice > 0;
    QStringList said;
    if (judged)
        said << words(inPractice
                          ? QT_TRANSLATE_NOOP("ParticipantSentences",
                                              "Only in practice are you told whether your answer was right.")
                      : view.feedback
                          ? QT_TRANSLATE_NOOP("ParticipantSentences",
                                              "After each trial you are told whether your answer was right.")
                          : QT_TRANSLATE_NOOP("ParticipantSentences",
                                              "You are not told whether your answers are right."));
    if (apex)
        said << words(
            inPractice ? QT_TRANSLATE_NOOP(
                             "ParticipantSentences",
                             "Only in practice are you told how far your mark is from the highest point.")
            : view.feedback
                ? QT_TRANSLATE_NOOP(
                      "ParticipantSentences",
                      "After each trial you are told how far your mark is from the highest point.")
                : QT_TRANSLATE_NOOP("ParticipantSentences",
                                    "You are not told how far your marks are from the highest point."));
    return said;
}

QString breaks(const ParticipantView& view, const LanguageWords& words) {
    if (!view.anyBreak())
        return words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                       "No breaks are planned; you may pause whenever you want."));
    const QString every =
        words(QT_TRANSLATE_N_NOOP("ParticipantSentences", "After every %n trial(s) there is a break"),
              view.breakEvery);
    const QString atLeast =
        view.breakAtLeast_s > 0.0
            ? words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                      "%1 of at least %2 seconds; you may also pause whenever you want."))
            : words(QT_TRANSLATE_NOOP("ParticipantSentences", "%1; you may also pause whenever you want."));
    return view.breakAtLeast_s > 0.0 ? atLeast.arg(every, words.number(view.breakAtLeast_s))
                                     : atLeast.arg(every);
}

QStringList questions(const ParticipantView& view, const LanguageWords& words) {
    QStringList said;
    if (view.questionsBefore > 0)
        said << words(
            QT_TRANSLATE_N_NOOP("ParticipantSentences", "Before the trials you answer %n question(s)."),
            view.questionsBefore);
    if (view.questionsAfterEach > 0)
        said << (view.parts.size() > 1
                     ? words(QT_TRANSLATE_N_NOOP("ParticipantSentences",
                                                 "After each part you answer %n question(s) about it."),
                             view.questionsAfterEach)
                     : words(QT_TRANSLATE_N_NOOP("ParticipantSentences",
                                                 "After the trials you answer %n question(s) about them."),
                             view.questionsAfterEach));
    if (view.questionsAfter > 0)
        said << words(
            QT_TRANSLATE_N_NOOP("ParticipantSentences", "After the trials you answer %n question(s)."),
            view.questionsAfter);
    return said;
}

/// The sentence about the masking noise that earlier versions generated, in each of their languages. It
/// stands in frozen texts and never changes.
constexpr std::array kFormerNoise{
    "During the trials you hear a steady noise.",
    "Während der Durchgänge hören Sie ein gleichmäßiges Rauschen.",
    "Κατά τις δοκιμές ακούτε έναν σταθερό θόρυβο.",
};

/// Removes a sentence and the space beside it from the part of a text that begins at `from`.
void removeSentence(std::string& text, std::size_t from, const std::string& sentence) {
    const std::size_t at = text.find(sentence, from);
    if (at == std::string::npos)
        return;
    text.erase(at, sentence.size());
    if (at < text.size() && text[at] == ' ')
        text.erase(at, 1);
    else if (at > from && text[at - 1] == ' ')
        text.erase(at - 1, 1);
}

bool written(const StudyText& text) {
    return std::any_of(text.begin(), text.end(), [](const auto& each) { return !each.second.empty(); });
}

} // namespace

QStringList participantSentences(const StudyDesign& design, const QString& language) {
    const LanguageWords words(language);
    const ParticipantView view = session::participantView(design);
    if (view.parts.empty())
        return {};
    QStringList said = whatToDo(view, words);
    said << howMany(view, words);
    if (const int practice = view.parts.front().practice; practice > 0)
        said << (view.parts.size() > 1
                     ? words(QT_TRANSLATE_N_NOOP(
                                 "ParticipantSentences",
                                 "Each part begins with %n practice trial(s), which do not count."),
                             practice)
                     : words(QT_TRANSLATE_N_NOOP("ParticipantSentences",
                                                 "First come %n practice trial(s), which do not count."),
                             practice));
    said << words(
        view.parts.front().practice > 0
            ? QT_TRANSLATE_NOOP("ParticipantSentences",
                                "Before that you have a free minute to try the controls, which does "
                                "not count either.")
            : QT_TRANSLATE_NOOP("ParticipantSentences",
                                "Before the trials you have a free minute to try the controls, "
                                "which does not count."));
    said << time(view, words) << feedback(view, words) << breaks(view, words);
    return said + questions(view, words);
}

QString limitSentence(const StudyDesign& design, const psychophysics::Condition& condition,
                      const QString& language) {
    constexpr double kCentimetres = 100.0;
    const LanguageWords words(language);
    const QString sentence =
        condition.stimulus.attribute == psychophysics::Attribute::mass
            ? words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                      "Move calmly and put objects down gently: a trial in which you press "
                                      "one onto the table with more than %1, or move faster than %2 per "
                                      "second on average, is repeated."))
        : session::isTakenHold(condition.stimulus.attribute)
            ? words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                      "Pull gently and move calmly: a trial in which you pull with more than "
                                      "%1, or move faster than %2 per second on average, is repeated."))
            : words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                      "Press gently and move calmly: a trial in which you press with more "
                                      "than %1, or move faster than %2 per second on average, is repeated."));
    return sentence.arg(withUnit(words, design.fidelity.peakForce_N, "N"),
                        withUnit(words, kCentimetres * design.fidelity.meanSpeed_m_per_s, "cm"));
}

QStringList limitSentences(const StudyDesign& design, const QString& language) {
    QStringList said;
    for (const psychophysics::Condition& condition : design.conditions)
        if (const QString sentence = limitSentence(design, condition, language); !said.contains(sentence))
            said << sentence;
    return said;
}

QStringList forceSentences(const StudyDesign& design, const StudyDevice& device, const QString& language) {
    const LanguageWords words(language);
    QString does = words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                           "The device of this station renders no force: you see how objects "
                                           "respond, and nothing pushes against your hand."));
    if (device.rendersForce && device.largestForce_N)
        does =
            words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                    "The device pushes back against your hand, with at most %1. You can let "
                                    "go at any time, and the Esc key switches its force off at once."))
                .arg(withUnit(words, *device.largestForce_N, "N"));
    else if (device.rendersForce)
        does = words(QT_TRANSLATE_NOOP("ParticipantSentences",
                                       "The device pushes back against your hand. You can let go at any "
                                       "time, and the Esc key switches its force off at once."));
    return QStringList{does} + limitSentences(design, language);
}

const StudyText& ownSentences(const StudyDesign& design) {
    return design.ownInstructions ? *design.ownInstructions : design.instructions;
}

StudyText shownInstructions(const StudyDesign& design) {
    StudyText shown = design.instructions;
    if (!design.ownInstructions)
        return shown; // nothing of it was generated
    for (auto& [language, words] : shown) {
        const auto own = design.ownInstructions->find(language);
        const bool begins = own != design.ownInstructions->end() && words.starts_with(own->second);
        for (const char* sentence : kFormerNoise)
            removeSentence(words, begins ? own->second.size() : 0, sentence);
    }
    return shown;
}

void renewInstructions(StudyDesign& design) {
    const StudyText own = ownSentences(design);
    std::set<std::string> languages{"en"};
    for (const std::string& language : core::languageIds())
        if (!written(own) || (own.contains(language) && !own.at(language).empty()))
            languages.insert(language);
    StudyText all;
    for (const std::string& language : languages) {
        const auto found = own.find(language);
        QStringList paragraphs;
        if (found != own.end() && !found->second.empty())
            paragraphs << QString::fromStdString(found->second);
        paragraphs << participantSentences(design, QString::fromStdString(language)).join(QLatin1Char(' '));
        all[language] = paragraphs.join(QStringLiteral("\n\n")).toStdString();
    }
    StudyText kept;
    for (const auto& [language, words] : own)
        if (!words.empty())
            kept[language] = words;
    design.ownInstructions = std::move(kept);
    design.instructions = std::move(all);
}

} // namespace chiron::desktop
