// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/difference_table.h"

#include "desktop/studies/field_grid.h"
#include "desktop/studies/levels_table.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using namespace psychophysics;

namespace {
constexpr int kMostTyped = 64; // longer tables are generated or imported
constexpr int kMostCandidates = 4096;
constexpr int kApexTrials = 10;
constexpr double kPercent = 100.0;
constexpr double kUsualLow = 0.02; // share of the reference
constexpr double kUsualHigh = 0.6;
constexpr int kUsualCount = 40;
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

void takeAttribute(Condition& condition, Attribute attribute) {
    constexpr double kApexStiffness_N_per_m = 500.0;
    const bool wasApex = condition.stimulus.attribute == Attribute::apex;
    condition.stimulus.attribute = attribute;
    condition.stimulus.reference = usualReference(attribute);
    condition.stimulus.fixed.clear();
    if (attribute == Attribute::apex) {
        condition.stimulus.differences = {0.0};
        condition.stimulus.fixed = {{"stiffness_N_per_m", kApexStiffness_N_per_m}};
        condition.task = Task::adjustment;
        condition.scale = ProcedureScale::difference;
        condition.procedures = {ConstantSpec{{0.0}, kApexTrials, true}};
    } else if (wasApex) {
        condition.stimulus.differences = differencesBetween(kUsualLow, kUsualHigh, kUsualCount);
        takeTask(condition, Task::rank3);
    }
}

DifferenceTable::DifferenceTable(const Theme& theme, const QLocale& locale, bool readOnly,
                                 const StimulusDesign& stimulus, bool mayBeLess, QWidget* parent)
    : QWidget(parent), m_locale(locale), m_stimulus(stimulus), m_mayBeLess(mayBeLess) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(10));
    m_summary = kit::label(theme, summary());
    m_summary->setObjectName(QStringLiteral("differences.summary"));
    column->addWidget(m_summary);
    const std::vector<double>& now = stimulus.differences;
    if (!now.empty()) {
        m_bothSides = now.front() < 0.0;
        m_low_percent = std::max(0.01, kPercent * study_words::ratioOf(std::abs(now.front())));
        m_high_percent = std::max(0.02, kPercent * study_words::ratioOf(now.back()));
        m_count = static_cast<int>(now.size());
    }
    m_grid = new FieldGrid(theme, locale, readOnly);
    if (!readOnly)
        addMaker(theme, *m_grid);
    if (now.size() <= kMostTyped)
        addLevels(theme, readOnly, *m_grid);
    column->addWidget(m_grid);
}

void DifferenceTable::addMaker(const Theme&, FieldGrid& grid) {
    // Half-typed numbers must not generate a table.
    const auto onceTyped = [](QAbstractSpinBox* field) { field->setKeyboardTracking(false); };
    onceTyped(grid.number(tr("Smallest"), QStringLiteral("differences.low"), m_low_percent,
                          {0.01, 1000, 2, QStringLiteral("%"), 0.5}, [this](double to) {
                              m_low_percent = to;
                              generate();
                          }));
    grid.explain(QStringLiteral("differences.low"), tr("Too small for anybody to feel."),
                 {0.01, 1000, kPercent * kUsualLow});
    grid.setShown(QStringLiteral("differences.low"), !m_bothSides);
    onceTyped(grid.number(tr("Largest"), QStringLiteral("differences.high"), m_high_percent,
                          {0.02, 1000, 2, QStringLiteral("%"), 5}, [this](double to) {
                              m_high_percent = to;
                              generate();
                          }));
    grid.explain(QStringLiteral("differences.high"), tr("Large enough for everybody to feel."),
                 {0.02, 1000, kPercent * kUsualHigh});
    onceTyped(grid.whole(tr("Number"), QStringLiteral("differences.count"), m_count, 1, kMostCandidates,
                         [this](int to) {
                             m_count = to;
                             generate();
                         }));
    grid.explain(QStringLiteral("differences.count"),
                 m_bothSides
                     ? tr("How many differences there are to choose from. Each object is larger than the one "
                          "before by the same factor.")
                     : tr("How many differences there are to choose from. They are spaced geometrically: "
                          "each is larger than the one before by about the same factor."),
                 {1, kMostCandidates, kUsualCount});
    grid.check(tr("On both sides of the reference"), QStringLiteral("differences.both"), m_bothSides,
               [this](bool to) { takeBothSides(to); });
    grid.explain(QStringLiteral("differences.both"),
                 tr("Objects whose attribute is weaker than the reference's are presented as well."));
    // A table that already has them can be regenerated without them.
    grid.setShown(QStringLiteral("differences.both"), m_mayBeLess || m_bothSides);
}

