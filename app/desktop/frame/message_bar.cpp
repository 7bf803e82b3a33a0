// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/message_bar.h"

#include "desktop/frame/help_dialogs.h"
#include "desktop/widgets/kit.h"

#include <QCursor>
#include <QEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QStyle>
#include <QTimer>
#include <algorithm>
#include <limits>
#include <vector>

namespace chiron::desktop {

namespace {

constexpr int kShown_ms = 8000; // long enough to read two lines and reach for Undo
constexpr int kWatch_ms = 200;
constexpr double kWidths_px[] = {760, 560, 400, 300}; // while it floats
constexpr double kMargin_px = 12;
constexpr double kAbove_px = 2; // above the text, within its room
constexpr double kBelow_px = 6;
constexpr double kPadding_px = 3;
constexpr int kFrame_px = 2; // lines of the style sheet
constexpr double kStep_px = 8;

struct Look {
    const char* kind;
    const char* icon;
    Colour ink;
};

Look lookOf(MessageKind kind) {
    switch (kind) {
    case MessageKind::done:
        return {"good", "dialog-ok-apply", Colour::good};
    case MessageKind::information:
        return {"info", "dialog-information", Colour::accent};
    case MessageKind::warning:
        return {"warning", "dialog-warning", Colour::warning};
    case MessageKind::error:
        return {"bad", "dialog-error", Colour::bad};
    }
    return {};
}

/// A widget that can be pressed, typed into or moved, and the cost of covering it.
struct UsablePart {
    QRect place;
    int weight = 0;
};

constexpr int kScene = 1; // large, and still visible around a message
constexpr int kControl = 100;

int weightOf(const QWidget& part) {
    if (qobject_cast<const QScrollArea*>(&part))
        return 0; // its contents count instead
    for (const char* kind :
         {"QAbstractButton", "QLineEdit", "QComboBox", "QAbstractSpinBox", "QAbstractSlider",
          "QAbstractItemView", "QTextEdit", "QPlainTextEdit", "QTabBar"})
        if (part.inherits(kind))
            return kControl;
    return part.focusPolicy() != Qt::NoFocus || part.testAttribute(Qt::WA_NativeWindow) ? kScene : 0;
}

/// The usable parts within `over`, except those in `besides`.
std::vector<UsablePart> usableParts(const QWidget& over, const QWidget& besides) {
    std::vector<UsablePart> parts;
    for (const QWidget* each : over.findChildren<QWidget*>()) {
        const int weight = weightOf(*each);
        if (weight == 0 || !each->isVisible() || !each->isEnabled() || each == &besides ||
            besides.isAncestorOf(each))
            continue;
        const QRect seen = each->visibleRegion().boundingRect();
        if (!seen.isEmpty())
            parts.push_back({QRect(each->mapTo(&over, seen.topLeft()), seen.size()), weight});
    }
    return parts;
}

int costOf(const QRect& place, const std::vector<UsablePart>& parts) {
    int cost = 0;
    for (const UsablePart& part : parts)
        cost += part.place.intersects(place) ? part.weight : 0;
    return cost;
}

} // namespace

MessageBar::MessageBar(const Theme& theme, QWidget* parent) : QFrame(parent), m_theme(theme) {
    setObjectName(QStringLiteral("messages"));
    build();
    m_timer = new QTimer(this);
    m_timer->setSingleShot(true);
    connect(m_timer, &QTimer::timeout, this, &QWidget::hide);
    m_watch = new QTimer(this);
    m_watch->setInterval(kWatch_ms);
    connect(m_watch, &QTimer::timeout, this, [this] {
        if (!isVisible() || m_room || !parentWidget())
            return m_watch->stop();
        if (costOf(geometry(), usableParts(*parentWidget(), *this)) >= kControl)
            settle();
    });
    connect(m_close, &QPushButton::clicked, this, &QWidget::hide);
    connect(m_more, &QPushButton::clicked, this, &MessageBar::showWhole);
    connect(m_action, &QPushButton::clicked, this, [this] {
        hide();
        if (m_act)
            m_act();
    });
    hide();
    if (parent)
        parent->installEventFilter(this);
}

void MessageBar::build() {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(m_theme.px(14), m_theme.px(kPadding_px), m_theme.px(8), m_theme.px(kPadding_px));
    row->setSpacing(m_theme.px(10));
    m_sign = new QLabel;
    m_text = kit::label(m_theme, {});
    m_text->setObjectName(QStringLiteral("messages.text"));
    m_more = kit::button(m_theme, tr("Show all"), "quiet");
    m_more->setObjectName(QStringLiteral("messages.more"));
    m_more->hide();
    m_action = kit::button(m_theme, {});
    m_action->setObjectName(QStringLiteral("messages.action"));
    m_close = kit::iconButton(m_theme, QStringLiteral("window-close"), tr("Close this message"));
    row->addWidget(m_sign);
    row->addWidget(m_text, 1);
    row->addWidget(m_more);
    row->addWidget(m_action);
    row->addWidget(m_close);
}

int MessageBar::roomHeight(const Theme& theme) {
    const int content =
        std::max(theme.controlHeight(), 2 * QFontMetrics(theme.font(TextStyle::body)).lineSpacing());
    return content + 2 * theme.px(kPadding_px) + kFrame_px + theme.px(kAbove_px) + theme.px(kBelow_px);
}

void MessageBar::setRoom(QWidget* room) {
    if (m_room == room)
        return;
    if (m_room)
        m_room->removeEventFilter(this);
    m_room = room;
    if (m_room)
        m_room->installEventFilter(this);
    if (isVisible())
        rise();
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
    const bool moved =
        event->type() == QEvent::Resize || event->type() == QEvent::Move || event->type() == QEvent::Show;
    if (moved && isVisible() &&
        (watched == m_room || (watched == parent() && event->type() == QEvent::Resize)))
        settle();
    return QFrame::eventFilter(watched, event);
}

/// The width of everything in the row except the text, including spacing.
int MessageBar::widthOfOthers() const {
    const QMargins margins = layout()->contentsMargins();
    int width = margins.left() + margins.right() + kFrame_px;
    for (const QWidget* part : {static_cast<const QWidget*>(m_sign), static_cast<const QWidget*>(m_more),
                                static_cast<const QWidget*>(m_action), static_cast<const QWidget*>(m_close)})
        if (!part->isHidden())
            width += std::max(part->sizeHint().width(), part->minimumWidth()) + layout()->spacing();
    return width;
}

/// Shows as many words as fit; "Show all" reveals the rest.
void MessageBar::fitText(int width, int height) {
    const QFontMetrics metrics(m_text->font());
    const auto fits = [&](const QString& words) {
        const QRect wide(0, 0, std::max(1, width - widthOfOthers()), 1 << 20);
        return metrics.boundingRect(wide, Qt::TextWordWrap, words).height() <=
               height - 2 * m_theme.px(kPadding_px) - kFrame_px;
    };
    m_more->hide();
    const QString words = m_whole.simplified(); // a line break would waste space
    for (const QString& all : {m_whole, words})
        if (fits(all)) {
            m_text->setText(all);
            m_text->setToolTip({});
            return;
        }
    m_more->show();
    qsizetype fit = 0;
    for (qsizetype low = 0, high = words.size(); low <= high;) {
        const qsizetype middle = (low + high) / 2;
        const bool good = fits(words.left(middle) + QStringLiteral(" …"));
        fit = good ? middle : fit;
        (good ? low : high) = good ? middle + 1 : middle - 1;
    }
    const qsizetype space = words.lastIndexOf(QLatin1Char(' '), fit);
    m_text->setText(words.left(fit < words.size() && space > fit / 2 ? space : fit).trimmed() +
                    QStringLiteral(" …"));
    m_text->setToolTip(m_whole);
}

/// Positions the bar in its room, or floating.
void MessageBar::settle() {
    const QWidget* over = parentWidget();
    if (!over)
        return;
    if (!m_room) {
        m_more->hide();
        m_text->setText(m_whole);
        setGeometry(freePlace());
        return;
    }
    const int margin = m_theme.px(kMargin_px);
    const QRect place(m_room->mapTo(over, QPoint(margin, m_theme.px(kAbove_px))),
                      QSize(m_room->width() - 2 * margin,
                            m_room->height() - m_theme.px(kAbove_px) - m_theme.px(kBelow_px)));
    fitText(place.width(), place.height());
    setGeometry(place);
}

/// The position without a room: where it covers no control and does not lie between the pointer and its
/// target, preferably low. If there is no such position, it covers the scene rather than a control.
QRect MessageBar::freePlace() const {
    const QWidget& over = *parentWidget();
    const std::vector<UsablePart> parts = usableParts(over, *this);
    const QPoint pointer = over.mapFromGlobal(QCursor::pos());
    const int margin = m_theme.px(kMargin_px);
    QRect best;
    int least = std::numeric_limits<int>::max();
    for (const double wide : kWidths_px) {
        const int width = std::min(m_theme.px(wide), over.width() - 2 * margin);
        const int height =
            layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
        for (int y = over.height() - height - margin; y >= margin; y -= m_theme.px(kStep_px)) {
            for (const int x : {(over.width() - width) / 2, margin, over.width() - width - margin}) {
                const QRect place(x, y, width, height);
                const int cost = costOf(place, parts) +
                                 (place.adjusted(0, -margin, 0, margin).contains(pointer) ? kControl : 0);
                if (cost < least) {
                    least = cost;
                    best = place;
                }
                if (least == 0)
                    return best;
            }
        }
    }
    return best;
}

/// Raises the bar above everything else.
void MessageBar::rise() {
    const QWidget* over = parentWidget();
    if (!over)
        return;
    settle();
    const QList<QWidget*> others = over->findChildren<QWidget*>();
    if (std::any_of(others.begin(), others.end(), [this](const QWidget* other) {
            return other != this && other->testAttribute(Qt::WA_NativeWindow);
        })) {
        setAttribute(Qt::WA_DontCreateNativeAncestors);
        setAttribute(Qt::WA_NativeWindow); // otherwise the window of a 3D scene would cover it
    }
    raise();
    if (!m_room)
        m_watch->start();
}

void MessageBar::showWhole() {
    if (!m_more->isHidden())
        showWords(m_theme, tr("The whole message"), m_whole, window());
}

void MessageBar::tell(const Message& message) {
    const Look look = lookOf(message.kind);
    setProperty("kind", QLatin1String(look.kind));
    style()->polish(this);
    m_sign->setPixmap(
        m_theme.icon(QLatin1String(look.icon), look.ink).pixmap(m_theme.px(22), m_theme.px(22)));
    m_whole = message.text;
    m_more->hide();
    m_text->setText(m_whole);
    m_text->setAccessibleName(m_whole);
    m_action->setText(message.actionText);
    m_action->setVisible(!message.actionText.isEmpty());
    m_act = message.action;
    rise();
    show();
    settle(); // after styling, so that its sizes are known
    m_timer->stop();
    if (message.kind != MessageKind::error)
        m_timer->start(kShown_ms);
}

} // namespace chiron::desktop
