// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/screen_outline.h"

#include <QAbstractSlider>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollBar>
#include <QTabBar>
#include <QTableView>
#include <QtTest>

namespace chiron::tests {

/// What somebody can touch on a page, one control after another, each in the way that it is made for.
class TouchingHand {
public:
    /// What can be seen and reached of this page, each with the name that it goes by.
    static std::vector<std::pair<QString, QWidget*>> controlsOn(QWidget& page) {
        std::vector<std::pair<QString, QWidget*>> found;
        for (QWidget* widget : page.findChildren<QWidget*>())
            if (const QString name = nameOf(*widget); !name.isEmpty() && widget->isVisibleTo(&page) && widget->isEnabled() && !isOfAnother(*widget))
                found.emplace_back(name, widget);
        return found;
    }

    static void touch(QWidget& control) {
        if (auto* button = qobject_cast<QAbstractButton*>(&control))
            button->click();
        else if (auto* combo = qobject_cast<QComboBox*>(&control)) {
            const int next = (combo->currentIndex() + 1) % std::max(1, combo->count());
            combo->setCurrentIndex(next);
            emit combo->activated(next);
        } else if (auto* spin = qobject_cast<QAbstractSpinBox*>(&control)) {
            spin->stepUp();
            emit spin->editingFinished();
        } else if (auto* edit = qobject_cast<QLineEdit*>(&control)) {
            edit->setFocus();
            edit->clear();
            QTest::keyClicks(edit, QStringLiteral("12 words"));
            emit edit->editingFinished();
        } else if (auto* text = qobject_cast<QPlainTextEdit*>(&control))
            text->setPlainText(QStringLiteral("words that were typed"));
        else if (auto* bar = qobject_cast<QTabBar*>(&control))
            bar->setCurrentIndex((bar->currentIndex() + 1) % std::max(1, bar->count()));
        else if (auto* slider = qobject_cast<QAbstractSlider*>(&control))
            QTest::keyClick(slider, Qt::Key_PageUp);
        else if (auto* view = qobject_cast<QAbstractItemView*>(&control); view && view->model() && view->model()->rowCount() > 0) {
            view->setFocus();
            view->setCurrentIndex(view->model()->index(view->model()->rowCount() - 1, 0));
        }
    }

    /// Another way to touch what has rows: the first one twice.
    static bool touchTwice(QWidget& control) {
        auto* view = qobject_cast<QAbstractItemView*>(&control);
        if (!view || !view->model() || view->model()->rowCount() == 0)
            return false;
        const QModelIndex first = view->model()->index(0, 0);
        view->scrollTo(first);
        const QPoint at = view->visualRect(first).center();
        QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, at);
        return true;
    }

private:
    static bool isTouchable(const QWidget& widget) {
        return qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
               qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QPlainTextEdit*>(&widget) || qobject_cast<const QTabBar*>(&widget) ||
               qobject_cast<const QAbstractItemView*>(&widget) || (qobject_cast<const QAbstractSlider*>(&widget) && !qobject_cast<const QScrollBar*>(&widget));
    }
    /// What Qt put into a control; in the cells of a table are controls of the page.
    static bool isOfAnother(const QWidget& widget) {
        for (const QWidget* above = widget.parentWidget(); above && !above->isWindow(); above = above->parentWidget())
            if (isTouchable(*above) && !qobject_cast<const QAbstractItemView*>(above))
                return true;
        return false;
    }
    static QString nameOf(const QWidget& widget) {
        if (!isTouchable(widget))
            return {};
        QString name = widget.objectName();
        if (name.isEmpty() || name.startsWith(QLatin1String("qt_")))
            name = widget.accessibleName();
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget); button && name.isEmpty())
            name = button->text();
        if (qobject_cast<const QTabBar*>(&widget) && name.isEmpty() && widget.parentWidget())
            name = widget.parentWidget()->objectName() + QStringLiteral(".bar");
        return withoutToday(name);
    }
};

} // namespace chiron::tests
