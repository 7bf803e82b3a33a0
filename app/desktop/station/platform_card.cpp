// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/platform_card.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/station/platform_words.h"
#include "desktop/widgets/kit.h"
#include "report/plot_view.h"

#include <QHBoxLayout>

namespace chiron::desktop {

namespace {
constexpr int kPlotHeight_px = 260;
}

PlatformCard::PlatformCard(const Theme& theme, const QLocale& locale, bool mayRun, QWidget* parent)
    : QFrame(parent), m_theme(theme), m_locale(locale), m_results(new QVBoxLayout) {
    setProperty("kind", QStringLiteral("card"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(16), theme.px(14), theme.px(16), theme.px(14));
    column->setSpacing(theme.px(8));
    column->addWidget(kit::label(theme, tr("Fingertip platform"), TextStyle::title));
    column->addWidget(kit::label(
        theme,
        tr("Verification of the simulated platform: the published sine and orientations, force steps, and "
           "the maximum force on the finger pad, on eight simulated fingers."),
        TextStyle::body, "muted"));
    m_results->setSpacing(theme.px(8));
    column->addLayout(m_results);
    if (!mayRun) {
        column->addWidget(kit::label(theme, tr("A researcher or an administrator can run it here."),
                                     TextStyle::body, "muted"));
        return;
    }
    auto* row = new ResponsiveRow(theme.px(460), theme.px(8));
    m_run = kit::button(theme, tr("Verify the platform"), "primary", QStringLiteral("run-build"));
    m_run->setObjectName(QStringLiteral("station.verify"));
    connect(m_run, &QPushButton::clicked, this, &PlatformCard::checkAsked);
    row->add(m_run, 0);
    m_record = kit::button(theme, tr("Record (PDF) …"), "", QStringLiteral("document-save"));
    m_record->setObjectName(QStringLiteral("station.record"));
    m_record->setEnabled(false);
    connect(m_record, &QPushButton::clicked, this, &PlatformCard::recordAsked);
    row->add(m_record, 0);
    row->add(new QWidget, 1); // takes the remaining width
    column->addWidget(row);
}

void PlatformCard::clear() {
    while (QLayoutItem* item = m_results->takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

void PlatformCard::setReady(bool ready) {
    if (m_run)
        m_run->setEnabled(ready);
}

void PlatformCard::showStopped() {
    clear();
    m_results->addWidget(kit::label(m_theme, tr("The verification was stopped before it finished."),
                                    TextStyle::body, "muted"));
}

void PlatformCard::showError(const core::Error& error) {
    clear();
    m_results->addWidget(
        kit::notice(m_theme, "bad",
                    tr("The verification could not be done: %1").arg(QString::fromStdString(error.message))));
}

void PlatformCard::show(PlatformCheck check) {
    clear();
    m_check = std::move(check);
    auto* verdict =
        kit::notice(m_theme, m_check->holds() ? "info" : "warning", platformVerdict(*m_check, m_locale));
    verdict->setObjectName(QStringLiteral("station.verdict"));
    m_results->addWidget(verdict);
    auto* serial = kit::label(
        m_theme, tr("Serial number: %1").arg(serialWords(QString::fromStdString(m_check->serialNumber))));
    serial->setObjectName(QStringLiteral("station.serial"));
    m_results->addWidget(serial);
    for (const QString& fact : platformFacts(*m_check, m_locale))
        m_results->addWidget(kit::label(m_theme, fact));
    addTable(platformFigures(*m_check, m_locale), "station.figures");
    addTable(platformFingers(*m_check, m_locale), "station.fingers");
    addPlots();
    if (!m_check->worse.empty())
        addTable(platformDegradation(*m_check, m_locale), "station.worse");
    if (m_record)
        m_record->setEnabled(true);
}

void PlatformCard::addTable(const report::CheckTable& table, const char* name) {
    m_results->addWidget(kit::label(m_theme, table.title, TextStyle::strong));
    auto* view = new FittedTable(m_theme, static_cast<int>(table.lines.front().size()));
    view->setObjectName(QLatin1String(name));
    view->setAccessibleName(table.title);
    view->setHorizontalHeaderLabels(table.lines.front());
    view->setRowCount(static_cast<int>(table.lines.size()) - 1);
    for (int row = 1; row < static_cast<int>(table.lines.size()); ++row)
        for (int column = 0; column < view->columnCount(); ++column)
            view->setItem(row - 1, column,
                          new QTableWidgetItem(table.lines[static_cast<std::size_t>(row)].value(column)));
    view->setRowsSeen(view->rowCount());
    m_results->addWidget(view);
}

void PlatformCard::addPlots() {
    const report::PlotTheme look = plotThemeOf(m_theme, m_locale);
    auto sine = platformSinePlot(*m_check, look);
    sine->setObjectName(QStringLiteral("station.sine"));
    sine->setMinimumHeight(m_theme.px(kPlotHeight_px));
    m_results->addWidget(sine.release()); // the layout's widget owns it now
    auto* row = new ResponsiveRow(m_theme.px(640), m_theme.px(12));
    auto poses = platformPosePlot(*m_check, look);
    auto errors = platformErrorPlot(*m_check, look);
    poses->setObjectName(QStringLiteral("station.poses"));
    errors->setObjectName(QStringLiteral("station.errors"));
    for (report::PlotView* view : {poses.get(), errors.get()})
        view->setMinimumHeight(m_theme.px(kPlotHeight_px));
    row->add(poses.release());
    row->add(errors.release());
    m_results->addWidget(row);
}

core::Result<void> PlatformCard::writeRecord(const QString& path, const CheckCircumstances& of) const {
    if (!m_check)
        return core::fail(core::ErrorCode::wrongUse, "nothing was verified yet");
    const report::PlotTheme paper = report::lightTheme(m_locale); // paper is always light
    auto sine = platformSinePlot(*m_check, paper);
    auto poses = platformPosePlot(*m_check, paper);
    auto errors = platformErrorPlot(*m_check, paper);
    report::CheckRecord record;
    record.title = tr("Verification of the simulated fingertip platform");
    record.head = checkHead(of, m_locale);
    record.foot = checkFoot(of, m_locale);
    record.verdict = (m_check->holds() ? tr("Passed.") : tr("Failed.")) + QLatin1Char(' ') +
                     platformVerdict(*m_check, m_locale);
    record.facts = platformFacts(*m_check, m_locale);
    record.tables = {platformLimits(*m_check, m_locale), platformFigures(*m_check, m_locale),
                     platformFingers(*m_check, m_locale)};
    if (!m_check->worse.empty())
        record.tables.push_back(platformDegradation(*m_check, m_locale));
    record.plots = {sine.get(), poses.get(), errors.get()};
    return report::writeCheckPdf(path, record, paper);
}

} // namespace chiron::desktop
