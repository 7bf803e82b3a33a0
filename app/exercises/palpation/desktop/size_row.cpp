// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/size_row.h"

#include "app/exercises/palpation/desktop/palpation_words.h"
#include "desktop/widgets/kit.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

// At 100 %: the largest finding is as high as the buttons and its title.
constexpr double kPixelsPerMm = 1.5;

/// Draws the finding as a disc and the finger's pad as a dashed ring with the same centre.
class ToScale final : public QWidget {
public:
    ToScale(const Theme& theme, double padRadius_mm) : m_theme(theme), m_pad_mm(padRadius_mm) {
        const int side = theme.px(kPixelsPerMm * SizeRow::kMost_mm) + theme.px(4);
        setFixedSize(side, side);
    }
    double radius_mm = 0.0;

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QPointF middle = QRectF(rect()).center();
        const double perMm = m_theme.px(100.0 * kPixelsPerMm) / 100.0;
        const bool on = isEnabled();
        if (radius_mm > 0.0) {
            painter.setPen(QPen(m_theme.color(on ? Colour::accent : Colour::muted), m_theme.px(2)));
            painter.setBrush(m_theme.color(Colour::accentSoft));
            painter.drawEllipse(middle, radius_mm * perMm, radius_mm * perMm);
        }
        painter.setPen(QPen(m_theme.color(Colour::muted), m_theme.px(1), Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(middle, m_pad_mm * perMm, m_pad_mm * perMm);
    }

private:
    const Theme& m_theme;
    double m_pad_mm;
};

} // namespace

SizeRow::SizeRow(const Theme& theme, const QLocale& locale, double padRadius_m, QWidget* parent)
    : QWidget(parent), m_locale(locale), m_title(kit::label(theme, {}, TextStyle::label)),
      m_circle(new ToScale(theme, 1e3 * padRadius_m)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme.px(8));
    auto* column = new QVBoxLayout;
    column->setSpacing(theme.px(3));
    column->addWidget(m_title);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(theme.px(4));
    for (const int by_mm : {-1, 1}) {
        auto* button = kit::button(theme, by_mm < 0 ? QStringLiteral("−") : QStringLiteral("+"));
        button->setObjectName(by_mm < 0 ? QStringLiteral("smaller") : QStringLiteral("larger"));
        button->setAccessibleName(by_mm < 0 ? tr("Size: one millimetre smaller")
                                            : tr("Size: one millimetre larger"));
        button->setToolTip(button->accessibleName());
        button->setAutoRepeat(true);
        button->setMinimumWidth(theme.px(40));
        connect(button, &QPushButton::clicked, this, [this, by_mm] { step(by_mm); });
        buttons->addWidget(button, 1);
    }
    column->addLayout(buttons);
    column->addWidget(
        kit::label(theme, tr("Dashed: the pad of the finger. Keys + and −"), TextStyle::small, "muted"));
    column->addStretch();
    row->addLayout(column, 1);
    row->addWidget(m_circle, 0, Qt::AlignVCenter);
    setRadius(0.0);
}

void SizeRow::setRadius(double radius_m) {
    if (radius_m == m_radius_m)
        return;
    m_radius_m = radius_m;
    m_across_mm = qRound(2e3 * radius_m);
    m_title->setText(words());
    setAccessibleName(words());
    static_cast<ToScale*>(m_circle)->radius_mm = 1e3 * radius_m;
    m_circle->update();
}

void SizeRow::step(int by_mm) {
    const int next_mm = m_across_mm == 0 ? kFirst_mm : std::clamp(m_across_mm + by_mm, kLeast_mm, kMost_mm);
    // Two quick presses make two steps, although the session has not confirmed the first one yet.
    setRadius(0.5e-3 * next_mm);
    emit sized(static_cast<unsigned>(5 * next_mm));
}

QString SizeRow::words() const {
    return tr("Size: %1").arg(sizeText(std::max(m_radius_m, 0.0), m_locale));
}

void SizeRow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::EnabledChange)
        m_circle->update();
    QWidget::changeEvent(event);
}

} // namespace chiron::desktop
