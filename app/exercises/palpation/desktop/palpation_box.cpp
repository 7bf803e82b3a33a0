// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_box.h"

#include "app/exercises/palpation/desktop/palpation_map_view.h"
#include "app/exercises/palpation/desktop/palpation_words.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/widgets/kit.h"

#include <QComboBox>
#include <QCoreApplication>
#include <cmath>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PalpationFindings)
};

constexpr int kMapHeight_px = 330;

QString mm(double metres, const QLocale& locale) {
    return locale.toString(qRound(1e3 * metres));
}

QString saidOf(const simulation::Finding& said, const scoring::LumpTruth& lump,
               const simulation::PalpationParameters& level, const QLocale& locale) {
    QStringList parts;
    if (level.asksSize)
        parts << Words::tr("stated size %1, true size %2")
                     .arg(sizeText(said.radius_m, locale), sizeText(lump.radius_m, locale));
    if (level.asksHardness)
        parts << Words::tr("stated hardness %1, true hardness %2")
                     .arg(hardnessWord(said.hardness), hardnessWord(lump.hardness));
    if (level.asksConfidence)
        parts << Words::tr("confidence: %1").arg(confidenceWord(said.confidence));
    return parts.join(QStringLiteral("; "));
}

QString lumpLine(std::size_t i, const session::PalpationTrialRecord& record,
                 const simulation::PalpationParameters& level, const QLocale& locale) {
    const scoring::LumpTruth& lump = record.answer.truth.lumps[i];
    const QString number = locale.toString(static_cast<int>(i) + 1);
    const scoring::FindingMatch* match = scoring::foundBy(record.answer.matches, static_cast<int>(i));
    if (!match)
        return Words::tr("Lump %1 (%2, %3 mm deep): missed")
            .arg(number, sizeText(lump.radius_m, locale), mm(lump.depth_m, locale));
    const simulation::Finding& said = record.answer.findings.list()[static_cast<std::size_t>(match->finding)];
    const QString found =
        Words::tr("Lump %1: found, finding %2, %3 mm from its centre")
            .arg(number, locale.toString(match->finding + 1), mm(match->distance_m, locale));
    const QString more = saidOf(said, lump, level, locale);
    return more.isEmpty() ? found : Words::tr("%1; %2").arg(found, more);
}

} // namespace

QString palpationSummary(const session::PalpationTrialRecord& record, const QLocale& locale) {
    const scoring::PalpationAnswer& answer = record.answer;
    QStringList parts;
    if (answer.truth.lumps.empty())
        parts << (answer.falseAlarms() == 0 ? Words::tr("There was no lump, and none was reported.")
                                            : Words::tr("There was no lump."));
    else
        parts << Words::tr("Lumps found: %1 of %2.")
                     .arg(locale.toString(answer.hits()),
                          locale.toString(static_cast<int>(answer.truth.lumps.size())));
    if (answer.falseAlarms() > 0)
        parts
            << Words::tr("Findings where there was no lump: %1.").arg(locale.toString(answer.falseAlarms()));
    parts << Words::tr("Searched: %1 %.").arg(locale.toString(static_cast<int>(100.0 * record.coverage)));
    if (record.timedOut)
        parts << Words::tr("Time was up before the search was reported as done.");
    return parts.join(QLatin1Char(' '));
}

QStringList palpationLines(const session::PalpationTrialRecord& record,
                           const simulation::PalpationParameters& level, const QLocale& locale) {
    QStringList lines;
    for (std::size_t i = 0; i < record.answer.truth.lumps.size(); ++i)
        lines << lumpLine(i, record, level, locale);
    for (const scoring::FindingMatch& match : record.answer.matches) {
        if (match.hit())
            continue;
        const QString number = locale.toString(match.finding + 1);
        lines << (std::isfinite(match.distance_m)
                      ? Words::tr("Finding %1: no lump there; the nearest was %2 mm away")
                            .arg(number, mm(match.distance_m, locale))
                      : Words::tr("Finding %1: no lump there").arg(number));
    }
    return lines;
}

PalpationBox::PalpationBox(const Theme& theme, const QLocale& locale,
                           const simulation::PalpationParameters& level,
                           std::vector<session::PalpationTrialRecord> records, QWidget* parent)
    : QWidget(parent), m_locale(locale), m_level(level), m_records(std::move(records)),
      m_choice(new QComboBox), m_words(kit::label(theme, {}, TextStyle::strong)),
      m_lumps(kit::label(theme, {})) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    m_choice->setObjectName(QStringLiteral("debrief.trial"));
    m_choice->setAccessibleName(tr("Trial"));
    for (const session::PalpationTrialRecord& record : m_records)
        m_choice->addItem(tr("Trial %1").arg(m_locale.toString(record.trial + 1)));
    m_words->setObjectName(QStringLiteral("debrief.palpation"));
    m_lumps->setObjectName(QStringLiteral("debrief.lumps"));
    auto* head = new ResponsiveRow(theme.px(560), theme.px(12));
    head->add(m_choice, 0);
    head->add(m_words, 1);
    column->addWidget(head);
    const report::PlotTheme look = plotThemeOf(theme, locale);
    auto* row = new ResponsiveRow(theme.px(700), theme.px(12));
    m_coverage = new PalpationMapView(look);
    m_coverage->setObjectName(QStringLiteral("debrief.coverage_map"));
    m_force = new PalpationMapView(look);
    m_force->setObjectName(QStringLiteral("debrief.force_map"));
    for (PalpationMapView* map : {m_coverage, m_force}) {
        map->setMinimumHeight(theme.px(kMapHeight_px));
        row->add(map);
    }
    column->addWidget(row);
    column->addWidget(m_lumps);
    connect(m_choice, &QComboBox::currentIndexChanged, this, &PalpationBox::choose);
    choose(0);
}

void PalpationBox::choose(int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= m_records.size())
        return;
    const session::PalpationTrialRecord& record = m_records[static_cast<std::size_t>(index)];
    m_words->setText(palpationSummary(record, m_locale));
    m_lumps->setText(palpationLines(record, m_level, m_locale).join(QLatin1Char('\n')));
    m_coverage->show(record.map, mapViewOf(record, m_level, simulation::SurfaceMapKind::coverage));
    m_force->show(record.map, mapViewOf(record, m_level, simulation::SurfaceMapKind::force));
}

} // namespace chiron::desktop
