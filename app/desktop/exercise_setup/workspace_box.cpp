// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/workspace_box.h"

#include "core/units.h"
#include "desktop/widgets/kit.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QRadioButton>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using session::WorkspaceChoice;

WorkspaceBox::WorkspaceBox(const Theme& theme, const QLocale& locale, QWidget* parent)
    : QFrame(parent), m_theme(theme), m_locale(locale) {
    setProperty("kind", QStringLiteral("card"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(16), theme.px(10), theme.px(16), theme.px(10));
    column->setSpacing(theme.px(8));
    auto* fold = kit::button(theme, tr("Hand and workspace"), "quiet", QStringLiteral("configure"));
    fold->setObjectName(QStringLiteral("setup.workspace"));
    fold->setCheckable(true);
    column->addWidget(fold, 0, Qt::AlignLeft);
    auto* inner = new QWidget;
    auto* rows = new QVBoxLayout(inner);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(theme.px(8));
    m_handPart = new QWidget;
    auto* handRows = new QVBoxLayout(m_handPart);
    handRows->setContentsMargins(0, 0, 0, 0);
    handRows->setSpacing(theme.px(8));
    handRows->addWidget(handRow());
    auto* grid = new QGridLayout;
    grid->setColumnStretch(0, 1);
    constexpr double kShift_mm = WorkspaceChoice::kLargestShift_m * 1e3;
    m_scale = spin(QStringLiteral("setup.scale"), tr("Tool movement per hand movement"), QString(),
                   WorkspaceChoice::kSmallestScale, WorkspaceChoice::kLargestScale, 0.05, *grid);
    m_origin[0] = spin(QStringLiteral("setup.origin_x"), tr("Shift to the right"), tr(" mm"), -kShift_mm,
                       kShift_mm, 1.0, *grid);
    m_origin[1] = spin(QStringLiteral("setup.origin_y"), tr("Shift away from you"), tr(" mm"), -kShift_mm,
                       kShift_mm, 1.0, *grid);
    m_origin[2] =
        spin(QStringLiteral("setup.origin_z"), tr("Shift up"), tr(" mm"), -kShift_mm, kShift_mm, 1.0, *grid);
    handRows->addLayout(grid);
    rows->addWidget(m_handPart);
    m_basePart = new QWidget;
    auto* base = new QGridLayout(m_basePart);
    base->setContentsMargins(0, 0, 0, 0);
    base->setColumnStretch(0, 1);
    const double kTurn_deg = std::round(core::degFromRad(WorkspaceChoice::kLargestTurn_rad));
    m_turn[0] = spin(QStringLiteral("setup.turn"), tr("Rotation of the device base to the left"), tr("°"),
                     -kTurn_deg, kTurn_deg, 1.0, *base);
    m_turn[1] = spin(QStringLiteral("setup.tilt"), tr("Tilt of the base away from you"), tr("°"), -kTurn_deg,
                     kTurn_deg, 1.0, *base);
    m_turn[2] = spin(QStringLiteral("setup.roll"), tr("Tilt of the base to the right"), tr("°"), -kTurn_deg,
                     kTurn_deg, 1.0, *base);
    rows->addWidget(m_basePart);
    setHasBase(false);
    column->addWidget(inner);
    inner->hide();
    connect(fold, &QPushButton::toggled, inner, &QWidget::setVisible);
}

QWidget* WorkspaceBox::handRow() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(m_theme.px(12));
    m_right = new QRadioButton(tr("Right hand"));
    m_right->setObjectName(QStringLiteral("setup.right"));
    m_left = new QRadioButton(tr("Left hand"));
    m_left->setObjectName(QStringLiteral("setup.left"));
    m_right->setChecked(true);
    layout->addWidget(m_right);
    layout->addWidget(m_left);
    layout->addStretch();
    connect(m_left, &QRadioButton::toggled, this, &WorkspaceBox::changed);
    return row;
}

QDoubleSpinBox* WorkspaceBox::spin(const QString& name, const QString& title, const QString& suffix,
                                   double minimum, double maximum, double step, QGridLayout& grid) {
    auto* label = kit::label(m_theme, title, TextStyle::label);
    auto* field = new QDoubleSpinBox;
    field->setObjectName(name);
    field->setAccessibleName(title);
    field->setLocale(m_locale);
    field->setRange(minimum, maximum);
    field->setSingleStep(step);
    field->setDecimals(suffix.isEmpty() ? 2 : 0);
    field->setSuffix(suffix);
    label->setBuddy(field);
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0);
    grid.addWidget(field, row, 1);
    connect(field, &QDoubleSpinBox::valueChanged, this, &WorkspaceBox::changed);
    return field;
}

void WorkspaceBox::setChoice(const WorkspaceChoice& choice) {
    m_scale->setValue(choice.scale);
    for (std::size_t i = 0; i < m_origin.size(); ++i)
        m_origin[i]->setValue(choice.origin_m[i] * 1e3);
    for (std::size_t i = 0; i < m_turn.size(); ++i)
        m_turn[i]->setValue(core::degFromRad(choice.turn_rad[i]));
    (choice.leftHanded ? m_left : m_right)->setChecked(true);
}

void WorkspaceBox::setHasBase(bool has) {
    m_handPart->setVisible(!has);
    m_basePart->setVisible(has);
}

WorkspaceChoice WorkspaceBox::choice() const {
    WorkspaceChoice choice;
    choice.scale = m_scale->value();
    for (std::size_t i = 0; i < m_origin.size(); ++i)
        choice.origin_m[i] = m_origin[i]->value() * 1e-3;
    for (std::size_t i = 0; i < m_turn.size(); ++i)
        choice.turn_rad[i] = core::radFromDeg(m_turn[i]->value());
    choice.leftHanded = m_left->isChecked();
    return choice;
}

} // namespace chiron::desktop
