// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/difference_table.h"

#include "desktop/studies/field_grid.h"
#include "desktop/studies/procedure_form.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using namespace psychophysics;

namespace {
constexpr int kMostTyped = 64; // longer tables are generated or imported
constexpr int kMostCandidates = 4096;
} // namespace

double usualReference(Attribute attribute) {
    switch (attribute) {
    case Attribute::stiffness:
        return 300.0;
    case Attribute::mass:
        return 0.1;
    case Attribute::deformation:
        return 1.0;
    case Attribute::roughness:
        return 50e-6;
    case Attribute::friction:
        return 0.3;
    case Attribute::viscosity:
        return 2.0;
    case Attribute::apex:
        return 0.02;
    }
    return 1.0;
}

void takeTask(Condition& condition, Task task) {
    condition.task = task;
    const bool threshold = task == Task::twoAfc || task == Task::threeAfc || task == Task::oddity;
    condition.scale = threshold ? ProcedureScale::logDifference : ProcedureScale::difference;
    condition.procedures = {usualProcedure(kindsFor(task).front(), condition)};
}

std::vector<double> differencesBetween(double low, double high, int count) {
    std::vector<double> differences;
    const double from = std::log(study_words::differenceOf(low));
    const double to = std::log(study_words::differenceOf(high));
    for (int i = 0; i < count; ++i)
        differences.push_back(std::exp(from + (to - from) * i / std::max(1, count - 1)));
    return differences;
}

std::vector<double> differencesAround(double high, int count) {
    std::vector<double> differences;
    const double end = study_words::differenceOf(high);
    for (int i = 0; i < count; ++i)
        differences.push_back(end * (2.0 * i / std::max(1, count - 1) - 1.0));
    return differences;
}

DifferenceTable::DifferenceTable(const Theme& theme, const QLocale& locale, bool readOnly, const StimulusDesign& stimulus, QWidget* parent)
    : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(10));
    auto* words = kit::label(theme, summary(stimulus, locale));
    words->setObjectName(QStringLiteral("differences.summary"));
    column->addWidget(words);
    const std::vector<double>& now = stimulus.differences;
    if (!now.empty()) {
        m_bothSides = now.front() < 0.0;
        m_low_percent = std::max(0.01, 100.0 * study_words::ratioOf(std::abs(now.front())));
        m_high_percent = std::max(0.02, 100.0 * study_words::ratioOf(now.back()));
        m_count = static_cast<int>(now.size());
    }
    if (readOnly)
        return;
    auto* grid = new FieldGrid(theme, locale, false);
    grid->number(tr("Smallest"), QStringLiteral("differences.low"), m_low_percent, {0.01, 1000, 2, QStringLiteral("%"), 0.5}, [this](double to) { m_low_percent = to; });
    grid->number(tr("Largest"), QStringLiteral("differences.high"), m_high_percent, {0.02, 1000, 2, QStringLiteral("%"), 5}, [this](double to) { m_high_percent = to; });
    grid->whole(tr("Number"), QStringLiteral("differences.count"), m_count, 1, kMostCandidates, [this](int to) { m_count = to; });
    grid->check(tr("On both sides of the reference"), QStringLiteral("differences.both"), m_bothSides, [this](bool to) { m_bothSides = to; });
    if (now.size() <= kMostTyped) {
        std::vector<double> percents;
        for (const double difference : now)
            percents.push_back(std::round(1e4 * study_words::ratioOf(difference)) / 100.0);
        QLineEdit* typed = grid->list(tr("Or type them, in per cent"), QStringLiteral("differences.typed"), percents, [this](std::vector<double> to) { m_typed = std::move(to); });
        connect(typed, &QLineEdit::editingFinished, this, [this] {
            if (m_typed.empty())
                return;
            std::vector<double> differences;
            for (const double percent : m_typed)
                if (percent > -100.0)
                    differences.push_back(study_words::differenceOf(0.01 * percent));
            std::sort(differences.begin(), differences.end());
            m_typed.clear();
            emit changed(differences);
        });
    }
    column->addWidget(grid);
    auto* make = kit::button(theme, tr("Create the table"), "", QStringLiteral("view-refresh"));
    make->setObjectName(QStringLiteral("differences.make"));
    connect(make, &QPushButton::clicked, this, &DifferenceTable::generate);
    column->addWidget(make, 0, Qt::AlignLeft);
}

void DifferenceTable::generate() {
    const double high = 0.01 * std::max(m_high_percent, m_low_percent);
    emit changed(m_bothSides ? differencesAround(high, m_count) : differencesBetween(0.01 * m_low_percent, high, m_count));
}

QString DifferenceTable::summary(const StimulusDesign& stimulus, const QLocale& locale) const {
    if (stimulus.differences.empty())
        return tr("No candidates yet.");
    const double low = stimulus.differences.front();
    const double high = stimulus.differences.back();
    const auto valueOf = [&](double difference) { return study_words::value(stimulus.reference * std::pow(10.0, difference), stimulus.attribute, locale); };
    return tr("%1 candidates, from %2 to %3 of the reference: %4 to %5.")
        .arg(locale.toString(static_cast<int>(stimulus.differences.size())), study_words::percent(study_words::ratioOf(low), locale),
             study_words::percent(study_words::ratioOf(high), locale), valueOf(low), valueOf(high));
}

} // namespace chiron::desktop
