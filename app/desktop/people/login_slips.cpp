// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/login_slips.h"

#include "report/page_writer.h"
#include "report/text_box.h"

#include <QCoreApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPen>
#include <algorithm>
#include <qcustomplot.h>

namespace chiron::desktop {

namespace {

// In logical pixels of 1/96 inch.
constexpr double kPadding = 14.0;
constexpr double kLabelWidth = 150.0;

QString words(const char* text) {
    return QCoreApplication::translate("LoginSlips", text);
}

QString shown(const std::string& stored) {
    return QString::fromStdString(stored);
}

/// One line of a slip: label and value.
struct Line {
    QString label;
    QString value;
    QFont font;
};

/// A font in which no two letters look alike.
QFont secretFont(const report::PlotTheme& theme) {
    QFont font = theme.font(15, true);
    font.setFamily(QFontDatabase::systemFont(QFontDatabase::FixedFont).family());
    return font;
}

std::vector<Line> linesOf(const LoginSlips& slips, const database::ImportedPerson& person,
                          const report::PlotTheme& theme) {
    const QString name = shown(person.displayName.empty() ? person.name : person.displayName);
    std::vector<Line> lines{{words(QT_TRANSLATE_NOOP("LoginSlips", "Name")), name, theme.font(14, true)}};
    if (!slips.site.isEmpty())
        lines.push_back({words(QT_TRANSLATE_NOOP("LoginSlips", "Site")), slips.site, theme.font(12)});
    lines.push_back(
        {words(QT_TRANSLATE_NOOP("LoginSlips", "Login name")), shown(person.name), secretFont(theme)});
    lines.push_back(
        {words(QT_TRANSLATE_NOOP("LoginSlips", "Password")), shown(person.madePassword), secretFont(theme)});
    return lines;
}

report::Block slipOf(const LoginSlips& slips, const database::ImportedPerson& person,
                     const report::PlotTheme& theme) {
    const std::vector<Line> lines = linesOf(slips, person, theme);
    const QString advice =
        words(QT_TRANSLATE_NOOP("LoginSlips", "At your first login, choose your name in the list, enter this "
                                              "password and then choose one of your own. "
                                              "After that, this slip is of no use: destroy it."));
    const double width = report::kPageBodyWidth - 2 * kPadding;
    const auto heightOf = [width](const Line& line) {
        return report::textHeight(line.value, line.font, width - kLabelWidth) + 5;
    };
    const QFont small = theme.font(11);
    report::Block block;
    block.height = 2 * kPadding + report::textHeight(advice, small, width) + 6;
    for (const Line& line : lines)
        block.height += heightOf(line);
    block.paint = [=](QCPPainter& painter, const QRectF& box) {
        double y = box.top() + kPadding;
        for (const Line& line : lines) {
            const double height = heightOf(line);
            report::drawText(painter, QRectF(box.left() + kPadding, y + 2, kLabelWidth - 8, height),
                             line.label, {small, theme.muted});
            report::drawText(painter,
                             QRectF(box.left() + kPadding + kLabelWidth, y, width - kLabelWidth, height),
                             line.value, {line.font, theme.ink});
            y += height;
        }
        report::drawText(painter, QRectF(box.left() + kPadding, y + 6, width, box.bottom() - y), advice,
                         {small, theme.ink});
        painter.setPen(QPen(theme.muted, 0.8, Qt::DashLine)); // a line to cut along
        painter.drawLine(QPointF(box.left(), box.bottom()), QPointF(box.right(), box.bottom()));
    };
    return block;
}

std::vector<report::Block> blocksOf(const LoginSlips& slips, const report::PlotTheme& theme) {
    std::vector<report::Block> blocks;
    for (const database::ImportedPerson& person : slips.people)
        blocks.push_back(slipOf(slips, person, theme));
    return blocks;
}

report::PageFrame frameOf(const LoginSlips& slips) {
    const QString title = words(QT_TRANSLATE_NOOP("LoginSlips", "Login slips"));
    return {title,
            slips.site,
            words(QT_TRANSLATE_NOOP("LoginSlips",
                                    "Cut along the dashed lines and hand each slip to its person.")),
            title,
            QStringLiteral("Chiron"),
            slips.site};
}

} // namespace

core::Result<void> writeLoginSlips(const QString& path, const LoginSlips& slips,
                                   const report::PlotTheme& theme) {
    auto done = report::writePages(path, frameOf(slips), blocksOf(slips, theme), theme);
    if (done && !QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner))
        return core::fail(core::ErrorCode::storage,
                          path.toStdString() + ": others may read this file, which could not be changed");
    return done;
}

bool paintLoginSlips(QPagedPaintDevice& device, const LoginSlips& slips, const report::PlotTheme& theme) {
    return report::paintPages(device, frameOf(slips), blocksOf(slips, theme), theme);
}

} // namespace chiron::desktop
