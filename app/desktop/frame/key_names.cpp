// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/key_names.h"

#include <QCoreApplication>
#include <QStringList>

namespace chiron::desktop {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(KeyNames)
};

/// Of the keys that Qt names in another way than the program's texts; otherwise empty.
QString ownNameOf(Qt::Key key) {
    switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return Words::tr("Enter");
    case Qt::Key_PageUp:
        return Words::tr("Page Up");
    case Qt::Key_PageDown:
        return Words::tr("Page Down");
    case Qt::Key_Delete:
        return Words::tr("Delete");
    case Qt::Key_Backspace:
        return Words::tr("Backspace");
    default:
        return {};
    }
}

QString inWords(QKeyCombination pressed) {
    QString words = QKeySequence(pressed).toString(QKeySequence::NativeText);
    if (const QString name = ownNameOf(pressed.key()); !name.isEmpty()) {
        // The key itself stands last.
        words.chop(QKeySequence(pressed.key()).toString(QKeySequence::NativeText).size());
        words += name;
    }
    return words;
}
} // namespace

QString shortcutInWords(const QKeySequence& keys) {
    QStringList pressed;
    for (int i = 0; i < keys.count(); ++i)
        pressed << inWords(keys[static_cast<uint>(i)]);
    return pressed.join(QStringLiteral(", "));
}

} // namespace chiron::desktop
