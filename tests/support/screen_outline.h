// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/of_today.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QBoxLayout>
#include <QComboBox>
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabBar>
#include <QTableView>
#include <QWidget>

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::tests {

/// How a page is made, as lines of text: what is in which layout and how far apart, what it says and to whom,
/// how it is lettered, what can be reached, what is turned or typed, the lines of lists and tables, and the
/// colours of signs. Without what differs from run to run: dates, digests, codes that are drawn, and where
/// exactly things lie on the screen.
class ScreenOutline {
public:
    static QStringList of(const QWidget& page) {
        ScreenOutline outline;
        outline.add(page, 0);
        return outline.m_lines;
    }
    /// Where the keys go as soon as the page's window is the active one.
    static QString focusOn(const QWidget& page) {
        const QWidget* in = page.focusWidget();
        return QStringLiteral("focus on ") + (in ? nameOf(in) : QStringLiteral("nothing"));
    }

private:
    /// Why a scene is flat is the machine's: no OpenGL, or no part of three dimensions built.
    static QString said(const QString& text) {
        static const QRegularExpression why(QStringLiteral("(Shown in 2D: )[^.]*"));
        return withoutToday(text.left(400))
            .replace(why, QStringLiteral("\\1…"))
            .replace(QLatin1Char('\n'), QLatin1Char('|'))
            .simplified();
    }

    void line(int depth, const QString& text) { m_lines << QString(depth, QLatin1Char(' ')) + text; }

    /// What comes and goes while something is read.
    static bool isOfWaiting(const QWidget* widget) {
        return widget && (qobject_cast<const QProgressBar*>(widget) ||
                          widget->objectName() == QLatin1String("state.cancel"));
    }

    static QString nameOf(const QObject* object) {
        return QString::fromLatin1(object->metaObject()->className())
                   .remove(QStringLiteral("chiron::desktop::")) +
               (object->objectName().isEmpty() || object->objectName().startsWith(QLatin1String("qt_"))
                    ? QString()
                    : QStringLiteral("#") + said(object->objectName()));
    }

    void add(const QLayout& layout, int depth) {
        const QMargins m = layout.contentsMargins();
        line(depth, QStringLiteral("%1 %2 %3,%4,%5,%6")
                        .arg(QLatin1String(layout.metaObject()->className()))
                        .arg(layout.spacing())
                        .arg(m.left())
                        .arg(m.top())
                        .arg(m.right())
                        .arg(m.bottom()));
        const auto* box = qobject_cast<const QBoxLayout*>(&layout);
        const auto* grid = qobject_cast<const QGridLayout*>(&layout);
        const auto* form = qobject_cast<const QFormLayout*>(&layout);
        if (form)
            line(depth + 1, QStringLiteral("gaps %1x%2, wraps %3, labels %4")
                                .arg(form->horizontalSpacing())
                                .arg(form->verticalSpacing())
                                .arg(static_cast<int>(form->rowWrapPolicy()))
                                .arg(static_cast<int>(form->labelAlignment()), 0, 16));
        if (grid) {
            QStringList stretches;
            for (int column = 0; column < grid->columnCount(); ++column)
                stretches << QString::number(grid->columnStretch(column));
            stretches << QStringLiteral("rows");
            for (int row = 0; row < grid->rowCount(); ++row)
                stretches << QString::number(grid->rowStretch(row));
            line(depth + 1, QStringLiteral("gaps %1x%2, stretches %3")
                                .arg(grid->horizontalSpacing())
                                .arg(grid->verticalSpacing())
                                .arg(stretches.join(QLatin1Char(' '))));
        }
        for (int i = 0; i < layout.count(); ++i) {
            QLayoutItem* item = layout.itemAt(i);
            const bool empty = item->spacerItem() && item->sizeHint().isEmpty();
            if (isOfWaiting(item->widget()) || (empty && (!box || box->stretch(i) == 0)))
                continue; // something is waited for, or was
            QString place = QStringLiteral("- ");
            if (box)
                place += QStringLiteral("stretch %1 ").arg(box->stretch(i));
            if (grid) {
                int row = 0, column = 0, rows = 0, columns = 0;
                grid->getItemPosition(i, &row, &column, &rows, &columns);
                place += QStringLiteral("at %1,%2 %3x%4 ").arg(row).arg(column).arg(rows).arg(columns);
            }
            place += QString::number(static_cast<int>(item->alignment()), 16);
            if (empty)
                line(depth + 1, place + QStringLiteral(" room that is left"));
            else if (item->widget())
                line(depth + 1, place + QLatin1Char(' ') + nameOf(item->widget()));
            else if (item->layout())
                add(*item->layout(), depth + 1);
            else
                line(depth + 1, place + QStringLiteral(" space %1x%2")
                                            .arg(item->sizeHint().width())
                                            .arg(item->sizeHint().height()));
        }
    }

    /// The minimum size, except where a window's layout computes it, because that depends on the fonts.
    static QSize ownLeast(const QWidget& widget) {
        QSize least = widget.minimumSize();
        if (!widget.isWindow() || !widget.layout())
            return least;
        const QSize needed = widget.layout()->totalMinimumSize();
        if (least.width() == needed.width())
            least.setWidth(0);
        if (least.height() == needed.height())
            least.setHeight(0);
        return least;
    }

    static QString look(const QWidget& widget) {
        QStringList parts;
        if (widget.isHidden())
            parts << QStringLiteral("hidden");
        if (!widget.isEnabled())
            parts << QStringLiteral("disabled");
        const QFont font = widget.font();
        const QWidget* above = widget.parentWidget();
        if (!above || above->font() != font)
            parts << QStringLiteral("font %1/%2%3")
                         .arg(font.pixelSize() > 0 ? font.pixelSize() : font.pointSize())
                         .arg(font.weight())
                         .arg(font.italic() ? QStringLiteral("i") : QString());
        if (widget.focusPolicy() != Qt::NoFocus)
            parts << QStringLiteral("focus %1").arg(static_cast<int>(widget.focusPolicy()));
        const QSizePolicy policy = widget.sizePolicy();
        if (policy.horizontalPolicy() != QSizePolicy::Preferred ||
            policy.verticalPolicy() != QSizePolicy::Preferred)
            parts << QStringLiteral("policy %1/%2")
                         .arg(static_cast<int>(policy.horizontalPolicy()))
                         .arg(static_cast<int>(policy.verticalPolicy()));
        if (policy.retainSizeWhenHidden())
            parts << QStringLiteral("keeps its room");
        const bool sized = !qobject_cast<const QMessageBox*>(&widget); // by Qt, as the screen's width allows
        if (const QSize least = ownLeast(widget); sized && least != QSize(0, 0))
            parts << QStringLiteral("least %1x%2").arg(least.width()).arg(least.height());
        if (sized && widget.maximumSize() != QSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX))
            parts << QStringLiteral("most %1x%2").arg(widget.maximumWidth()).arg(widget.maximumHeight());
        if (sized && widget.isWindow() && widget.testAttribute(Qt::WA_Resized)) // not by its layout
            parts << QStringLiteral("size %1x%2").arg(widget.width()).arg(widget.height());
        if (widget.testAttribute(Qt::WA_DeleteOnClose))
            parts << QStringLiteral("gone when closed");
        if (widget.testAttribute(Qt::WA_TransparentForMouseEvents))
            parts << QStringLiteral("clicked through");
        if (const QString used = use(widget); !used.isEmpty())
            parts << used;
        for (const QByteArray& key : widget.dynamicPropertyNames())
            if (!key.startsWith("_"))
                parts << QString::fromLatin1(key) + QLatin1Char('=') + said(widget.property(key).toString());
        for (const auto& [kind, text] : {std::pair{"tip", widget.toolTip()},
                                         {"name", widget.accessibleName()},
                                         {"about", widget.accessibleDescription()}})
            if (!text.isEmpty())
                parts << QLatin1String(kind) + QStringLiteral(" \"") + said(text) + QLatin1Char('"');
        return parts.join(QStringLiteral(", "));
    }

    /// What a control does with keys, links and a lack of room, where it is not what Qt would do.
    static QString use(const QWidget& widget) {
        QStringList parts;
        if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
            if (label->buddy())
                parts << QStringLiteral("of ") + nameOf(label->buddy());
            if (label->textFormat() != Qt::AutoText)
                parts << QStringLiteral("format %1").arg(static_cast<int>(label->textFormat()));
            if (label->textInteractionFlags() != Qt::LinksAccessibleByMouse)
                parts << QStringLiteral("takes %1").arg(int(label->textInteractionFlags()), 0, 16);
            if (label->openExternalLinks())
                parts << QStringLiteral("opens links");
        }
        if (const auto* button = qobject_cast<const QPushButton*>(&widget)) {
            if (button->isDefault())
                parts << QStringLiteral("default");
            if (button->autoDefault() && !qobject_cast<const QDialog*>(button->window()))
                parts << QStringLiteral("pressed by Enter");
        }
        if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
            if (combo->sizeAdjustPolicy() != QComboBox::AdjustToContentsOnFirstShow)
                parts << QStringLiteral("adjusts %1 to %2 letters")
                             .arg(static_cast<int>(combo->sizeAdjustPolicy()))
                             .arg(combo->minimumContentsLength());
            if (combo->isEditable())
                parts << QStringLiteral("typed into");
        }
        if (const auto* spin = qobject_cast<const QAbstractSpinBox*>(&widget))
            if (spin->buttonSymbols() != QAbstractSpinBox::UpDownArrows || !spin->keyboardTracking())
                parts << QStringLiteral("arrows %1%2")
                             .arg(static_cast<int>(spin->buttonSymbols()))
                             .arg(spin->keyboardTracking() ? QString() : QStringLiteral(" taken at the end"));
        if (const auto* edit = qobject_cast<const QLineEdit*>(&widget); edit && edit->isClearButtonEnabled())
            parts << QStringLiteral("can be emptied");
        if (const auto* area = qobject_cast<const QAbstractScrollArea*>(&widget)) {
            if (area->horizontalScrollBarPolicy() != Qt::ScrollBarAsNeeded ||
                area->verticalScrollBarPolicy() != Qt::ScrollBarAsNeeded)
                parts << QStringLiteral("bars %1/%2")
                             .arg(static_cast<int>(area->horizontalScrollBarPolicy()))
                             .arg(static_cast<int>(area->verticalScrollBarPolicy()));
            if (const auto* page = qobject_cast<const QScrollArea*>(area); page && page->widgetResizable())
                parts << QStringLiteral("as wide as its room");
            if (area->frameShape() != QFrame::StyledPanel)
                parts << QStringLiteral("frame %1").arg(static_cast<int>(area->frameShape()));
        }
        return parts.join(QStringLiteral(", "));
    }

    /// The colour that most of a sign has: signs are of one colour each.
    static QString inkOf(const QImage& picture) {
        std::map<QRgb, int> inks;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (const QRgb dot = picture.pixel(x, y); qAlpha(dot) == 255)
                    ++inks[dot];
        const auto most = std::max_element(inks.begin(), inks.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        return most == inks.end() ? QStringLiteral("thin") : QColor(most->first).name();
    }
    static QString icon(const QIcon& icon, const QSize& size) {
        return icon.isNull() ? QString()
                             : QStringLiteral(" icon %1x%2 %3")
                                   .arg(size.width())
                                   .arg(size.height())
                                   .arg(inkOf(icon.pixmap(QSize(32, 32), 1.0).toImage()));
    }
    /// What may be typed or turned to.
    static QString range(const QWidget& widget) {
        if (const auto* whole = qobject_cast<const QSpinBox*>(&widget))
            return QStringLiteral("%1 of %2 to %3 by %4 \"%5\" \"%6\"")
                .arg(whole->value())
                .arg(whole->minimum())
                .arg(whole->maximum())
                .arg(whole->singleStep())
                .arg(whole->prefix(), whole->suffix());
        if (const auto* real = qobject_cast<const QDoubleSpinBox*>(&widget))
            return QStringLiteral("%1 of %2 to %3 by %4 \"%5\" \"%6\" digits %7")
                .arg(number(real->value()), number(real->minimum()), number(real->maximum()),
                     number(real->singleStep()), real->prefix(), real->suffix())
                .arg(real->decimals());
        if (const auto* date = qobject_cast<const QDateEdit*>(&widget))
            return QStringLiteral("day as %1%2")
                .arg(date->displayFormat(), date->calendarPopup() ? QStringLiteral(" popup") : QString());
        if (const auto* slider = qobject_cast<const QAbstractSlider*>(&widget);
            slider && !qobject_cast<const QScrollBar*>(slider)) // a scroll bar is of where things lie
            return QStringLiteral("%1 of %2 to %3 by %4/%5")
                .arg(slider->value())
                .arg(slider->minimum())
                .arg(slider->maximum())
                .arg(slider->singleStep())
                .arg(slider->pageStep());
        if (const auto* text = qobject_cast<const QPlainTextEdit*>(&widget))
            return QStringLiteral("\"%1\" for \"%2\"%3%4")
                .arg(said(text->toPlainText()), said(text->placeholderText()),
                     text->isReadOnly() ? QStringLiteral(" read only") : QString(),
                     text->tabChangesFocus() ? QStringLiteral(" tab leaves") : QString());
        if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) {
            QStringList tabs;
            for (int i = 0; i < bar->count(); ++i)
                tabs << said(bar->tabText(i)) + (i == bar->currentIndex() ? QStringLiteral("*") : QString()) +
                            (bar->isTabEnabled(i) ? QString() : QStringLiteral(" disabled"));
            return tabs.join(QLatin1Char('/'));
        }
        return {};
    }

    static QString words(const QWidget& widget) {
        if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
            const QPixmap sign = label->pixmap();
            return QStringLiteral("\"%1\" %2%3%4")
                .arg(said(label->text()))
                .arg(static_cast<int>(label->alignment()), 0, 16)
                .arg(label->wordWrap() ? QStringLiteral(" wraps") : QString(),
                     sign.isNull() ? QString()
                                   : QStringLiteral(" sign %1x%2 %3")
                                         .arg(sign.width())
                                         .arg(sign.height())
                                         .arg(inkOf(sign.toImage())));
        }
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
            return QStringLiteral("\"%1\"%2%3%4")
                .arg(said(button->text()), icon(button->icon(), button->iconSize()),
                     button->isCheckable() ? QStringLiteral(" checkable") : QString(),
                     button->isChecked() ? QStringLiteral(" checked") : QString());
        if (const auto* edit = qobject_cast<const QLineEdit*>(&widget))
            return QStringLiteral("\"%1\" for \"%2\" %3 mode %4%5")
                .arg(said(edit->text()), said(edit->placeholderText()))
                .arg(edit->maxLength())
                .arg(static_cast<int>(edit->echoMode()))
                .arg(edit->isReadOnly() ? QStringLiteral(" read only") : QString());
        if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
            QStringList items;
            for (int i = 0; i < combo->count(); ++i)
                items << said(combo->itemText(i)) +
                             (i == combo->currentIndex() ? QStringLiteral("*") : QString());
            return items.join(QLatin1Char('/'));
        }
        if (const auto* box = qobject_cast<const QGroupBox*>(&widget))
            return QStringLiteral("\"%1\"").arg(said(box->title()));
        return range(widget);
    }

    /// The words of a cell, how they stand, and whether there is a picture.
    static QString cell(const QModelIndex& at) {
        const QString tip = at.data(Qt::ToolTipRole).toString(),
                      name = at.data(Qt::AccessibleTextRole).toString();
        return said(at.data().toString()) + QLatin1Char(' ') +
               QString::number(at.data(Qt::TextAlignmentRole).toInt(), 16) +
               (at.data(Qt::DecorationRole).isValid() ? QStringLiteral(" icon") : QString()) +
               (tip.isEmpty() ? QString() : QStringLiteral(" tip \"%1\"").arg(said(tip))) +
               (name.isEmpty() ? QString() : QStringLiteral(" name \"%1\"").arg(said(name))) +
               (at.flags() & Qt::ItemIsEnabled ? QString() : QStringLiteral(" disabled"));
    }

    void add(const QTableView& table, int depth) {
        const QAbstractItemModel& model = *table.model();
        QStringList head;
        for (int column = 0; column < model.columnCount(); ++column)
            head << said(model.headerData(column, Qt::Horizontal).toString()) +
                        QStringLiteral(" %1%2")
                            .arg(static_cast<int>(table.horizontalHeader()->sectionResizeMode(column)))
                            .arg(table.isColumnHidden(column) ? QStringLiteral(" hidden") : QString());
        line(depth, QStringLiteral("columns ") + head.join(QLatin1Char('/')) +
                        QStringLiteral("; select %1/%2, edit %3%4")
                            .arg(static_cast<int>(table.selectionBehavior()))
                            .arg(static_cast<int>(table.selectionMode()))
                            .arg(static_cast<int>(table.editTriggers()))
                            .arg(table.isSortingEnabled() ? QStringLiteral(", sorts") : QString()));
        const QHeaderView &top = *table.horizontalHeader(), &side = *table.verticalHeader();
        line(depth, QStringLiteral("head %1 high %2 to %3%4%5%6, rows %7 high%8%9")
                            .arg(static_cast<int>(top.defaultAlignment()), 0, 16)
                            .arg(top.minimumHeight())
                            .arg(top.maximumHeight())
                            .arg(top.isHidden() ? QStringLiteral(" hidden") : QString(),
                                 top.stretchLastSection() ? QStringLiteral(" fills the last") : QString(),
                                 top.highlightSections() ? QStringLiteral(" marks") : QString())
                            .arg(side.defaultSectionSize())
                            .arg(side.isHidden() ? QString() : QStringLiteral(" with heads"),
                                 table.tabKeyNavigation() ? QStringLiteral(", tab walks") : QString()) +
                        QStringLiteral("%1%2%3, signs %4x%5")
                            .arg(table.showGrid() ? QStringLiteral(", grid") : QString(),
                                 table.wordWrap() ? QStringLiteral(", wraps") : QString(),
                                 table.isCornerButtonEnabled() ? QStringLiteral(", corner") : QString())
                            .arg(table.iconSize().width())
                            .arg(table.iconSize().height()));
        for (int row = 0; row < std::min(model.rowCount(), 40); ++row) {
            QStringList cells;
            for (int column = 0; column < model.columnCount(); ++column)
                cells << cell(model.index(row, column));
            line(depth, QStringLiteral("row ") + cells.join(QLatin1Char('/')));
        }
    }

    /// The lines of a list, as those of a table.
    void add(const QListView& list, int depth) {
        for (int row = 0; row < std::min(list.model()->rowCount(), 40); ++row) {
            const QModelIndex at = list.model()->index(row, 0);
            line(depth, QStringLiteral("item ") + cell(at) +
                            (at == list.currentIndex() ? QStringLiteral(" *") : QString()));
        }
    }

    /// To four digits: sums of many points round differently on different processors.
    static QString number(double x) { return QString::number(std::abs(x) < 1e-9 ? 0.0 : x, 'g', 4); }

    static QString axis(const QCPAxis& axis) {
        return QStringLiteral("\"%1\" %2 to %3%4")
            .arg(said(axis.label()), number(axis.range().lower), number(axis.range().upper),
                 axis.visible() ? QString() : QStringLiteral(" hidden"));
    }

    /// The pen and the brush of something in a plot.
    static QString strokes(const QObject& drawn) {
        QStringList parts;
        if (const QVariant pen = drawn.property("pen"); pen.isValid())
            parts << QStringLiteral("pen %1 %2/%3")
                         .arg(pen.value<QPen>().color().name(QColor::HexArgb))
                         .arg(pen.value<QPen>().widthF())
                         .arg(static_cast<int>(pen.value<QPen>().style()));
        if (const auto brush = drawn.property("brush").value<QBrush>(); brush.style() != Qt::NoBrush)
            parts << QStringLiteral("fill %1/%2")
                         .arg(brush.color().name(QColor::HexArgb))
                         .arg(static_cast<int>(brush.style()));
        return parts.join(QLatin1Char(' '));
    }

    /// What is plotted: axes, and of each graph its name, how many points it has and where they lie on
    /// average.
    void add(QCustomPlot& plot, int depth) {
        if (plot.axisRectCount() > 0)
            line(depth,
                 QStringLiteral("x %1; y %2%3")
                     .arg(axis(*plot.xAxis), axis(*plot.yAxis),
                          plot.legend && plot.legend->visible() ? QStringLiteral("; legend") : QString()));
        for (int i = 0; i < plot.plottableCount(); ++i) {
            QCPAbstractPlottable& drawn = *plot.plottable(i);
            QString text =
                QStringLiteral("%1 \"%2\" %3")
                    .arg(QLatin1String(drawn.metaObject()->className()), said(drawn.name()), strokes(drawn));
            if (const auto* points = drawn.interface1D()) {
                double x = 0.0, y = 0.0;
                for (int k = 0; k < points->dataCount(); ++k) {
                    x += points->dataMainKey(k) / points->dataCount();
                    y += points->dataMainValue(k) / points->dataCount();
                }
                text += QStringLiteral(" n %1 at %2,%3").arg(points->dataCount()).arg(number(x), number(y));
            }
            line(depth, text);
        }
        for (int i = 0; i < plot.itemCount(); ++i) {
            const QCPAbstractItem& item = *plot.item(i);
            QString text = QLatin1String(item.metaObject()->className()) + QLatin1Char(' ') + strokes(item);
            for (const QCPItemPosition* at : item.positions())
                text += QStringLiteral(" %1,%2").arg(number(at->key()), number(at->value()));
            if (const auto* words = qobject_cast<const QCPItemText*>(&item))
                text += QStringLiteral(" \"%1\"").arg(said(words->text()));
            line(depth, text);
        }
    }

    void add(const QWidget& widget, int depth) {
        if (isOfWaiting(&widget) || (depth > 0 && widget.objectName().startsWith(QLatin1String(
                                                      "screen.")))) // a screen has an outline of its own
            return;
        line(depth, QStringLiteral("%1 %2 (%3)").arg(nameOf(&widget), words(widget), look(widget)));
        if (const auto* table = qobject_cast<const QTableView*>(&widget); table && table->model()) {
            add(*table, depth + 1);
            return;
        }
        if (const auto* list = qobject_cast<const QListView*>(&widget); list && list->model()) {
            add(*list, depth + 1);
            return;
        }
        if (const auto* plot = qobject_cast<const QCustomPlot*>(&widget))
            return add(const_cast<QCustomPlot&>(*plot), depth + 1); // its readers are not const
        if (qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
            qobject_cast<const QLineEdit*>(&widget))
            return; // what it is made of is Qt's
        if (qobject_cast<const QPlainTextEdit*>(&widget) || qobject_cast<const QTabBar*>(&widget) ||
            qobject_cast<const QAbstractSlider*>(&widget))
            return;
        if (widget.layout())
            add(*widget.layout(), depth + 1);
        for (const QObject* child : widget.children())
            if (const auto* below = qobject_cast<const QWidget*>(child); below && !below->isWindow())
                add(*below, depth + 1);
    }

    QStringList m_lines;
};

} // namespace chiron::tests
