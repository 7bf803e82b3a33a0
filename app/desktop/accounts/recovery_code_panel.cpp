// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/recovery_code_panel.h"

#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>

namespace chiron::desktop {

RecoveryCodePanel::RecoveryCodePanel(const Theme& theme, const QString& loginName, const QString& code,
                                     Backups backups, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_name(loginName), m_code(code) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(14));
    column->addWidget(kit::label(theme, tr("Your recovery code"), TextStyle::heading));
    column->addWidget(kit::label(
        theme, tr("With this code you can set a new password if you forget yours. It is shown only now: the "
                  "program keeps no readable copy. Without it, only another administrator can help you. "
                  "Keep it as safe as your keys.")));
    const kit::Box box = kit::box(theme, "info");
    auto* words = kit::label(theme, code, TextStyle::title);
    QFont font = theme.font(TextStyle::mono);
    font.setPixelSize(theme.font(TextStyle::title).pixelSize());
    words->setFont(font);
    words->setObjectName(QStringLiteral("recovery.code"));
    words->setAlignment(Qt::AlignCenter);
    words->setAccessibleName(tr("Recovery code: %1").arg(code));
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    box.layout->addWidget(words);
    column->addWidget(box.frame);
    if (backups != Backups::none) {
        auto* told = kit::label(theme,
                                backups == Backups::haveEarlierCode
                                    ? tr("Backups made before now still have the earlier code.")
                                    : tr("Backups made before now have no recovery code of yours."),
                                TextStyle::small, "muted");
        told->setObjectName(QStringLiteral("recovery.backups"));
        column->addWidget(told);
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(theme.px(8));
    auto* copy = kit::button(theme, tr("Copy"), "", QStringLiteral("edit-copy"));
    copy->setObjectName(QStringLiteral("recovery.copy"));
    connect(copy, &QPushButton::clicked, this, [this, copy] {
        QGuiApplication::clipboard()->setText(m_code);
        copy->setText(tr("Copied"));
    });
    auto* paper = kit::button(theme, tr("Print"), "", QStringLiteral("document-print"));
    paper->setObjectName(QStringLiteral("recovery.print"));
    connect(paper, &QPushButton::clicked, this, &RecoveryCodePanel::print);
    row->addWidget(copy);
    row->addWidget(paper);
    row->addStretch();
    column->addLayout(row);
    m_foot = new QWidget;
    auto* foot = new QVBoxLayout(m_foot);
    foot->setContentsMargins(0, 0, 0, 0);
    foot->setSpacing(theme.px(14));
    column->addWidget(m_foot);
    m_written = new QCheckBox(tr("I have written the code down"));
    m_written->setObjectName(QStringLiteral("recovery.written"));
    foot->addWidget(m_written);
    m_next = kit::button(theme, tr("Continue"), "primary");
    m_next->setObjectName(QStringLiteral("recovery.continue"));
    m_next->setEnabled(false);
    foot->addWidget(m_next);
    connect(m_written, &QCheckBox::toggled, m_next, &QPushButton::setEnabled);
    connect(m_next, &QPushButton::clicked, this, &RecoveryCodePanel::finished);
}

bool RecoveryCodePanel::isConfirmed() const {
    return m_written->isChecked();
}

QString RecoveryCodePanel::printedText() const {
    return tr("Chiron: recovery code of %1\n\n%2\n\nKeep it as safe as your keys.").arg(m_name, m_code);
}

void RecoveryCodePanel::print() {
    auto* printer = new QPrinter(QPrinter::ScreenResolution);
    auto* dialog = new QPrintDialog(printer, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QObject::destroyed, [printer] { delete printer; });
    connect(dialog, &QDialog::accepted, this, [this, printer] {
        QPainter painter(printer);
        painter.setFont(m_theme.font(TextStyle::title));
        painter.drawText(painter.viewport(), Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap, printedText());
    });
    dialog->open();
}

} // namespace chiron::desktop
