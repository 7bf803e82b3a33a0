// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/exercise_part.h"

#include "app/exercises/palpation/desktop/palpation_box.h"
#include "desktop/plots/fitted_table.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/widgets/kit.h"
#include "report/plot_view.h"
#include "report/word_table.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(ExercisePart)
};

struct TitleOf {
    QString operator()(const simulation::SphereApexParameters&) const { return Texts::tr("The answers, seen from above"); }
    QString operator()(const simulation::UrethraInsertionParameters&) const { return Texts::tr("How the endoscope followed the urethra"); }
    QString operator()(const simulation::ElasticTubeParameters&) const { return Texts::tr("How the tube was held and stretched"); }
    QString operator()(const simulation::ObjectHandlingParameters&) const { return Texts::tr("How each object was held and set down"); }
    QString operator()(const simulation::PalpationParameters&) const { return Texts::tr("What was searched and what was found"); }
    QString operator()(const simulation::ComparisonParameters&) const { return Texts::tr("What was compared"); }
};

struct EmptyOf {
    QString operator()(const simulation::SphereApexParameters&) const { return Texts::tr("There is no answer to show. The session is kept and listed."); }
    QString operator()(const simulation::UrethraInsertionParameters&) const {
        return Texts::tr("There is nothing of the procedure to show. The session is kept and listed.");
    }
    QString operator()(const simulation::ElasticTubeParameters&) const {
        return Texts::tr("There is no tension to show. The session is kept and listed.");
    }
    QString operator()(const simulation::ObjectHandlingParameters&) const {
        return Texts::tr("There is no object to show. The session is kept and listed.");
    }
    QString operator()(const simulation::PalpationParameters&) const {
        return Texts::tr("There is no search to show. The session is kept and listed.");
    }
    QString operator()(const simulation::ComparisonParameters&) const {
        return Texts::tr("What was compared and answered is shown with its study.");
    }
};

struct Column {
    std::unique_ptr<QWidget> holder = std::make_unique<QWidget>();
    QVBoxLayout* layout = nullptr;
    explicit Column(const Theme& theme) : layout(new QVBoxLayout(holder.get())) {
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(theme.px(8));
    }
};

QWidget* tableOf(const Theme& theme, const report::WordTable& words, const char* name) {
    auto* table = new FittedTable(theme, static_cast<int>(words.head.size()));
    table->setObjectName(QLatin1String(name));
    table->setAccessibleName(Texts::tr("Result of each trial"));
    table->setHorizontalHeaderLabels(QStringList(words.head.begin(), words.head.end()));
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setRowCount(static_cast<int>(words.rows.size()));
    for (int row = 0; row < table->rowCount(); ++row)
        for (int column = 0; column < table->columnCount(); ++column) {
            auto* item = new QTableWidgetItem(words.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
            if (column != 1 && column + 1 < table->columnCount()) // the last one is as wide as what is left
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table->setItem(row, column, item);
        }
    table->setRowsSeen(table->rowCount());
    return table;
}

/// Makes the widget of one exercise from what was read of the recording.
struct PartOf {
    const Theme& theme;
    const QLocale& locale;
    const DebriefDetails& details;

    QWidget* plot(std::unique_ptr<report::PlotView> view, const char* name, int height_px) const {
        view->setObjectName(QLatin1String(name));
        view->setMinimumHeight(theme.px(height_px));
        return view.release(); // whoever lays it out owns it from here on
    }
    report::PlotTheme look() const { return plotThemeOf(theme, locale); }

    std::unique_ptr<QWidget> operator()(const simulation::SphereApexParameters&) const {
        if (details.parts.apexErrors.empty())
            return nullptr;
        auto row = std::make_unique<ResponsiveRow>(theme.px(640), theme.px(12));
        row->add(plot(report::apexScatterPlot(details.parts.apexErrors, look()), "debrief.scatter", 280), 2);
        row->add(plot(report::apexTrialPlot(details.parts.apexErrors, look()), "debrief.trials", 280), 3);
        return row;
    }

    std::unique_ptr<QWidget> operator()(const simulation::UrethraInsertionParameters&) const {
        if (!details.parts.insertion)
            return nullptr;
        const report::InsertionProfile& profile = *details.parts.insertion;
        Column column(theme);
        if (profile.landmarks > 0) {
            auto* seen = kit::label(theme, Texts::tr("%1 of %2 landmarks of the bladder were seen.").arg(locale.toString(profile.landmarksSeen), locale.toString(profile.landmarks)));
            seen->setObjectName(QStringLiteral("debrief.landmarks"));
            column.layout->addWidget(seen);
        }
        auto* row = new ResponsiveRow(theme.px(640), theme.px(12));
        row->add(plot(report::offsetDepthPlot(profile, look()), "debrief.offset", 250));
        row->add(plot(report::alignmentDepthPlot(profile, look()), "debrief.alignment", 250));
        column.layout->addWidget(row);
        return std::move(column.holder);
    }

    std::unique_ptr<QWidget> operator()(const simulation::ElasticTubeParameters&) const {
        if (!details.parts.tube || details.parts.tube->rows.empty())
            return nullptr;
        const report::TubeReport& tube = *details.parts.tube;
        Column column(theme);
        column.layout->addWidget(plot(report::tensionPlot(tube, look()), "debrief.tension", 230));
        if (auto retraction = report::retractionPlot(tube, look()))
            column.layout->addWidget(plot(std::move(retraction), "debrief.retraction", 230));
        column.layout->addWidget(plot(report::stretchPlot(tube, look()), "debrief.stretch", 230));
        column.layout->addWidget(tableOf(theme, report::tubeTable(tube, locale), "debrief.tube_trials"));
        return std::move(column.holder);
    }

    std::unique_ptr<QWidget> operator()(const simulation::ObjectHandlingParameters&) const {
        if (!details.parts.handling || details.parts.handling->rows.empty())
            return nullptr;
        const report::HandlingReport& handling = *details.parts.handling;
        Column column(theme);
        auto* row = new ResponsiveRow(theme.px(640), theme.px(12));
        row->add(plot(report::squeezePlot(handling, look()), "debrief.squeeze", 280), 3);
        row->add(plot(report::placePlot(handling, look()), "debrief.place", 280), 2);
        column.layout->addWidget(row);
        column.layout->addWidget(tableOf(theme, report::handlingTable(handling, locale), "debrief.handling_trials"));
        return std::move(column.holder);
    }

    std::unique_ptr<QWidget> operator()(const simulation::PalpationParameters& level) const {
        if (details.palpation.empty())
            return nullptr;
        return std::make_unique<PalpationBox>(theme, locale, level, details.palpation);
    }

    std::unique_ptr<QWidget> operator()(const simulation::ComparisonParameters&) const { return nullptr; } // shown with its study
};

} // namespace

QString exercisePartTitle(const catalogue::ExerciseParameters& level) {
    return std::visit(TitleOf{}, level);
}

QString exercisePartEmpty(const catalogue::ExerciseParameters& level) {
    return std::visit(EmptyOf{}, level);
}

std::unique_ptr<QWidget> exercisePart(const Theme& theme, const QLocale& locale, const catalogue::ExerciseParameters& level,
                                      const DebriefDetails& details) {
    return std::visit(PartOf{theme, locale, details}, level);
}

} // namespace chiron::desktop
