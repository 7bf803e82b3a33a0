// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/form_dialog.h"

#include "desktop/accounts/notice_area.h"
#include "desktop/frame/app_context.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"

#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr double kWidth = 560;
constexpr double kHeight = 620;
} // namespace

FormDialog::FormDialog(AppContext& context, const QString& objectName, const QString& title, QWidget* parent)
    : QDialog(parent), m_context(context) {
    const Theme& theme = context.theme();
    setObjectName(objectName);
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    setModal(true);
    const QSize room = parent ? parent->window()->size() : QSize(theme.px(kWidth), theme.px(kHeight));
    resize(std::min(theme.px(kWidth), room.width()), std::min(theme.px(kHeight), room.height()));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, theme.px(16));
    m_page = new ScrollPage(theme, 0);
    column->addWidget(m_page, 1);
    column->addWidget(kit::rule());
    column->addSpacing(theme.px(10));
    m_body = new QWidget;
    m_form = new QVBoxLayout(m_body);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setSpacing(theme.px(12));
    m_form->addWidget(kit::label(theme, title, TextStyle::heading));
    m_page->column()->addWidget(m_body);
    // No room is needed, because the buttons stand below the page and nothing moves.
    m_notice = new NoticeArea(theme, NoticeArea::Room::none);
    m_notice->setObjectName(objectName + QStringLiteral(".notice"));
    m_page->column()->addWidget(m_notice);
    m_page->column()->addStretch();
    auto* row = new QHBoxLayout;
    m_buttons = row;
    row->setContentsMargins(theme.px(24), 0, theme.px(24), 0);
    m_cancel = kit::button(theme, tr("Cancel"));
    m_cancel->setObjectName(objectName + QStringLiteral(".cancel"));
    m_accept = kit::button(theme, {}, "primary");
    m_accept->setObjectName(objectName + QStringLiteral(".accept"));
    row->addWidget(m_cancel);
    row->addStretch(1);
    row->addWidget(m_accept);
    column->addLayout(row);
    connect(m_cancel, &QPushButton::clicked, this, &FormDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, [this] {
        if (m_acceptable && !m_working)
            submit();
    });
    renew();
}

const Theme& FormDialog::theme() const {
    return m_context.theme();
}

void FormDialog::reject() {
    if (!m_working)
        QDialog::reject();
}

void FormDialog::setAccept(const QString& text, const char* kind) {
    m_accept->setText(text);
    m_accept->setProperty("kind", QLatin1String(kind)); // before it is shown
    m_accept->setDefault(true);
}

void FormDialog::setCancel(const QString& text) {
    m_cancel->setText(text);
}

void FormDialog::cancelAtEnter() {
    m_cancel->setDefault(true);
    m_cancel->setFocus();
}

void FormDialog::setAcceptable(bool acceptable, const QString& whyNot) {
    m_acceptable = acceptable;
    if (!m_whyNot && !whyNot.isEmpty()) {
        m_whyNot = kit::label(theme(), {}, TextStyle::small, "muted");
        m_whyNot->setObjectName(objectName() + QStringLiteral(".why_not"));
        m_whyNot->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        constexpr int kMostOfTheRow = 100; // what is left beside the buttons; the stretch keeps a little
        m_buttons->insertWidget(m_buttons->indexOf(m_accept), m_whyNot, kMostOfTheRow);
    }
    if (m_whyNot) {
        m_whyNot->setText(acceptable ? QString() : whyNot);
        m_whyNot->setVisible(!m_whyNot->text().isEmpty());
    }
    m_accept->setAccessibleDescription(acceptable ? QString() : whyNot);
    renew();
}

void FormDialog::reveal(QWidget& part) {
    m_page->ensureWidgetVisible(&part);
}

void FormDialog::setWorking(bool working, bool formShowsIt) {
    m_working = working;
    m_body->setEnabled(!working || formShowsIt);
    say("info", working && !formShowsIt ? tr("Working …") : QString());
    renew();
}

void FormDialog::say(const char* kind, const QString& text) {
    m_notice->say(kind, text);
    if (!text.isEmpty())
        // Deferred until the notice has its size.
        QMetaObject::invokeMethod(
            this, [this] { m_page->ensureWidgetVisible(m_notice); }, Qt::QueuedConnection);
}

void FormDialog::showResult(QWidget* result) {
    m_working = false;
    m_notice->clear();
    m_body->hide();
    m_page->column()->insertWidget(0, result);
    m_accept->hide();
    if (m_whyNot)
        m_whyNot->hide();
    m_cancel->setText(tr("Close"));
    m_cancel->setDefault(true);
    renew();
    m_cancel->setFocus();
}

void FormDialog::showSecret(QWidget* result, QPushButton* first) {
    showResult(result);
    first->setDefault(true);
    first->setFocus();
}

void FormDialog::hideCancel() {
    m_cancel->hide();
}

void FormDialog::leaveOnly(bool only) {
    m_accept->setVisible(!only);
    m_cancel->setText(only ? tr("Close") : tr("Cancel"));
    (only ? m_cancel : m_accept)->setDefault(true);
}

void FormDialog::renew() {
    m_accept->setEnabled(m_acceptable && !m_working);
    m_cancel->setEnabled(!m_working);
}

} // namespace chiron::desktop
