// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/insertion_panel.h"

#include "desktop/plots/responsive_row.h"
#include "desktop/training/force_bar.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/signed_bar.h"
#include "desktop/widgets/kit.h"

#include <QGridLayout>
#include <QProgressBar>
#include <cmath>
#include <numbers>

namespace chiron::desktop {

namespace {

constexpr double kAxialTorqueLimit_Nm = 0.010; // about the endoscope's axis: limit of P1's device
constexpr double kOffsetAxis_mm = 3.0;
constexpr double kAlignmentAxis_deg = 20.0;
constexpr double kPlotsSideBySide_px = 330;
// Minimum height: all four plots are visible in a small window, and grow with a larger one.
constexpr double kPlotHeight_px = 64;
constexpr double kDegrees = 180.0 / std::numbers::pi;

core::Vec3 vec(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}
core::Vec3 vec(const std::array<float, 3>& v) {
    return {double(v[0]), double(v[1]), double(v[2])};
}

} // namespace

InsertionPanel::InsertionPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues,
                               const simulation::UrethraInsertionParameters& parameters, QWidget* parent)
    : InfoView(theme, {.edge_px = 8.0, .gap_px = 6.0}, parent), m_theme(theme), m_locale(locale),
      m_cues(cues), m_gauge(parameters),
      m_telling{cues.numbers, cues.guidance, m_gauge.goal_m(), parameters.endoscope.beak_m} {
    addStage();
    addForces(parameters);
    if (cues.numbers)
        addNumbers();
    if (cues.plots)
        addPlots(parameters);
    addFoot(cues, cues.bars || cues.numbers || cues.plots);
}

void InsertionPanel::addStage() {
    m_stage = kit::label(m_theme, stageText({}, m_telling, m_locale), TextStyle::strong);
    m_stage->setObjectName(QStringLiteral("training.stage"));
    addHead(m_stage);
    if (m_telling.numbers || m_telling.guidance) {
        m_progress = new QProgressBar;
        m_progress->setObjectName(QStringLiteral("training.stage_progress"));
        m_progress->setAccessibleName(tr("Progress in this stage"));
        m_progress->setTextVisible(false);
        m_progress->setRange(0, 100);
        QSizePolicy stays = m_progress->sizePolicy();
        stays.setRetainSizeWhenHidden(true); // so that nothing below it moves when it is hidden
        m_progress->setSizePolicy(stays);
        parts().addWidget(m_progress);
    }
}

void InsertionPanel::addForces(const simulation::UrethraInsertionParameters& parameters) {
    if (m_cues.bars) {
        m_resistance =
            new ForceBar(m_theme, m_locale, {tr("Resistance along"), tr("N"), parameters.maximumForce_N, 2},
                         m_cues.numbers);
        m_resistance->setObjectName(QStringLiteral("training.resistance_bar"));
        m_lateral = new ForceBar(m_theme, m_locale,
                                 {tr("Force across"), tr("N"), parameters.lateralLimit_N, 2}, m_cues.numbers);
        m_lateral->setObjectName(QStringLiteral("training.lateral_bar"));
        parts().addWidget(m_resistance);
        parts().addWidget(m_lateral);
    }
    if (!m_cues.bars && !m_cues.numbers)
        return;
    const double force_N = parameters.maximumForce_N;
    const double torque_mNm = parameters.maximumTorque_Nm * 1e3;
    auto* components = new QWidget;
    auto* column = new QVBoxLayout(components);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(parts().spacing());
    column->addWidget(
        kit::label(m_theme, tr("Forces (N) and torques (mN·m) on the endoscope"), TextStyle::small, "muted"));
    addComponents(
        *column, m_force,
        {component("training.force_x", tr("Fx"), tr("Force along x, to the side"), tr("N"), force_N, 2),
         component("training.force_y", tr("Fy"), tr("Force along y, upwards"), tr("N"), force_N, 2),
         component("training.force_z", tr("Fz"), tr("Force along z, into the patient"), tr("N"), force_N,
                   2)});
    addComponents(*column, m_torque,
                  {component("training.torque_x", tr("Tx"), tr("Torque about x"), tr("mN·m"), torque_mNm, 0),
                   component("training.torque_y", tr("Ty"), tr("Torque about y"), tr("mN·m"), torque_mNm, 0),
                   component("training.torque_z", tr("Tz"), tr("Torque about the endoscope's axis"),
                             tr("mN·m"), kAxialTorqueLimit_Nm * 1e3, 1)});
    parts().addWidget(components);
    addDetail(components);
}