void DifferenceTable::addLevels(const Theme& theme, bool readOnly, FieldGrid& grid) {
    std::vector<double> percents;
    for (const double difference : m_stimulus.differences)
        percents.push_back(kPercent * study_words::ratioOf(difference));
    const QString name = QStringLiteral("differences.levels");
    m_levels =
        new LevelsTable(theme, m_locale, readOnly, name, percents, [this](const std::vector<double>& of) {
            return objectsOf(m_stimulus, of, m_locale);
        });
    grid.control(tr("Differences"), name, m_levels);
    grid.explain(
        name,
        tr("Change them one by one, or paste them from a table; numbers may have decimal points or commas."));
    connect(m_levels, &LevelsTable::unread, this,
            [this, name](const QString& words) { m_grid->setUnread(name, words); });
    connect(m_levels, &LevelsTable::changed, this, &DifferenceTable::typed);
}

void DifferenceTable::typed(const std::vector<double>& percents) {
    std::vector<double> differences;
    for (const double percent : percents) {
        if (percent <= -kPercent) {
            m_grid->setUnread(QStringLiteral("differences.levels"),
                              tr("%1 % less than the reference would be below zero.")
                                  .arg(m_locale.toString(-percent, 'g', 6)));
            return;
        }
        differences.push_back(study_words::differenceOf(percent / kPercent));
    }
    std::sort(differences.begin(), differences.end());
    emit changed(differences);
}

/// A table on one side has a smallest difference, which one on both sides did not need: it becomes the usual
/// one, or a tenth of a largest that is smaller still.
void DifferenceTable::takeBothSides(bool both) {
    constexpr double kLeast_percent = 0.01;
    const QString low = QStringLiteral("differences.low");
    m_bothSides = both;
    m_grid->setShown(low, !both);
    if (!both && m_low_percent >= m_high_percent) {
        const double usual_percent = kPercent * kUsualLow;
        m_low_percent =
            usual_percent < m_high_percent ? usual_percent : std::max(kLeast_percent, 0.1 * m_high_percent);
        auto* field = qobject_cast<QDoubleSpinBox*>(m_grid->field(low));
        const QSignalBlocker quiet(field);
        field->setValue(m_low_percent);
    }
    generate();
}

void DifferenceTable::generate() {
    const bool turned = !m_bothSides && m_count > 1 && m_low_percent >= m_high_percent;
    for (const char* end : {"differences.low", "differences.high"})
        m_grid->setConflict(QLatin1String(end), turned ? tr("The smallest difference has to be below the "
                                                            "largest. The table was not changed.")
                                                       : QString());
    if (turned)
        return;
    const double high = m_high_percent / kPercent;
    emit changed(m_bothSides ? differencesAround(high, m_count)
                             : differencesBetween(m_low_percent / kPercent, high, m_count));
}

void DifferenceTable::showObjects(const StimulusDesign& stimulus) {
    m_stimulus.reference = stimulus.reference;
    m_stimulus.attribute = stimulus.attribute;
    m_summary->setText(summary());
    if (m_levels)
        m_levels->showValues();
}

QString DifferenceTable::summary() const {
    if (m_stimulus.differences.empty())
        return tr("No candidates yet.");
    const double low = m_stimulus.differences.front();
    const double high = m_stimulus.differences.back();
    const QStringList ends =
        study_words::percents({study_words::ratioOf(low), study_words::ratioOf(high)}, m_locale);
    const QStringList objects = study_words::values(
        {m_stimulus.reference * std::pow(10.0, low), m_stimulus.reference * std::pow(10.0, high)},
        m_stimulus.attribute, m_locale);
    return tr("%1 candidates, from %2 to %3 of the reference: %4 to %5.")
        .arg(m_locale.toString(static_cast<int>(m_stimulus.differences.size())), ends.front(), ends.back(),
             objects.front(), objects.back());
}

} // namespace chiron::desktop
