// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_blocks.h"

#include "report/headline_card_painter.h"
#include "report/report_section.h"
#include "report/report_text.h"
#include "report/session_plots.h"
#include "report/text_box.h"

#include <algorithm>
#include <qcustomplot.h>

namespace chiron::report {

namespace {
void text(QCPPainter& p, const QRectF& box, const QFont& font, const QColor& ink, int flags,
          const QString& words) {
    p.setFont(font);
    p.setPen(ink);
    p.drawText(box, flags, words);
}
/// The value to compare with: a benchmark, or the result of guessing.
QString besides(const MetricRow& row, const QLocale& locale) {
    const QString band = formatBand(row, locale);
    return band.isEmpty() ? chanceWords(row, locale) : band;
}
QString missedMark(const MetricRow& row, const QLocale& locale) {
    const QString name = row.name.isEmpty() ? row.id : row.name;
    const QString gate = formatGate(row, locale);
    if (!row.value && !row.reason.isEmpty())
        return Words::tr("%1 has no value (%2), pass mark %3").arg(name, row.reason, gate);
    return Words::tr("%1: %2, pass mark %3").arg(name, formatValue(row.value, row.unit, locale), gate);
}

} // namespace

ReportBlocks::ReportBlocks(const ReportData& data, const PlotTheme& theme, double width)
    : BlockMaker(theme, width), m_data(data) {
    addBanner();
    addTitle();
    addVerdict();
    addFacts();
    addHeadlines();
    for (const auto& section : m_data.sections)
        section->addTo(*this);
    addForce();
    addCriticalErrors();
    addMetrics();
    addPlots();
    addIntegrity();
}

void ReportBlocks::addBanner() {
    QString words;
    if (m_data.demonstration)
        words = Words::tr("DEMONSTRATION: invented people and results, not for assessment");
    else if (m_data.simulated)
        words = Words::tr("SIMULATED OPERATOR: a scripted hand, not a person");
    if (words.isEmpty())
        return;
    add(26, 0, [this, words](QCPPainter& p, const QRectF& box) {
        p.setPen(QPen(m_theme.warning, 1.0));
        p.setBrush(m_theme.warningFill);
        p.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        text(p, box, m_theme.font(12, true), m_theme.warning, Qt::AlignCenter, words);
    });
}

void ReportBlocks::addTitle() {
    const QString person = m_data.person.isEmpty() ? Words::tr("Unnamed person") : m_data.person;
    const QString task = m_data.levelTitle.isEmpty() ? m_data.exerciseTitle
                                                     : Words::tr("%1 · level %2: %3")
                                                           .arg(m_data.exerciseTitle)
                                                           .arg(m_data.level)
                                                           .arg(m_data.levelTitle);
    const QFont large = m_theme.font(24, true);
    const QFont middle = m_theme.font(14);
    const double above = textHeight(person, large, m_width);
    const double below = task.isEmpty() ? 0.0 : textHeight(task, middle, m_width);
    add(above + (task.isEmpty() ? 0.0 : below + 6), 12, [=, this](QCPPainter& p, const QRectF& box) {
        drawText(p, QRectF(box.left(), box.top(), box.width(), above), person, {large, m_theme.ink});
        drawText(p, QRectF(box.left(), box.top() + above + 4, box.width(), below), task,
                 {middle, m_theme.muted});
    });
}

void ReportBlocks::addVerdict() {
    const bool counts = m_data.state == QLatin1String("completed");
    const bool passed = m_data.passed.value_or(false);
    QColor ink = m_theme.muted;
    QColor fill = m_theme.panel;
    QString words = Words::tr("–  No pass mark is set for this level");
    if (!counts) {
        ink = m_theme.warning;
        fill = m_theme.warningFill;
        words =
            Words::tr("!  Does not count: %1")
                .arg(m_data.state.isEmpty() ? Words::tr("its state is not known") : stateWords(m_data.state));
    } else if (m_data.passed) {
        ink = passed ? m_theme.good : m_theme.bad;
        fill = passed ? m_theme.goodFill : m_theme.badFill;
        words = passed ? Words::tr("✓  Passed: every pass mark was met") : Words::tr("✗  Not passed");
        QStringList failed;
        for (const MetricRow& row : m_data.metrics) {
            if (row.passed && !*row.passed)
                failed << missedMark(row, m_theme.locale);
        }
        if (!failed.isEmpty())
            // No semicolon as separator, because in Greek it is a question mark.
            words += QStringLiteral(": ") + failed.join(QStringLiteral(" · "));
    }
    const QFont font = m_theme.font(13, true);
    const double height = textHeight(words, font, m_width - 24) + 14;
    add(height, 10, [=, this](QCPPainter& p, const QRectF& box) {
        p.setPen(QPen(ink, 1.0));
        p.setBrush(fill);
        p.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        drawText(p, box.adjusted(12, 7, -12, 0), words, {font, ink});
    });
}

void ReportBlocks::addFacts() {
    const QLocale& locale = m_theme.locale;
    addPairs({{Words::tr("Recorded"), formatMoment(m_data.startedUtc, m_data.offsetMinutes, locale)},
              {Words::tr("Duration"), formatDuration(m_data.duration_s, locale)},
              {Words::tr("State"), stateWords(m_data.state)},
              {Words::tr("Device"), m_data.device},
              {Words::tr("Force"), !m_data.felt       ? Words::tr("shown, not felt")
                                   : m_data.simulated ? Words::tr("rendered to a scripted hand")
                                                      : Words::tr("felt")},
              {Words::tr("Session"), m_data.integrity.sessionId}},
             3);
}

void ReportBlocks::addHeadlines() {
    const std::vector<MetricRow> chosen = headlineRows(m_data.metrics);
    if (chosen.empty())
        return;
    add(kHeadlineCardHeight, 16, [this, chosen](QCPPainter& p, const QRectF& box) {
        const double gap = 12.0;
        const double width = (box.width() - 2 * gap) / 3.0;
        for (std::size_t i = 0; i < chosen.size(); ++i)
            paintHeadlineCard(
                p,
                QRectF(box.left() + static_cast<double>(i) * (width + gap), box.top(), width, box.height()),
                chosen[i], m_theme);
    });
}

void ReportBlocks::addMetrics() {
    addHeading(Words::tr("All metrics"));
    if (m_data.state != QLatin1String("completed") && m_data.state != QLatin1String("voided")) {
        const bool any = !m_data.metrics.empty();
        addText(
            any ? Words::tr("The session was not completed: these values are not compared with pass marks.")
                : Words::tr("No trial was completed: there is no score."),
            m_theme.font(12), m_theme.muted, 4);
        if (!any)
            return;
    }
    std::vector<std::vector<QString>> rows;
    for (const MetricRow& row : m_data.metrics) {
        const QString name = row.name.isEmpty() ? row.id : row.name;
        const QString value =
            row.value
                ? formatValue(row.value, row.unit, m_theme.locale)
                : QStringLiteral("– (%1)").arg(row.reason.isEmpty() ? Words::tr("not defined") : row.reason);
        const QString result = !row.passed   ? QString()
                               : *row.passed ? Words::tr("✓ met")
                                             : Words::tr("✗ not met");
        rows.push_back({name, value, formatGate(row, m_theme.locale), besides(row, m_theme.locale), result});
    }
    if (rows.empty())
        rows.push_back({Words::tr("No metrics were computed"), {}, {}, {}, {}});
    addTable({Words::tr("Metric"), Words::tr("Value"), Words::tr("Pass mark"), Words::tr("Benchmark, chance"),
              Words::tr("Result")},
             rows, {0.34, 0.19, 0.16, 0.2, 0.11}, {false, true, true, true, false});
}

void ReportBlocks::addForce() {
    if (!m_data.force)
        return;
    addHeading(Words::tr("Force of the tissue, and what was felt"));
    addText(feltWords(*m_data.force, m_data.felt, m_theme.locale), m_theme.font(12), m_theme.ink, 6);
    if (const QString beyond = beyondCheckedWords(*m_data.force, m_theme.locale); !beyond.isEmpty())
        addText(QStringLiteral("!  ") + beyond, m_theme.font(12, true), m_theme.warning, 6);
}

void ReportBlocks::addCriticalErrors() {
    const std::vector<CriticalError>& errors = m_data.series.criticalErrors;
    if (errors.empty())
        return;
    addHeading(Words::tr("Critical errors"));
    const bool several = m_data.series.tools.size() > 1;
    std::vector<std::vector<QString>> rows;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const CriticalError& error = errors[i];
        const auto tool = static_cast<std::size_t>(std::max(error.tool, 0));
        std::vector<QString> row{m_theme.locale.toString(static_cast<qulonglong>(i + 1)),
                                 formatValue(error.begin_s, QStringLiteral("s"), m_theme.locale),
                                 m_theme.locale.toString(error.trial + 1)};
        if (several)
            row.push_back(tool < m_data.series.tools.size() ? m_data.series.tools[tool].name
                                                            : QStringLiteral("–"));
        row.push_back(error.words);
        rows.push_back(std::move(row));
    }
    std::vector<QString> head{Words::tr("No."), Words::tr("Time"), Words::tr("Trial")};
    std::vector<double> shares{0.07, 0.13, 0.15, 0.65};
    std::vector<bool> right{true, true, true, false};
    if (several) {
        head.push_back(Words::tr("Tool"));
        shares = {0.07, 0.13, 0.15, 0.23, 0.42};
        right.push_back(false);
    }
    head.push_back(Words::tr("What happened"));
    addTable(head, rows, shares, right);
}

