// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/session_lines.h"

#include "desktop/sessions/session_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/tile_button.h"

#include <QHBoxLayout>

namespace chiron::desktop {

SessionLines::SessionLines(AppContext& context, const std::vector<SessionRow>& rows, bool names,
                           QWidget* parent)
    : QWidget(parent), m_context(context) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(context.theme().px(6));
    for (const SessionRow& row : rows)
        column->addWidget(line(row, names));
}

QWidget* SessionLines::line(const SessionRow& row, bool names) {
    const Theme& theme = m_context.theme();
    const database::SessionSummary& session = row.summary;
    const QString attempt = SessionWords::what(session, row.exercise, m_context.locale());
    const QString what = names ? tr("%1: %2").arg(row.person, attempt) : attempt;
    const QString when = SessionWords::ago(SessionWords::timeOf(session.startedUtc),
                                           QDateTime::currentDateTimeUtc(), m_context.locale());
    // An unfinished session gives the reason; any other says whether it was passed.
    const QString came = SessionWords::cameTo(session);
    const WordSign sign = SessionWords::cameToSign(session);

    auto* button = new TileButton(theme);
    button->setObjectName(QStringLiteral("home.session.%1").arg(session.id));
    button->setAccessibleName(tr("%1. %2. %3. Opens the debrief.").arg(what, came, when));
    QHBoxLayout* line = button->row();
    auto* picture = new QLabel;
    picture->setPixmap(theme.icon(QLatin1String(sign.icon), sign.ink).pixmap(theme.px(20), theme.px(20)));
    line->addWidget(picture);
    line->addWidget(kit::label(theme, what, TextStyle::body), 4);
    line->addWidget(kit::label(theme, came, TextStyle::strong), 2);
    line->addWidget(kit::label(theme, when, TextStyle::small, "muted"), 2);
    button->seal();
    connect(button, &QPushButton::clicked, this, [this, id = session.id] {
        m_context.navigator().go(QStringLiteral("debrief"),
                                 {{QStringLiteral("session"), static_cast<qint64>(id)}});
    });
    return button;
}

} // namespace chiron::desktop
