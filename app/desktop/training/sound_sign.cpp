// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/sound_sign.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kFirstForce_N = 0.02; ///< the tone starts above this force; less counts as no contact
/// A click lasts milliseconds; its light lasts long enough to be seen.
constexpr std::int64_t kClickSeen_ns = 400'000'000;
} // namespace

/// Draws dot, steps and triangle in a row.
class SoundGlyph final : public QWidget {
public:
    SoundGlyph(const Theme& theme, QWidget* parent) : QWidget(parent), m_theme(theme) {
        setFixedSize(theme.px(88), theme.px(22));
    }

    void set(bool click, int steps, bool warning) {
        if (click == m_click && steps == m_steps && warning == m_warning)
            return;
        m_click = click;
        m_steps = steps;
        m_warning = warning;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const double h = height();
        const double line = m_theme.px(1);
        lit(painter, m_click, Colour::accent);
        painter.drawEllipse(QPointF(0.32 * h + line, 0.5 * h), 0.3 * h, 0.3 * h);
        const double wide = m_theme.px(5), gap = m_theme.px(2), from = m_theme.px(20);
        for (int i = 0; i < SoundSign::kSteps; ++i) {
            const double high = (h - 2.0 * line) * (i + 2) / (SoundSign::kSteps + 1);
            lit(painter, i < m_steps, Colour::seriesA);
            painter.drawRect(QRectF(from + i * (wide + gap), h - line - high, wide, high));
        }
        lit(painter, m_warning, Colour::bad);
        const double right = width() - line;
        painter.drawPolygon(QPolygonF{
            {QPointF(right - 0.9 * h, h - line), QPointF(right, h - line), QPointF(right - 0.45 * h, line)}});
    }

private:
    void lit(QPainter& painter, bool on, Colour colour) const {
        painter.setPen(QPen(m_theme.color(on ? colour : Colour::borderStrong), m_theme.px(1)));
        painter.setBrush(on ? QBrush(m_theme.color(colour)) : QBrush(Qt::NoBrush));
    }

    const Theme& m_theme;
    bool m_click = false;
    int m_steps = 0;
    bool m_warning = false;
};

SoundSign::SoundSign(const Theme& theme, QWidget* parent)
    : QWidget(parent), m_glyph(new SoundGlyph(theme, this)),
      m_words(kit::label(theme, {}, TextStyle::strong)) {
    setObjectName(QStringLiteral("training.sound"));
    setAccessibleName(tr("Current sound"));
    setToolTip(tr("Shows what can be heard: start of contact, pitch of the tone, warning"));
    m_words->setObjectName(QStringLiteral("training.sound.words"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme.px(8));
    row->addWidget(m_glyph, 0, Qt::AlignVCenter);
    row->addWidget(m_words, 1);
    show({}, false, 0);
}

int SoundSign::stepsOf(double force_N, double limit_N) {
    if (!(force_N > kFirstForce_N) || !(limit_N > 0.0))
        return 0;
    return std::clamp(static_cast<int>(std::ceil(kSteps * std::min(force_N / limit_N, 1.0))), 1, kSteps);
}

void SoundSign::show(const SoundCues& cues, bool sounding, std::int64_t now_ns) {
    if (cues.contacts != m_contacts && sounding)
        m_clicked_ns = now_ns;
    m_contacts = cues.contacts;
    if (!sounding || now_ns - m_clicked_ns > kClickSeen_ns)
        m_clicked_ns = -1;
    const int steps = sounding ? stepsOf(cues.force_N, cues.limit_N) : 0;
    const bool warning = sounding && cues.force_N > cues.limit_N;
    m_glyph->set(m_clicked_ns >= 0, steps, warning);
    const QString words = warning                   ? tr("Warning: pressed too hard")
                          : m_clicked_ns >= 0       ? tr("Contact")
                          : steps == 0              ? tr("No tone")
                          : 3 * steps <= kSteps     ? tr("Low tone")
                          : 3 * steps <= 2 * kSteps ? tr("Medium tone")
                                                    : tr("High tone");
    if (words == m_words->text())
        return;
    m_words->setText(words);
    setAccessibleDescription(words);
}

QString SoundSign::words() const {
    return m_words->text();
}

} // namespace chiron::desktop
