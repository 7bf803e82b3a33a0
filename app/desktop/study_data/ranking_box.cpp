// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/ranking_box.h"

#include "desktop/frame/app_context.h"
#include "desktop/plots/fitted_table.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "report/plot_view.h"

#include <cmath>

namespace chiron::desktop {

using psychophysics::RankingSummary;
using psychophysics::WorthEstimate;

namespace {

constexpr double k95 = 1.959963984540054; // 97.5 % quantile of the normal distribution, for 95 % intervals
constexpr double kPlotHeight = 230;
constexpr double kThreeAbreast = 860;
constexpr std::size_t kObjects = 3;
enum WorthColumn { modelColumn, objectColumn, worthColumn, worthIntervalColumn, shareColumn, worthColumns };

std::vector<QString> objectNames() {
    return {RankingBox::tr("reference"), RankingBox::tr("D more"), RankingBox::tr("2D more")};
}

bool hasError(const WorthEstimate& worth, std::size_t object) {
    return object < worth.standardError.size() && std::isfinite(worth.standardError[object]);
}

QString pText(double p, const QLocale& locale) {
    if (!std::isfinite(p))
        return RankingBox::tr("p not known");
    return p < 0.001 ? RankingBox::tr("p < %1").arg(locale.toString(0.001, 'f', 3))
                     : RankingBox::tr("p = %1").arg(locale.toString(p, 'f', 3));
}

} // namespace

RankingBox::RankingBox(AppContext& app, const RankingSummary& summary, Of of, QWidget* parent)
    : QFrame(parent), m_app(app) {
    const Theme& theme = app.theme();
    setObjectName(QStringLiteral("data.rankings"));
    setProperty("kind", QStringLiteral("card"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(20), theme.px(16), theme.px(20), theme.px(16));
    column->setSpacing(theme.px(10));
    column->addWidget(kit::label(theme, tr("Rankings"), TextStyle::title));
    if (summary.rankings == 0) {
        column->addWidget(
            kit::notice(theme, "info",
                        tr("There are no scored rankings yet. Agreement and worths appear here after the "
                           "first one.")));
        return;
    }
    const QString basis =
        of == Of::person
            ? tr("%n ranking(s) of three objects; each is one judgement.", nullptr, summary.rankings)
            : tr("%n participant(s); each one's mean ranks are one judgement.", nullptr, summary.judges);
    const QString tied =
        summary.tied > 0 ? QStringLiteral(" ") + tr("%n ranking(s) contained ties.", nullptr, summary.tied)
                         : QString();
    column->addWidget(kit::label(theme, basis + tied, TextStyle::small, "muted"));
    if (summary.adaptive)
        column->addWidget(kit::label(theme,
                                     tr("Each answer decided what came next, so one person's trials are not "
                                        "independent: they have no interval and no p."),
                                     TextStyle::small, "muted"));
    addMeasures(*column, summary, of);
    addWorths(*column, summary);
}

void RankingBox::addMeasures(QVBoxLayout& column, const RankingSummary& summary, Of of) {
    const QLocale locale = m_app.locale();
    const auto decimals = [&](double value) {
        return std::isfinite(value) ? locale.toString(value, 'f', 2) : QStringLiteral("–");
    };
    const auto interval = [&](const QString& text) {
        return text.isEmpty() ? tr("no interval") : tr("95 %: %1").arg(text);
    };
    const auto pOf = [&](double p) { return summary.adaptive ? tr("no p") : pText(p, locale); };
    auto* grid = new FieldGrid(m_app.theme(), locale, true);
    const auto& complete = summary.complete;
    addMeasure(*grid, tr("Completely correct orders"), study_words::percent(complete.share, locale),
               interval(study_words::intervalPercent(complete.low, complete.high, locale)),
               (summary.tied > 0 ? tr("%1 of %2; guessing gives 16.7 % or less.")
                                 : tr("%1 of %2; guessing gives 16.7 %."))
                   .arg(locale.toString(complete.right), locale.toString(complete.of)));
    addMeasure(
        *grid, tr("Kendall's τ"), decimals(summary.tau),
        interval(std::isfinite(summary.tauLow)
                     ? QStringLiteral("%1 … %2").arg(decimals(summary.tauLow), decimals(summary.tauHigh))
                     : QString()),
        tr("Similarity to the true order: 1 = identical, 0 = unrelated, −1 = reversed."));
    addMeasure(
        *grid, tr("Kendall's W"), decimals(summary.agreement.w),
        pOf(std::isfinite(summary.agreement.exactP) ? summary.agreement.exactP : summary.agreement.pValue) +
            (std::isfinite(summary.wLow)
                 ? QStringLiteral(" · ") + interval(QStringLiteral("%1 … %2").arg(decimals(summary.wLow),
                                                                                  decimals(summary.wHigh)))
                 : QString()),
        of == Of::person ? tr("How closely the rankings agree: 0 = not at all, 1 = completely.")
                         : tr("How closely the participants agree: 0 = not at all, 1 = completely."));
    addMeasure(*grid, tr("Page's L"), study_words::number(summary.trend.l, locale, 4),
               pOf(summary.trend.pValue),
               tr("Trend towards the true order; guessing gives %1 on average.")
                   .arg(study_words::number(summary.trend.expected, locale, 4)));
    column.addWidget(grid);
}

void RankingBox::addMeasure(FieldGrid& grid, const QString& name, const QString& value, const QString& detail,
                            const QString& meaning) {
    const Theme& theme = m_app.theme();
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(kit::label(theme, name, TextStyle::small, "muted"));
    column->addWidget(kit::label(theme, value, TextStyle::title));
    column->addWidget(kit::label(theme, detail, TextStyle::small, "muted"));
    column->addWidget(kit::label(theme, meaning, TextStyle::small));
    column->addStretch();
    grid.cell(part);
}

void RankingBox::addWorths(QVBoxLayout& column, const RankingSummary& summary) {
    const Theme& theme = m_app.theme();
    column.addWidget(kit::label(theme, tr("Worth of each object"), TextStyle::strong));
    column.addWidget(kit::label(
        theme,
        tr("How much more often an object was ranked above the others, estimated by three models. The "
           "farther apart two values are, the easier the objects are to tell apart. All differences D of "
           "the run are pooled, and rankings are treated as independent of each other."),
        TextStyle::small, "muted"));
    if (!summary.plackettLuce.fitted && !summary.thurstone.fitted)
        column.addWidget(
            kit::notice(theme, "info",
                        tr("The worths cannot be estimated: an object was always, or never, ranked above the "
                           "others. This happens when the difference is very clear.")));
    else {
        auto* plots = new ResponsiveRow(theme.px(kThreeAbreast), theme.px(8));
        plots->add(worthPlot(summary.tied > 0 ? tr("Bradley-Terry, ties by Davidson") : tr("Bradley-Terry"),
                             tr("ln worth"), summary.bradleyTerry));
        plots->add(worthPlot(tr("Plackett-Luce"), tr("ln worth"), summary.plackettLuce));
        plots->add(worthPlot(tr("Thurstone"), tr("Scale (SD of a difference)"), summary.thurstone));
        column.addWidget(plots);
    }
    column.addWidget(worthTable(summary));
}

QWidget* RankingBox::worthPlot(const QString& title, const QString& axis, const WorthEstimate& worth) {
    const Theme& theme = m_app.theme();
    auto* plot = new report::PlotView(plotThemeOf(theme, m_app.locale()));
    plot->setMinimumHeight(theme.px(kPlotHeight));
    plot->setTitle(title);
    plot->setYAxis({axis, {}, {}});
    plot->setXCategories(objectNames());
    plot->setLegendShown(false);
    std::vector<report::PlotPoint> points;
    std::vector<double> halves;
    for (std::size_t i = 0; worth.fitted && i < worth.logWorth.size(); ++i) {
        points.push_back({static_cast<double>(i), worth.logWorth[i]});
        halves.push_back(hasError(worth, i) ? k95 * worth.standardError[i]
                                            : std::numeric_limits<double>::quiet_NaN());
    }
    if (points.empty())
        plot->setNote(tr("Not estimable"));
    else
        plot->addMeans(tr("estimate with its 95 % interval"), points, halves);
    return plot;
}

QWidget* RankingBox::worthTable(const RankingSummary& summary) {
    const QLocale locale = m_app.locale();
    auto* table = new FittedTable(m_app.theme(), worthColumns);
    table->setObjectName(QStringLiteral("data.worths"));
    table->setAccessibleName(tr("Worth of each object"));
    table->setHorizontalHeaderLabels(
        {tr("Model"), tr("Object"), tr("Worth"), tr("95 % interval"), tr("Share")});
    const std::pair<QString, const WorthEstimate*> models[] = {{tr("Bradley-Terry"), &summary.bradleyTerry},
                                                               {tr("Plackett-Luce"), &summary.plackettLuce},
                                                               {tr("Thurstone"), &summary.thurstone}};
    table->setRowCount(static_cast<int>(std::size(models) * kObjects));
    const QString dash = QStringLiteral("–");
    int row = 0;
    for (const auto& [name, worth] : models) {
        double total = 0.0;
        for (const double log : worth->logWorth)
            total += std::exp(log);
        for (std::size_t i = 0; i < kObjects; ++i, ++row) {
            const bool known = worth->fitted && i < worth->logWorth.size();
            const double value = known ? worth->logWorth[i] : 0.0;
            const auto put = [&](int column, const QString& text) {
                table->setItem(row, column, new QTableWidgetItem(text));
            };
            const auto fixed = [&](double number) { return locale.toString(number, 'f', 2); };
            put(modelColumn, name);
            put(objectColumn, objectNames()[i]);
            put(worthColumn, known ? fixed(value) : tr("not estimable"));
            const double half = known && hasError(*worth, i) ? k95 * worth->standardError[i] : 0.0;
            put(worthIntervalColumn,
                half > 0.0 ? QStringLiteral("%1 … %2").arg(fixed(value - half), fixed(value + half)) : dash);
            put(shareColumn, known && worth != &summary.thurstone
                                 ? study_words::percent(std::exp(value) / total, locale)
                                 : dash);
        }
    }
    table->setRowsSeen(table->rowCount());
    return table;
}

} // namespace chiron::desktop