void ReportBlocks::addPlots() {
    constexpr double kHigh = 240, kUsual = 216, kLow = 180;
    addHeading(Words::tr("The session over time"));
    addPlot(forcePlot(m_data.series, m_data.forceLimit_N, m_theme), kHigh);
    addPlot(feltForcePlot(m_data.series, m_data.forceLimit_N, m_theme), kUsual);
    addPlot(measuredForcePlot(m_data.series, m_data.forceLimit_N, m_theme), kUsual);
    std::vector<std::unique_ptr<PlotView>> places = positionPlots(m_data.series, m_theme);
    for (auto& place : places)
        addPlot(std::move(place), places.size() > 1 ? kLow : kUsual);
    addPlot(speedPlot(m_data.series, m_theme), kUsual);
}

void ReportBlocks::addIntegrity() {
    const QLocale& locale = m_theme.locale;
    const IntegrityFacts& facts = m_data.integrity;
    const LoopFacts& loop = m_data.loop;
    const auto micro = [&](double us) { return formatValue(us, QStringLiteral("µs"), locale); };
    const std::size_t first = m_blocks.size();
    addHeading(Words::tr("Where these numbers come from"));
    addPairs({{Words::tr("Recorded samples"), locale.toString(static_cast<qulonglong>(facts.frames))},
              {Words::tr("Lost samples"), locale.toString(static_cast<qulonglong>(facts.dropped))},
              {Words::tr("Stored bytes"), locale.toString(static_cast<qulonglong>(facts.bytes))},
              {Words::tr("Ticks: all, late, skipped"),
               QStringLiteral("%1, %2, %3")
                   .arg(locale.toString(static_cast<qulonglong>(loop.ticks)),
                        locale.toString(static_cast<qulonglong>(loop.late)),
                        locale.toString(static_cast<qulonglong>(loop.skipped)))},
              {Words::tr("Lateness: median, 99th percentile"),
               loop.realtime ? QStringLiteral("%1, %2").arg(micro(loop.p50_us), micro(loop.p99_us))
                             : Words::tr("ran as fast as the computer could")},
              {Words::tr("Maximum lateness"), loop.realtime ? micro(loop.max_us) : QStringLiteral("–")}},
             3);
    std::vector<std::pair<QString, QString>> digests{{Words::tr("Build"), facts.buildId},
                                                     {Words::tr("Content (SHA-256)"), facts.contentSha256}};
    if (!facts.taskSha256.isEmpty())
        digests.emplace_back(Words::tr("Content without texts (SHA-256)"), facts.taskSha256);
    digests.emplace_back(Words::tr("Recording (BLAKE2b)"), facts.recordingDigest);
    if (!facts.scoreSeal.isEmpty())
        digests.emplace_back(Words::tr("Score (BLAKE2b)"), facts.scoreSeal);
    addPairs(digests, 1);
    // Keeps the group on one page: a digest alone on a page says nothing.
    for (std::size_t i = first; i + 1 < m_blocks.size(); ++i)
        m_blocks[i].keepWithNext = true;
}

} // namespace chiron::report
