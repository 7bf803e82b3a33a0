// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study/questionnaire_cell.h"
#include "cli/cli_errors.h"

#include <cmath>

namespace chiron::cli {

namespace {

using psychophysics::QuestionnaireItem;

constexpr qsizetype kMostFaults = 20;
constexpr qsizetype kLongestText = 10000;

QString inLanguage(const psychophysics::StudyText& words, const std::string& language) {
    auto found = words.find(language);
    found = found == words.end() ? words.find("en") : found;
    return found == words.end() ? QString() : QString::fromStdString(found->second);
}

/// "5 (Completely)", or "5" if this end of the scale has no words.
QString end(double value, const QString& words) {
    return words.isEmpty() ? QString::number(value)
                           : QStringLiteral("%1 (%2)").arg(QString::number(value), words);
}

/// The index of the choice with these words in any language; -1 if there is none.
int choiceNamed(const QuestionnaireItem& item, const QString& words) {
    for (std::size_t i = 0; i < item.choices.size(); ++i)
        for (const auto& [language, choice] : item.choices[i])
            if (QString::fromStdString(choice).trimmed().compare(words, Qt::CaseInsensitive) == 0)
                return static_cast<int>(i);
    return -1;
}

/// If a choice reads "2", a 2 could be meant as its words or as an index from 0.
bool choicesAreNumbers(const QuestionnaireItem& item) {
    for (const auto& choice : item.choices)
        for (const auto& [language, words] : choice) {
            bool number = false;
            QString::fromStdString(words).trimmed().toDouble(&number);
            if (number)
                return true;
        }
    return false;
}

bool fits(const QuestionnaireItem& item, double value) {
    const bool whole = value == std::floor(value);
    if (item.kind == QuestionnaireItem::Kind::likert)
        return whole && value >= 1.0 && value <= item.scale;
    if (item.kind == QuestionnaireItem::Kind::choice)
        return whole && value >= 0.0 && value < static_cast<double>(item.choices.size());
    return std::isfinite(value) && value >= item.lowest && value <= item.highest;
}

} // namespace

void SheetFaults::add(const QString& place, const QString& what, const QString& expected) {
    m_lines << QStringLiteral("%1: %2: expected %3").arg(place, what, expected);
}

core::Error SheetFaults::error() const {
    QString all = m_lines.mid(0, kMostFaults).join(u'\n');
    if (m_lines.size() > kMostFaults)
        all += QStringLiteral("\nand %1 more; nothing was stored").arg(m_lines.size() - kMostFaults);
    return {core::ErrorCode::badInput, all.toStdString()};
}

QString AskedQuestion::group() const {
    return QString::fromStdString(label.empty() ? questionnaire->id : questionnaire->id + '@' + label);
}

QString AskedQuestion::name() const {
    return group() + u'.' + QString::fromStdString(item->id);
}

std::vector<AskedQuestion>
askedQuestions(const std::vector<const psychophysics::Questionnaire*>& questionnaires,
               const std::vector<std::string>& labels) {
    std::vector<AskedQuestion> all;
    for (const psychophysics::Questionnaire* questionnaire : questionnaires) {
        const bool each = questionnaire->when == psychophysics::Questionnaire::When::afterCondition;
        for (const std::string& label : each ? labels : std::vector<std::string>(1))
            for (const QuestionnaireItem& item : questionnaire->items)
                all.push_back({questionnaire, &item, label});
    }
    return all;
}

QString expectedAnswer(const QuestionnaireItem& item, const std::string& language) {
    switch (item.kind) {
    case QuestionnaireItem::Kind::likert:
        return QStringLiteral("a whole number from %1 to %2")
            .arg(end(1.0, inLanguage(item.low, language)), end(item.scale, inLanguage(item.high, language)));
    case QuestionnaireItem::Kind::number:
        return QStringLiteral("a number from %1 to %2, such as 2.5")
            .arg(QString::number(item.lowest), QString::number(item.highest));
    case QuestionnaireItem::Kind::text:
        return QStringLiteral("words, at most %1 characters").arg(kLongestText);
    case QuestionnaireItem::Kind::choice:
        break;
    }
    QStringList choices;
    for (std::size_t i = 0; i < item.choices.size(); ++i) {
        const QString words = inLanguage(item.choices[i], language);
        choices << (choicesAreNumbers(item) ? quoted(words) : QStringLiteral("%1 (%2)").arg(i).arg(words));
    }
    return QStringLiteral("one of ") + choices.join(QStringLiteral(", "));
}

core::Result<std::vector<const psychophysics::Questionnaire*>>
chosenQuestionnaires(const Arguments& arguments, const psychophysics::StudyDesign& design) {
    const auto names = arguments.list(QStringLiteral("questionnaire"));
    CHIRON_TRY(names);
    std::vector<const psychophysics::Questionnaire*> all;
    QStringList known;
    for (const psychophysics::Questionnaire& each : design.questionnaires) {
        known << QString::fromStdString(each.id);
        if (names->isEmpty() || names->contains(known.last()))
            all.push_back(&each);
    }
    for (const QString& name : *names)
        if (!known.contains(name))
            return wrongUse(
                QStringLiteral("--questionnaire: %1: the study has no such questionnaire; expected one of %2")
                    .arg(quoted(name), known.join(QStringLiteral(", "))));
    if (all.empty())
        return wrongUse(QStringLiteral("study %1: no questionnaires; expected a study that has some")
                            .arg(quoted(QString::fromStdString(design.id))));
    return all;
}

void refuse(SheetAnswer& answer, const QString& found, SheetFaults& faults) {
    answer.faulty = true;
    faults.add(answer.place, found, expectedAnswer(*answer.asked.item, "en"));
}

void takeWords(SheetAnswer& answer, const QString& words, SheetFaults& faults) {
    const QuestionnaireItem& item = *answer.asked.item;
    if (words.isEmpty())
        return;
    if (item.kind == QuestionnaireItem::Kind::text) {
        answer.text = words;
        if (words.toUcs4().size() > kLongestText)
            refuse(answer, QStringLiteral("%1 characters").arg(words.size()), faults);
        return;
    }
    if (item.kind == QuestionnaireItem::Kind::choice) {
        if (const int chosen = choiceNamed(item, words); chosen >= 0) {
            answer.number = chosen;
            return;
        }
    }
    bool isNumber = false;
    const double value = words.toDouble(&isNumber);
    const bool meant = item.kind != QuestionnaireItem::Kind::choice || !choicesAreNumbers(item);
    if (isNumber && meant && fits(item, value))
        answer.number = value;
    else
        refuse(answer, quoted(words), faults);
}

void takeNumber(SheetAnswer& answer, double value, SheetFaults& faults) {
    if (answer.asked.item->kind != QuestionnaireItem::Kind::text && fits(*answer.asked.item, value))
        answer.number = value;
    else
        refuse(answer, QString::number(value), faults);
}

} // namespace chiron::cli
