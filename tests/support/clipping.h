// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStringList>
#include <QTabBar>
#include <QWidget>

namespace chiron::tests {

/// How a finding names a widget: class, object name, text.
inline QString nameOf(const QWidget* widget) {
    QString text;
    if (const auto* label = qobject_cast<const QLabel*>(widget))
        text = label->text();
    else if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
        text = button->text();
    return QStringLiteral("%1 '%2' \"%3\"")
        .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(), text.left(60));
}

/// Whether some scroll area above it lets the person reach what is out of sight.
inline bool canBeScrolledTo(const QWidget* widget) {
    for (const QWidget* w = widget->parentWidget(); w; w = w->parentWidget())
        if (qobject_cast<const QAbstractScrollArea*>(w))
            return true;
    return false;
}

/// What of a visible widget's words does not fit into it; empty where all fits.
inline QString clippedText(const QWidget* widget) {
    const auto narrow = [widget](int needed) {
        return needed > widget->width() + 1 ? QStringLiteral("needs %1 px, has %2: %3")
                                                  .arg(needed)
                                                  .arg(widget->width())
                                                  .arg(nameOf(widget))
                                            : QString();
    };
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        if (label->text().isEmpty())
            return {};
        if (!label->wordWrap())
            return narrow(label->sizeHint().width());
        const int height = label->heightForWidth(label->width());
        if (height > label->height() + 1)
            return QStringLiteral("needs %1 px height, has %2: %3")
                .arg(height)
                .arg(label->height())
                .arg(nameOf(widget));
        // A single word longer than the line is cut by the label.
        for (const QString& word : label->text().split(QRegularExpression(QStringLiteral("[\\s\\x{200B}]+"))))
            if (label->fontMetrics().horizontalAdvance(word) > label->contentsRect().width() + 1)
                return QStringLiteral("the word \"%1\" is wider than %2").arg(word, nameOf(widget));
        return {};
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
        return button->text().isEmpty() ? QString() : narrow(button->sizeHint().width());
    if (const auto* combo = qobject_cast<const QComboBox*>(widget))
        return narrow(combo->fontMetrics().horizontalAdvance(combo->currentText()) + 24);
    if (const auto* header = qobject_cast<const QHeaderView*>(widget);
        header && header->orientation() == Qt::Horizontal && header->model()) {
        for (int i = 0; i < header->count(); ++i)
            if (!header->isSectionHidden(i) && header->sectionSizeHint(i) > header->sectionSize(i) + 1)
                return QStringLiteral("column \"%1\" needs %2 px, has %3")
                    .arg(header->model()->headerData(i, Qt::Horizontal).toString())
                    .arg(header->sectionSizeHint(i))
                    .arg(header->sectionSize(i));
    }
    if (const auto* field = qobject_cast<const QLineEdit*>(widget);
        field && !field->placeholderText().isEmpty())
        return narrow(field->fontMetrics().horizontalAdvance(field->placeholderText()) + 8);
    return {};
}

/// Pages scroll down only: what lies to the side is not found.
inline QString widerThanItsPage(const QWidget* widget) {
    const auto* area = qobject_cast<const QScrollArea*>(widget);
    if (!area || area->horizontalScrollBar()->maximum() == 0)
        return {};
    const QWidget* widest = nullptr; // what asks for most, so that whoever reads this knows where to look
    for (const QWidget* child : area->findChildren<QWidget*>())
        if (child->isVisible() && child->findChildren<QWidget*>().isEmpty() &&
            (!widest || child->minimumSizeHint().width() > widest->minimumSizeHint().width()))
            widest = child;
    return QStringLiteral("must be scrolled sideways by %1 px: %2; widest in it: %3")
        .arg(area->horizontalScrollBar()->maximum())
        .arg(nameOf(widget), widest ? nameOf(widest) : QString());
}

/// Everything on this page whose words are cut off, or that lies outside its parent where nobody can scroll
/// to it.
inline QStringList clippedOn(const QWidget* page) {
    QStringList findings;
    for (const QWidget* widget : page->findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->width() == 0)
            continue;
        if (const QString cut = clippedText(widget); !cut.isEmpty())
            findings << cut;
        if (const QString wide = widerThanItsPage(widget); !wide.isEmpty())
            findings << wide;
        const QWidget* parent = widget->parentWidget();
        const bool words =
            qobject_cast<const QLabel*>(widget) || qobject_cast<const QAbstractButton*>(widget);
        if (words && parent && !parent->rect().adjusted(-1, -1, 1, 1).contains(widget->geometry()) &&
            !canBeScrolledTo(widget))
            findings << QStringLiteral("lies outside its parent: ") + nameOf(widget);
    }
    return findings;
}

/// Controls that a screen reader could not name, or that the keyboard does not reach.
inline QStringList unnamedOn(const QWidget* page) {
    QStringList findings;
    for (const QWidget* widget : page->findChildren<QWidget*>()) {
        const bool inner = widget->objectName().startsWith(QLatin1String("qt_")) ||
                           qobject_cast<const QScrollBar*>(widget) ||
                           qobject_cast<const QHeaderView*>(widget) ||
                           qobject_cast<const QAbstractItemView*>(widget->parentWidget()) ||
                           qobject_cast<const QComboBox*>(widget->parentWidget()) ||
                           qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) ||
                           qobject_cast<const QLineEdit*>(widget->parentWidget()) ||
                           qobject_cast<const QTabBar*>(widget->parentWidget());
        if (!widget->isVisible() || inner)
            continue;
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const bool control =
            button || qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget) ||
            qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
            qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QAbstractItemView*>(widget);
        if (!control)
            continue;
        bool labelled = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
        for (const QLabel* label : page->findChildren<QLabel*>())
            labelled = labelled || label->buddy() == widget;
        if (!labelled)
            findings << QStringLiteral("no accessible name: ") + nameOf(widget);
        if (widget->isEnabled() && !(widget->focusPolicy() & Qt::TabFocus))
            findings << QStringLiteral("the keyboard does not reach: ") + nameOf(widget);
    }
    return findings;
}

} // namespace chiron::tests