SignedBar* InsertionPanel::component(const char* name, const QString& sign, const QString& spoken,
                                     const QString& unit, double limit, int decimals) {
    auto* bar =
        new SignedBar(m_theme, m_locale, {sign, spoken, unit, limit, decimals}, m_cues.bars, m_cues.numbers);
    bar->setObjectName(QLatin1String(name));
    return bar;
}

void InsertionPanel::addComponents(QVBoxLayout& column, std::array<SignedBar*, 3>& into,
                                   std::array<SignedBar*, 3> bars) {
    auto* row = new QHBoxLayout;
    row->setSpacing(m_theme.px(10));
    for (SignedBar* bar : bars)
        row->addWidget(bar, 1);
    column.addLayout(row);
    into = bars;
}

void InsertionPanel::addNumbers() {
    const auto row = [this] {
        auto* box = new QWidget;
        auto* grid = new QGridLayout(box);
        grid->setContentsMargins(0, 0, 0, 0);
        grid->setHorizontalSpacing(m_theme.px(8));
        grid->setVerticalSpacing(0);
        parts().addWidget(box);
        return grid;
    };
    QGridLayout* tip = row();
    m_numbers[0] = addNumber(tr("Tip x (mm)"), "training.tip_x", *tip, 0);
    m_numbers[1] = addNumber(tr("Tip y (mm)"), "training.tip_y", *tip, 1);
    m_numbers[2] = addNumber(tr("Tip z (mm)"), "training.tip_z", *tip, 2);
    addDetail(tip->parentWidget());
    QGridLayout* way = row();
    m_numbers[3] = addNumber(tr("Depth (mm)"), "training.depth", *way, 0);
    m_numbers[4] = addNumber(tr("Off-centre (mm)"), "training.offset", *way, 1);
    m_numbers[5] = addNumber(tr("Alignment (°)"), "training.alignment", *way, 2);
}

QLabel* InsertionPanel::addNumber(const QString& name, const char* objectName, QGridLayout& grid,
                                  int column) {
    grid.addWidget(kit::label(m_theme, name, TextStyle::small, "muted"), 0, column, Qt::AlignBottom);
    auto* number = kit::line(m_theme, QStringLiteral("–"), TextStyle::mono);
    number->setObjectName(QLatin1String(objectName));
    number->setAccessibleName(name);
    grid.addWidget(number, 1, column);
    grid.setColumnStretch(column, 1);
    return number;
}

LivePlot* InsertionPanel::plot(const char* name, const QString& title, double top,
                               std::optional<double> limit) {
    auto* made = new LivePlot(m_theme, m_locale, title, top, limit);
    made->setObjectName(QLatin1String(name));
    made->setMinimumHeight(m_theme.px(kPlotHeight_px));
    return made;
}

