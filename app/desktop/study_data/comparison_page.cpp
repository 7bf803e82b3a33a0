// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/comparison_page.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/widgets/kit.h"
#include "session_report/group_words.h"
#include "session_report/study_comparison_words.h"

#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr int kMostCompared = 14; ///< visible rows
}

ComparisonPage::ComparisonPage(AppContext& app, const StudyFacts& facts, QWidget* parent)
    : QWidget(parent), m_app(app), m_facts(facts) {
    const Theme& theme = app.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    const kit::Box box = kit::box(theme);
    column->addWidget(box.frame);
    box.frame->setObjectName(QStringLiteral("data.comparisons"));
    box.layout->addWidget(kit::label(theme, tr("Conditions compared"), TextStyle::title));
    fill(*box.layout);
}

void ComparisonPage::fill(QVBoxLayout& layout) {
    const Theme& theme = m_app.theme();
    const auto say = [&](const QString& words) {
        layout.addWidget(kit::label(theme, words, TextStyle::body, "muted"));
    };
    if (conditionLabels(m_facts.study).size() < 2)
        return say(tr("This study has only one condition, so there is nothing to compare it with."));
    if (m_facts.study.blind())
        return say(session_report::comparisonSealed());
    for (std::size_t i = 0; i < m_facts.groups.size(); ++i)
        if (const QString words =
                session_report::weberOfCondition(m_facts.groups[i], name(i), m_app.locale());
            !words.isEmpty()) {
            auto* weber = kit::label(theme, words, TextStyle::strong);
            weber->setObjectName(QStringLiteral("data.compared_weber"));
            layout.addWidget(weber);
        }
    for (const session::ComparedConditions& each : m_facts.comparisons) {
        auto* verdict = kit::label(theme, session_report::comparisonVerdict(
                                              each, name(each.first), name(each.second), m_app.locale()));
        verdict->setObjectName(QStringLiteral("data.verdict"));
        layout.addWidget(verdict);
    }
    if (!m_facts.comparisons.empty()) {
        layout.addWidget(table());
        layout.addWidget(
            kit::label(theme, session_report::comparisonNote(session::testsThresholds(m_facts.comparisons)),
                       TextStyle::small, "muted"));
    }
    if (std::any_of(m_facts.apexes.begin(), m_facts.apexes.end(),
                    [](const auto& each) { return each.has_value(); }))
        return say(tr("Weber fractions are compared. The search for an apex has none: its groups tell errors "
                      "in millimetres."));
    auto* rule = kit::label(theme, session_report::groupRule(), TextStyle::small, "muted");
    rule->setObjectName(QStringLiteral("data.rule"));
    layout.addWidget(rule);
    for (const QString& words : session_report::comparisonSentences(
             m_facts.rolls, m_facts.comparisons, [this](std::size_t at) { return name(at); },
             m_app.locale())) {
        auto* notice = kit::notice(theme, "info", words);
        notice->setObjectName(QStringLiteral("data.comparison_missing"));
        layout.addWidget(notice);
    }
}

QString ComparisonPage::name(std::size_t condition) const {
    return conditionName(m_facts.study, conditionLabels(m_facts.study)[condition], m_app.language());
}

QWidget* ComparisonPage::table() {
    const bool thresholds = session::testsThresholds(m_facts.comparisons);
    const std::vector<QString> headings = session_report::comparisonHeadings(thresholds);
    auto* table = new FittedTable(m_app.theme(), static_cast<int>(headings.size()));
    table->setObjectName(QStringLiteral("data.comparison_table"));
    table->setAccessibleName(tr("Conditions compared"));
    table->setHorizontalHeaderLabels(QStringList(headings.begin(), headings.end()));
    table->setRowCount(static_cast<int>(m_facts.comparisons.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const session::ComparedConditions& each = m_facts.comparisons[static_cast<std::size_t>(row)];
        const std::vector<QString> cells = session_report::comparisonRow(
            each, name(each.first), name(each.second), thresholds, m_app.locale());
        for (int column = 0; column < static_cast<int>(cells.size()); ++column)
            table->setItem(row, column, new QTableWidgetItem(cells[static_cast<std::size_t>(column)]));
    }
    table->setRowsSeen(std::clamp(table->rowCount(), 1, kMostCompared));
    return table;
}

} // namespace chiron::desktop
