// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/about_dialog.h"

#include "core/fp_environment.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/logo.h"

#include <QCoreApplication>
#include <QDialog>

namespace chiron::desktop {

namespace {

/// The translation context of the texts.
struct AboutDialog {
    Q_DECLARE_TR_FUNCTIONS(AboutDialog)
};

QLabel* centred(QLabel* label) {
    label->setAlignment(Qt::AlignCenter);
    return label;
}

} // namespace

QDialog* showAbout(const Theme& theme, QWidget* parent) {
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(QStringLiteral("about"));
    dialog->setWindowTitle(AboutDialog::tr("About Chiron"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setMinimumWidth(theme.px(460));
    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(theme.px(28), theme.px(24), theme.px(28), theme.px(20));
    column->setSpacing(theme.px(10));
    column->addWidget(logo(theme, 96));
    column->addWidget(centred(kit::label(theme, QStringLiteral("Chiron"), TextStyle::display)));
    column->addWidget(
        centred(kit::label(theme, AboutDialog::tr("Version %1").arg(QCoreApplication::applicationVersion()),
                           TextStyle::strong)));
    column->addWidget(centred(kit::label(
        theme,
        AboutDialog::tr(
            "Training for the sense of touch in minimally invasive surgery. Named after the centaur who "
            "taught Asclepius medicine; his name comes from cheir, hand."))));
    column->addWidget(centred(kit::label(
        theme,
        AboutDialog::tr(
            "Free software under the GNU General Public License, version 3 or later. Not a medical "
            "device."),
        TextStyle::body, "muted")));
    auto* build =
        centred(kit::label(theme, AboutDialog::tr("Build: %1").arg(QString::fromStdString(core::buildId())),
                           TextStyle::small, "muted"));
    build->setObjectName(QStringLiteral("about.build"));
    // The text can be copied into a report.
    build->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(build);
    auto* close = kit::button(theme, AboutDialog::tr("Close"), "primary");
    close->setObjectName(QStringLiteral("about.close"));
    QObject::connect(close, &QPushButton::clicked, dialog, &QDialog::accept);
    column->addWidget(close, 0, Qt::AlignHCenter);
    close->setDefault(true);
    close->setFocus();
    dialog->show();
    return dialog;
}

} // namespace chiron::desktop