void InsertionPanel::addPlots(const simulation::UrethraInsertionParameters& parameters) {
    m_forcePlot = plot("training.force_plot", tr("Force (N)"), parameters.maximumForce_N * 1.25,
                       parameters.maximumForce_N);
    m_lateralPlot = plot("training.lateral_plot", tr("Force across (N)"), parameters.lateralLimit_N * 1.25,
                         parameters.lateralLimit_N);
    m_offsetPlot = plot("training.offset_plot", tr("Off-centre (mm)"), kOffsetAxis_mm);
    m_alignmentPlot = plot("training.alignment_plot", tr("Alignment (°)"), kAlignmentAxis_deg);
    const auto pair = [this](QWidget* left, QWidget* right) {
        auto* row = new ResponsiveRow(m_theme.px(kPlotsSideBySide_px), m_theme.px(8));
        row->add(left);
        row->add(right);
        parts().addWidget(row, 1);
        return row;
    };
    QWidget* first = pair(m_forcePlot, m_offsetPlot);
    if (m_cues.bars && m_cues.numbers)
        addSpare(first);
    addDetail(pair(m_lateralPlot, m_alignmentPlot));
}

void InsertionPanel::showMoving(const haptics::DisplayState& state,
                                std::span<const session::LiveSample> samples) {
    const haptics::ToolDisplay& tool = state.tool[0];
    const core::Quat q_WT(tool.q_WT[0], tool.q_WT[1], tool.q_WT[2], tool.q_WT[3]);
    m_values = m_gauge.at(vec(tool.p_WT_m), q_WT, core::toWrench(tool.tissue));
    showForces();
    if (m_forcePlot)
        addSamples(samples);
}

void InsertionPanel::showReadings(const haptics::DisplayState& state) {
    showStage(state.exercise.of<simulation::EndoscopeCues>());
    if (m_cues.numbers)
        showNumbers();
}

void InsertionPanel::showStage(const simulation::EndoscopeCues& cues) {
    m_stage->setText(stageText(cues, m_telling, m_locale));
    if (!m_progress)
        return;
    const double part = stageProgress(cues, m_telling);
    m_progress->setVisible(part >= 0.0);
    m_progress->setValue(qRound(100.0 * part));
}

void InsertionPanel::showForces() {
    if (m_resistance) {
        m_resistance->setValue(std::max(0.0, m_values.resistance_N));
        m_lateral->setValue(m_values.lateral_N);
    }
    for (int i = 0; i < 3 && m_force[0]; ++i) {
        m_force[static_cast<std::size_t>(i)]->setValue(m_values.force_A_N[i]);
        m_torque[static_cast<std::size_t>(i)]->setValue(m_values.torque_Nm[i] * 1e3);
    }
}

void InsertionPanel::showNumbers() {
    const std::array<double, 6> numbers{m_values.tip_A_m.x() * 1e3, m_values.tip_A_m.y() * 1e3,
                                        m_values.tip_A_m.z() * 1e3, m_values.depth_m * 1e3,
                                        m_values.offset_m * 1e3,    m_values.alignment_rad * kDegrees};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        // Adding 0 removes the minus sign of -0.0.
        m_numbers[i]->setText(m_locale.toString(std::round(numbers[i] * 10.0) / 10.0 + 0.0, 'f', 1));
    for (std::size_t i = 0; i < 3; ++i) {
        m_force[i]->speak();
        m_torque[i]->speak();
    }
}

void InsertionPanel::addSamples(std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples) {
        const core::Quat q_WT(double(sample.q_WT[0]), double(sample.q_WT[1]), double(sample.q_WT[2]),
                              double(sample.q_WT[3]));
        const InsertionValues values =
            m_gauge.at(vec(sample.p_WT_m), q_WT, {vec(sample.tissue_N), core::Vec3::Zero()});
        m_forcePlot->add(sample.t_s, static_cast<double>(sample.tissueNorm_N));
        m_lateralPlot->add(sample.t_s, values.lateral_N);
        m_offsetPlot->add(sample.t_s, values.offset_m * 1e3);
        m_alignmentPlot->add(sample.t_s, values.alignment_rad * kDegrees);
    }
    for (LivePlot* plot : {m_forcePlot, m_lateralPlot, m_offsetPlot, m_alignmentPlot})
        plot->update();
}

} // namespace chiron::desktop
