// SPDX-License-Identifier: GPL-3.0-or-later
// Draws P3's figure 6 from our laws: p3_figure6_picture FILE.png
#include "core/fp_environment.h"
#include "report/plot_canvas.h"
#include "report/plot_theme.h"
#include "report/plot_view.h"
#include "support/p3_figure6.h"

#include <QApplication>
#include <cstdio>

using namespace chiron;

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (argc != 2) {
        std::fprintf(stderr, "usage: p3_figure6_picture FILE.png\n");
        return 2;
    }
    core::setModelFloatingPointEnvironment();
    std::vector<double> t, force, normal, lean, shown;
    for (const tests::Figure6Sample& s : tests::figure6()) {
        t.push_back(s.t_s);
        force.push_back(s.force_N);
        normal.push_back(s.normalForce_N);
        lean.push_back(s.lean_rad * 180.0 / core::kPi);
        shown.push_back(s.shown_rad * 180.0 / core::kPi);
    }
    const report::PlotTheme theme = report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    report::PlotView above(theme), below(theme);
    above.setTitle(QStringLiteral("A stroke over a buried tumour: force"));
    above.setXAxis({QStringLiteral("Time (s)"), 0.0, t.back()});
    above.setYAxis({QStringLiteral("Force (N)"), 0.0, {}});
    above.addLine(QStringLiteral("‖F_ext‖"), t, force, report::PlotStyle::solidA);
    above.addLine(QStringLiteral("F_n, shown"), t, normal, report::PlotStyle::dashedB);
    below.setTitle(QStringLiteral("Angle of the force from the surface's normal"));
    below.setXAxis({QStringLiteral("Time (s)"), 0.0, t.back()});
    below.setYAxis({QStringLiteral("α (°)"), 0.0, 45.0});
    below.addLine(QStringLiteral("α, computed"), t, lean, report::PlotStyle::dashedB);
    below.addLine(QStringLiteral("α, shown by the plate"), t, shown, report::PlotStyle::solidA);
    below.addLimit(QStringLiteral("limit of the plate, 30°"), 30.0);
    for (report::PlotView* view : {&above, &below})
        view->setLeftMargin(60.0);
    const QImage picture = report::renderPanels(
        {{&above, QRectF(0, 0, 760, 260)}, {&below, QRectF(0, 268, 760, 260)}}, QSize(760, 528), 1.5, theme);
    const auto written = report::writePng(QString::fromLocal8Bit(argv[1]), picture);
    if (!written)
        std::fprintf(stderr, "%s\n", written.error().message.c_str());
    return written ? 0 : 1;
}
