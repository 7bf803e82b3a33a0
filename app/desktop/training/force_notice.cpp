// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/force_notice.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QStyle>

namespace chiron::desktop {

namespace {

struct Sign {
    const char* icon;
    Colour ink;
};

Sign signOf(const QLatin1String& kind) {
    if (kind == QLatin1String("good"))
        return {"dialog-ok-apply", Colour::good};
    if (kind == QLatin1String("warning"))
        return {"dialog-warning", Colour::warning};
    if (kind == QLatin1String("bad"))
        return {"dialog-error", Colour::bad};
    return {"dialog-information", Colour::accent};
}

} // namespace

ForceNotice::ForceNotice(const Theme& theme, QWidget* parent) : QFrame(parent), m_theme(theme) {
    setObjectName(QStringLiteral("training.force"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(theme.px(12), theme.px(8), theme.px(12), theme.px(8));
    row->setSpacing(theme.px(8));
    m_sign = new QLabel;
    row->addWidget(m_sign, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout;
    column->setSpacing(theme.px(2));
    m_title = kit::label(theme, {}, TextStyle::strong);
    m_title->setObjectName(QStringLiteral("training.force.title"));
    m_text = kit::label(theme, {}, TextStyle::small);
    m_text->setObjectName(QStringLiteral("training.force.text"));
    column->addWidget(m_title);
    column->addWidget(m_text);
    row->addLayout(column, 1);
}

bool ForceNotice::show(const ForceWords& words) {
    if (words == m_words)
        return false;
    const QLatin1String kind(words.kind);
    if (property("kind").toString() != kind) {
        setProperty("kind", QString(kind));
        style()->unpolish(this);
        style()->polish(this);
        const Sign sign = signOf(kind);
        m_sign->setPixmap(
            m_theme.icon(QLatin1String(sign.icon), sign.ink).pixmap(m_theme.px(22), m_theme.px(22)));
    }
    m_words = words;
    m_title->setText(words.title);
    m_text->setText(words.text);
    setAccessibleName(words.title);
    setAccessibleDescription(words.text);
    updateGeometry(); // now: whoever asks measures the height at once
    return true;
}

} // namespace chiron::desktop
