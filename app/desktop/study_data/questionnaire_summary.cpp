// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/questionnaire_summary.h"

#include "desktop/plots/plot_theme_of.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "psychophysics/measures/instrument_score.h"
#include "report/plot_view.h"
#include "session/study/questionnaire_replies.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::desktop {

using psychophysics::QuestionnaireItem;

namespace {

double quantileOf(const std::vector<double>& sorted, double q) {
    const double at = q * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

} // namespace

QuestionnaireSummary::QuestionnaireSummary(AppContext& app, const StudyFacts& facts, QWidget* parent)
    : QWidget(parent), m_app(app), m_facts(facts) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(app.theme().px(14));
    if (facts.study.design.questionnaires.empty())
        column->addWidget(kit::notice(app.theme(), "info", tr("This study has no questionnaires.")));
    for (const psychophysics::Questionnaire& questionnaire : facts.study.design.questionnaires)
        column->addWidget(questionnaireBox(questionnaire));
}

QWidget* QuestionnaireSummary::questionnaireBox(const psychophysics::Questionnaire& questionnaire) const {
    const Theme& theme = m_app.theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(
        kit::label(theme, study_words::text(questionnaire.title, m_app.language()), TextStyle::title));
    int people = 0;
    for (const auto& [participant, id] : m_facts.study.answered)
        people += id == questionnaire.id ? 1 : 0;
    box.layout->addWidget(kit::label(theme,
                                     people == 0 ? tr("Nobody has answered it yet.")
                                                 : tr("Answered by %n participant(s)", nullptr, people),
                                     TextStyle::body, "muted"));
    const auto parts = session::answeredParts(m_facts.study.design, questionnaire, m_facts.answers);
    if (people > 0 && parts.empty())
        box.layout->addWidget(kit::notice(
            theme, "info", tr("Answers about single conditions are shown once the study is unblinded.")));
    for (const session::AnsweredPart& part : parts) {
        if (!part.label.empty()) {
            auto* about = kit::label(
                theme,
                tr("About the condition %1").arg(conditionName(m_facts.study, part.label, m_app.language())),
                TextStyle::title);
            about->setObjectName(
                QStringLiteral("summary.%1.%2")
                    .arg(QString::fromStdString(questionnaire.id), QString::fromStdString(part.label)));
            box.layout->addWidget(about);
        }
        for (const QString& line : scoreLines(questionnaire, part.answers))
            box.layout->addWidget(kit::label(theme, line, TextStyle::strong));
        if (people > 0)
            for (const QuestionnaireItem& item : questionnaire.items) {
                box.layout->addWidget(kit::rule());
                box.layout->addWidget(itemPart(item, part.answers));
            }
    }
    return box.frame;
}

/// The instrument's scores from the answers: first the total, then its parts.
QStringList
QuestionnaireSummary::scoreLines(const psychophysics::Questionnaire& questionnaire,
                                 const std::vector<database::QuestionnaireAnswer>& answers) const {
    std::map<database::ParticipantNumber, psychophysics::QuestionnaireReply> replies;
    for (const database::QuestionnaireAnswer& answer : answers)
        if (answer.number)
            replies[answer.participant].numbers[answer.item] = *answer.number;
    std::vector<std::pair<std::string, std::vector<double>>> values;
    for (const auto& [participant, reply] : replies)
        for (const psychophysics::InstrumentScore& score :
             psychophysics::instrumentScores(questionnaire, reply)) {
            auto at = std::find_if(values.begin(), values.end(),
                                   [&](const auto& each) { return each.first == score.id; });
            if (at == values.end())
                at = values.insert(values.end(), {score.id, {}});
            if (std::isfinite(score.value))
                at->second.push_back(score.value);
        }
    QStringList lines;
    for (auto& [id, numbers] : values) {
        if (numbers.empty())
            continue;
        std::sort(numbers.begin(), numbers.end());
        const auto shown = [&](double value) { return m_app.locale().toString(value, 'f', 1); };
        lines << tr("%1: median %2, from %3 to %4, of %n participant(s)", nullptr,
                    static_cast<int>(numbers.size()))
                     .arg(scoreName(id, questionnaire), shown(quantileOf(numbers, 0.5)),
                          shown(numbers.front()), shown(numbers.back()));
    }
    return lines;
}

