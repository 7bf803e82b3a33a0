// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_panel.h"

#include "app/exercises/palpation/desktop/lean_dial.h"
#include "app/exercises/palpation/desktop/palpation_words.h"
#include "app/exercises/palpation/session_report/finger_words.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/target_bar.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QGridLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::desktop {

namespace {

constexpr double kPlotHeight_px = 64;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kLeanLimit_deg = 30.0; // limit of the platform (P3)
constexpr double kLeanAxis_deg = 60.0;

simulation::PalpationCues asksOf(const simulation::PalpationParameters& level) {
    simulation::PalpationCues asks;
    asks.asksSize = level.asksSize;
    asks.asksHardness = level.asksHardness;
    asks.asksConfidence = level.asksConfidence;
    return asks;
}

} // namespace

PalpationPanel::PalpationPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues,
                               const simulation::PalpationParameters& level, QWidget* parent)
    : InfoView(theme, {.edge_px = 8.0, .gap_px = 8.0}, parent), m_theme(theme), m_locale(locale),
      m_cues(cues), m_level(level) {
    addElapsed(kit::line(theme, {}, TextStyle::body, "muted"), Qt::AlignRight);
    m_findings = new FindingsBox(theme, locale, asksOf(level), level.tissue.contactRadius_m);
    parts().addWidget(m_findings);
    parts().addWidget(kit::rule());
    if (cues.bars)
        addBars();
    if (cues.coverage)
        addCoverage();
    if (cues.numbers)
        addNumbers();
    if (cues.plots)
        addPlots();
    addFoot(cues, cues.bars || cues.numbers || cues.plots || cues.coverage);
}

void PalpationPanel::addBars() {
    for (int tool = 0; tool < tools(); ++tool) {
        const QString name = tr("%1: force").arg(fingerName(tool, m_level.hands, m_level.fingers));
        auto* bar = new TargetBar(m_theme, m_locale, {name, tr("N"), 1.25 * m_level.maximumForce_N, 2},
                                  m_cues.numbers);
        bar->setObjectName(QStringLiteral("training.force_bar_%1").arg(tool));
        bar->setLimit(m_level.maximumForce_N);
        m_force.push_back(bar);
        parts().addWidget(bar);
    }
    for (int hand = 0; m_level.pinch && hand < m_level.hands; ++hand) {
        const QString name =
            m_level.hands > 1 ? tr("%1: squeeze of the jaw")
                                    .arg(fingerName(hand * m_level.fingers, m_level.hands, m_level.fingers))
                              : tr("Squeeze of the jaw");
        auto* bar = new TargetBar(m_theme, m_locale, {name, tr("N"), 1.25 * m_level.maximumForce_N, 2},
                                  m_cues.numbers);
        bar->setObjectName(QStringLiteral("training.squeeze_bar_%1").arg(hand));
        bar->setLimit(m_level.maximumForce_N);
        m_squeeze.push_back(bar);
        parts().addWidget(bar);
    }
    m_lean = new LeanDial(m_theme, m_locale, tools());
    m_lean->setObjectName(QStringLiteral("training.lean"));
    parts().addWidget(m_lean);
}

void PalpationPanel::addCoverage() {
    m_coverage = kit::label(m_theme, {}, TextStyle::strong);
    m_coverage->setObjectName(QStringLiteral("training.coverage"));
    parts().addWidget(m_coverage);
    m_forceMap = new QCheckBox(tr("Force map (M)"));
    m_forceMap->setObjectName(QStringLiteral("training.force_map"));
    m_forceMap->setToolTip(tr(
        "On: the map shows how hard the tissue was pressed. Off: it shows where the tissue was searched."));
    parts().addWidget(m_forceMap);
}

bool PalpationPanel::showsForceMap() const {
    return m_forceMap && m_forceMap->isChecked();
}

void PalpationPanel::switchMap() {
    if (m_forceMap)
        m_forceMap->toggle();
}

void PalpationPanel::addNumbers() {
    auto* numbers = new QWidget;
    auto* grid = new QGridLayout(numbers);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(m_theme.px(8));
    grid->setVerticalSpacing(0);
    const std::array<QString, 3> heads{tr("rendered force (N)"), tr("tilt (°)"), tr("depth (mm)")};
    for (int c = 0; c < 3; ++c) {
        grid->addWidget(kit::label(m_theme, heads[static_cast<std::size_t>(c)], TextStyle::small, "muted"), 0,
                        c, Qt::AlignBottom);
        grid->setColumnStretch(c, 1);
    }
    for (int tool = 0; tool < tools(); ++tool) {
        const QString finger = fingerName(tool, m_level.hands, m_level.fingers);
        const int row = tools() > 1 ? 2 * tool + 2 : 1;
        if (tools() > 1)
            grid->addWidget(kit::label(m_theme, finger, TextStyle::small), row - 1, 0, 1, 3);
        FingerRow cells;
        for (int c = 0; c < 3; ++c) {
            QLabel* cell = kit::line(m_theme, QStringLiteral("–"), TextStyle::mono);
            cell->setObjectName(QStringLiteral("training.finger_%1_%2").arg(tool).arg(c));
            cell->setAccessibleName(tr("%1: %2").arg(finger, heads[static_cast<std::size_t>(c)]));
            grid->addWidget(cell, row, c);
            cells.number[static_cast<std::size_t>(c)] = cell;
        }
        m_rows.push_back(cells);
    }
    parts().addWidget(numbers);
    addDetail(numbers);
}

