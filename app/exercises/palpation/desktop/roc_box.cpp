// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/roc_box.h"

#include "curriculum/exercises/palpation/scoring/roc_curve.h"
#include "database/database.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"
#include "report/plot_view.h"

#include <QCoreApplication>
#include <array>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(RocWords)
};

constexpr int kHeight_px = 340;

} // namespace

QString rocSummary(const session::PooledDetection& pooled, bool felt, const scoring::RocCurve& curve,
                   const QLocale& locale) {
    const core::DetectionCounts counts = pooled.counts();
    return Words::tr("Area under the curve: %1, where 0.5 is chance and 1 is perfect. Sessions: %2 (%3). "
                     "Places with a lump: %4, without: %5.")
        .arg(locale.toString(curve.area, 'f', 2), locale.toString(pooled.sessions),
             felt ? Words::tr("force felt") : Words::tr("force shown"), locale.toString(counts.ofSignal),
             locale.toString(counts.ofNoise));
}

std::unique_ptr<report::PlotView> rocPlot(const scoring::RocCurve& curve, const Theme& theme,
                                          const QLocale& locale) {
    auto view = std::make_unique<report::PlotView>(plotThemeOf(theme, locale));
    view->setTitle(Words::tr("Hits against false alarms, from certain to a guess"));
    view->setAccessibleName(Words::tr("Hits against false alarms, from certain to a guess"));
    view->setXAxis({Words::tr("False alarm rate"), 0.0, 1.0});
    view->setYAxis({Words::tr("Hit rate"), 0.0, 1.0});
    std::vector<double> x;
    std::vector<double> y;
    std::vector<report::PlotPoint> points;
    for (const scoring::RocPoint& point : curve.points) {
        x.push_back(point.falseAlarmRate);
        y.push_back(point.hitRate);
        points.push_back({point.falseAlarmRate, point.hitRate});
    }
    constexpr std::array<double, 2> kEnds{0.0, 1.0};
    view->addLine(Words::tr("chance"), kEnds, kEnds, report::PlotStyle::dashedB);
    view->addLine(Words::tr("you"), x, y, report::PlotStyle::solidA);
    view->addMarkers({}, points, report::PlotStyle::solidA);
    return view;
}

RocBox::RocBox(const Theme& theme, const QLocale& locale, QWidget* parent)
    : ResultsPart(parent), m_theme(theme), m_locale(locale), m_panel(new StatePanel(theme)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(kit::label(theme, tr("Confidence and accuracy (ROC)"), TextStyle::title));
    m_panel->setMinimumHeight(theme.px(kHeight_px));
    column->addWidget(m_panel);
}

RocBox::~RocBox() {
    if (m_work)
        m_work->cancel();
}

void RocBox::ask(Background& background, database::Database& database, const database::Actor& actor,
                 const ResultsQuestion& question) {
    if (m_level == question.level)
        return;
    m_level = question.level;
    if (m_work)
        m_work->cancel();
    const session::DetectionQuery query{question.person, question.level, question.felt, {}};
    m_work = background.run(
        this,
        [&database, actor, query](WorkToken& token) -> core::Result<session::PooledDetection> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return session::detectionOf(**connection, actor, query, [&token](double part) {
                token.setProgress(static_cast<int>(100 * part), 100);
                return !token.cancelled();
            });
        },
        [this, query](core::Result<session::PooledDetection> pooled) {
            if (query.level != m_level)
                return; // another level was chosen in the meantime
            if (pooled)
                show(*pooled, query.felt);
            else
                m_panel->showError(tr("The recordings could not be read"), pooled.error());
        });
    m_panel->showLoading(tr("Reading the recordings …"), m_work);
}

void RocBox::show(const session::PooledDetection& pooled, bool felt) {
    const core::DetectionCounts counts = pooled.counts();
    const auto curve = core::isUsable(counts) ? scoring::rocOf(pooled.ratings) : std::nullopt;
    if (!curve) {
        m_panel->showEmpty(tr("Not enough answers yet"),
                           tr("A curve needs at least %1 places with a lump and as many without. So far: %2 "
                              "with, %3 without.")
                               .arg(m_locale.toString(core::kUsableCounts),
                                    m_locale.toString(counts.ofSignal), m_locale.toString(counts.ofNoise)));
        return;
    }
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    auto* words = kit::label(m_theme, rocSummary(pooled, felt, *curve, m_locale));
    words->setObjectName(QStringLiteral("results.roc_words"));
    column->addWidget(words);
    auto plot = rocPlot(*curve, m_theme, m_locale);
    plot->setObjectName(QStringLiteral("results.roc"));
    plot->setMinimumHeight(m_theme.px(kHeight_px - 60));
    column->addWidget(plot.release(), 1); // the layout's widget owns it from here on
    delete m_panel->content();
    m_panel->setContent(holder);
    m_panel->showContent();
}

} // namespace chiron::desktop
