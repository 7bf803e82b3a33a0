// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/help_dialogs.h"

#include "desktop/frame/key_names.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"

#include <QCoreApplication>
#include <QDialog>
#include <QGridLayout>

namespace chiron::desktop {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("HelpDialogs", text);
}

/// A dialog with a scrolling page and a button to close it.
QDialog* makeDialog(const Theme& theme, const QString& name, const QString& title, ScrollPage*& page,
                    QWidget* parent) {
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(name);
    dialog->setWindowTitle(title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->resize(theme.px(620), theme.px(480));
    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(0, 0, 0, theme.px(12));
    page = new ScrollPage(theme, 0);
    column->addWidget(page, 1);
    auto* close = kit::button(theme, words(QT_TRANSLATE_NOOP("HelpDialogs", "Close")), "primary");
    QObject::connect(close, &QPushButton::clicked, dialog, &QDialog::accept);
    column->addWidget(close, 0, Qt::AlignHCenter);
    close->setDefault(true);
    close->setFocus();
    return dialog;
}

void addKeys(const Theme& theme, QVBoxLayout* column, const std::vector<ScreenCommand>& commands) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(theme.px(24));
    grid->setVerticalSpacing(theme.px(6));
    grid->setColumnStretch(1, 1);
    int row = 0;
    for (const ScreenCommand& command : commands) {
        if (command.keys.isEmpty())
            continue;
        grid->addWidget(kit::line(theme, shortcutInWords(command.keys), TextStyle::strong), row, 0,
                        Qt::AlignTop);
        grid->addWidget(kit::label(theme, command.text), row, 1);
        ++row;
    }
    column->addLayout(grid);
}

bool hasKeys(const CommandGroup& group) {
    for (const ScreenCommand& command : group.commands)
        if (!command.keys.isEmpty())
            return true;
    return false;
}

} // namespace

QDialog* showShortcuts(const Theme& theme, const std::vector<CommandGroup>& groups, QWidget* parent) {
    ScrollPage* page = nullptr;
    const QString title = words(QT_TRANSLATE_NOOP("HelpDialogs", "Keyboard shortcuts"));
    QDialog* dialog = makeDialog(theme, QStringLiteral("shortcuts"), title, page, parent);
    page->column()->addWidget(kit::label(theme, title, TextStyle::heading));
    for (const CommandGroup& group : groups) {
        if (!hasKeys(group))
            continue;
        page->column()->addWidget(kit::label(theme, group.title, TextStyle::title));
        addKeys(theme, page->column(), group.commands);
    }
    page->column()->addStretch();
    dialog->show();
    return dialog;
}

QDialog* showWords(const Theme& theme, const QString& title, const QString& text, QWidget* parent) {
    ScrollPage* page = nullptr;
    QDialog* dialog = makeDialog(theme, QStringLiteral("words"), title, page, parent);
    page->column()->addWidget(kit::label(theme, title, TextStyle::heading));
    auto* label = kit::label(theme, text);
    label->setObjectName(QStringLiteral("words.text"));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    page->column()->addWidget(label);
    page->column()->addStretch();
    dialog->show();
    return dialog;
}

QDialog* showHelp(const Theme& theme, Screen& screen, QWidget* parent) {
    ScrollPage* page = nullptr;
    const QString title = words(QT_TRANSLATE_NOOP("HelpDialogs", "Help: %1")).arg(screen.title());
    QDialog* dialog = makeDialog(theme, QStringLiteral("help"), title, page, parent);
    page->column()->addWidget(kit::label(theme, screen.title(), TextStyle::heading));
    for (const QString& paragraph : screen.help().split(QStringLiteral("\n\n"), Qt::SkipEmptyParts))
        page->column()->addWidget(kit::label(theme, paragraph));
    const CommandGroup own{screen.title(), screen.commands()};
    if (hasKeys(own)) {
        page->column()->addWidget(kit::label(
            theme, words(QT_TRANSLATE_NOOP("HelpDialogs", "Keys on this screen")), TextStyle::title));
        addKeys(theme, page->column(), own.commands);
    }
    page->column()->addStretch();
    dialog->show();
    return dialog;
}

} // namespace chiron::desktop