LivePlot* PalpationPanel::plot(const char* name, const QString& title, double top, double limit) {
    auto* made = new LivePlot(m_theme, m_locale, title, top, limit);
    made->setObjectName(QLatin1String(name));
    made->setMinimumHeight(m_theme.px(kPlotHeight_px));
    parts().addWidget(made, 1);
    return made;
}

void PalpationPanel::addPlots() {
    m_forcePlot = plot("training.force_plot", tools() > 1 ? tr("Force, first finger (N)") : tr("Force (N)"),
                       1.25 * m_level.maximumForce_N, m_level.maximumForce_N);
    if (m_cues.bars)
        addSpare(m_forcePlot);
    if (m_cues.bars)
        m_leanPlot = plot("training.lean_plot", tools() > 1 ? tr("Tilt, first finger (°)") : tr("Tilt (°)"),
                          kLeanAxis_deg, kLeanLimit_deg);
    if (m_leanPlot)
        addDetail(m_leanPlot); // a detail only, because the dial shows the lean as well
}

void PalpationPanel::showMoving(const haptics::DisplayState& state,
                                std::span<const session::LiveSample> samples) {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    if (cues.present)
        m_findings->show(cues);
    m_findings->setRunning(state.phase == core::TrialPhase::running && !state.paused && !state.ended);
    showFingers(state);
    if (m_cues.plots)
        addSamples(state, samples);
}

void PalpationPanel::showReadings(const haptics::DisplayState& state) {
    if (m_cues.numbers)
        showNumbers(state);
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    if (m_coverage)
        m_coverage->setText(
            tr("Searched: %1 %").arg(m_locale.toString(static_cast<int>(100.0 * cues.coverage))));
}

void PalpationPanel::showFingers(const haptics::DisplayState& state) {
    const simulation::PalpationCues& cues = state.exercise.of<simulation::PalpationCues>();
    for (std::size_t i = 0; i < m_force.size(); ++i) {
        m_force[i]->setBand(cues.bandShown ? cues.bandLow_N : 0.0, cues.bandShown ? cues.bandHigh_N : 0.0);
        m_force[i]->setValue(
            std::hypot(state.tool[i].tissue[0], state.tool[i].tissue[1], state.tool[i].tissue[2]));
    }
    for (std::size_t hand = 0; hand < m_squeeze.size(); ++hand)
        m_squeeze[hand]->setValue(cues.squeezeShown ? cues.squeeze_N[hand] : 0.0);
    for (int i = 0; m_lean && i < tools(); ++i) {
        const auto& pose = state.tool[static_cast<std::size_t>(i)].displayPose;
        m_lean->setLean(i, pose[1], pose[2], (cues.leanSaturated >> i & 1) != 0);
    }
}

void PalpationPanel::showNumbers(const haptics::DisplayState& state) {
    const simulation::PalpationCues& cues = state.exercise.of<simulation::PalpationCues>();
    const auto text = [this](double value, int decimals) {
        return m_locale.toString(value + 0.0, 'f', decimals);
    };
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i].number[0]->setText(text(state.tool[i].displayPose[0], 2));
        if (!m_cues.bars)
            continue; // lean and depth belong to this cue
        m_rows[i].number[1]->setText(text(cues.lean_rad[i] * kDegrees, 0));
        m_rows[i].number[2]->setText(text(cues.depth_m[i] * 1e3, 1));
    }
}

void PalpationPanel::addSamples(const haptics::DisplayState& state,
                                std::span<const session::LiveSample> samples) {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    for (const session::LiveSample& sample : samples)
        m_forcePlot->add(sample.t_s, static_cast<double>(sample.tissueNorm_N));
    if (cues.bandShown)
        m_forcePlot->setBand(cues.bandLow_N, cues.bandHigh_N);
    m_forcePlot->update();
    if (!m_leanPlot)
        return;
    if (!samples.empty())
        m_leanPlot->add(samples.back().t_s, cues.lean_rad[0] * kDegrees);
    m_leanPlot->update();
}

} // namespace chiron::desktop