/// Name of a score, or of the scale that it belongs to.
QString QuestionnaireSummary::scoreName(const std::string& id,
                                        const psychophysics::Questionnaire& questionnaire) const {
    if (id == "sus")
        return tr("Usability score (0 to 100)");
    if (id == "workload")
        return tr("Workload (0 to 100)");
    if (id == "laterality_quotient")
        return tr("Laterality quotient (−100 left, 100 right)");
    for (const QuestionnaireItem& item : questionnaire.items)
        if (item.id == id)
            return study_words::text(item.text, m_app.language()).section(u'.', 0, 0);
    return QString::fromStdString(id);
}

QWidget* QuestionnaireSummary::itemPart(const QuestionnaireItem& item,
                                        const std::vector<database::QuestionnaireAnswer>& answers) const {
    const Theme& theme = m_app.theme();
    const QLocale locale = m_app.locale();
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(6));
    column->addWidget(kit::label(theme, study_words::text(item.text, m_app.language()), TextStyle::strong));
    std::vector<double> numbers;
    QStringList texts;
    for (const database::QuestionnaireAnswer& answer : answers) {
        if (answer.item != item.id)
            continue;
        if (answer.number)
            numbers.push_back(*answer.number);
        else if (!answer.text.empty())
            texts << QString::fromStdString(answer.text);
    }
    std::sort(numbers.begin(), numbers.end());
    if (numbers.empty() && texts.isEmpty())
        column->addWidget(kit::label(theme, tr("No answers"), TextStyle::body, "muted"));
    if (!numbers.empty() && item.kind != QuestionnaireItem::Kind::choice)
        column->addWidget(
            kit::label(theme, tr("Median %1, interquartile range %2 to %3")
                                  .arg(study_words::plainNumber(quantileOf(numbers, 0.5), locale),
                                       study_words::plainNumber(quantileOf(numbers, 0.25), locale),
                                       study_words::plainNumber(quantileOf(numbers, 0.75), locale))));
    if (!numbers.empty() && item.kind != QuestionnaireItem::Kind::number)
        column->addWidget(barsOf(item, numbers));
    for (const QString& text : texts)
        column->addWidget(kit::label(theme, tr("“%1”").arg(text), TextStyle::body));
    return part;
}

QWidget* QuestionnaireSummary::barsOf(const QuestionnaireItem& item,
                                      const std::vector<double>& numbers) const {
    const Theme& theme = m_app.theme();
    const bool likert = item.kind == QuestionnaireItem::Kind::likert;
    const int first = likert ? 1 : 0;
    const int count = likert ? item.scale : static_cast<int>(item.choices.size());
    std::vector<QString> names;
    std::vector<report::PlotPoint> tops;
    for (int i = 0; i < count; ++i) {
        names.push_back(likert
                            ? m_app.locale().toString(i + 1)
                            : study_words::text(item.choices[static_cast<std::size_t>(i)], m_app.language()));
        tops.push_back(
            {static_cast<double>(i), static_cast<double>(std::count(numbers.begin(), numbers.end(),
                                                                    static_cast<double>(first + i)))});
    }
    auto* plot = new report::PlotView(plotThemeOf(theme, m_app.locale()));
    plot->setMinimumHeight(theme.px(180));
    plot->setLegendShown(false);
    plot->setTitle({});
    plot->setYWholeNumbers();
    plot->setYAxis({tr("Answers"), 0.0, {}});
    plot->setXAxis({likert ? tr("%1 … %2").arg(study_words::text(item.low, m_app.language()),
                                               study_words::text(item.high, m_app.language()))
                           : QString(),
                    {},
                    {}});
    plot->addBars(tr("answers"), tops, report::PlotStyle::solidA, 0, 1);
    plot->setXCategories(names);
    return plot;
}

} // namespace chiron::desktop
