// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_shapes.h"
#include "simulation/evaluate_laws.h"
#include "simulation/geometry/mesh/evaluate_mesh.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::simulation;

namespace {

std::vector<double> defaults(const core::LawDescription& law) {
    std::vector<double> values;
    for (const core::LawParameter& p : law.parameters)
        values.push_back(p.defaultValue);
    return values;
}

void set(const core::LawDescription& law, std::vector<double>& values, std::string_view name, double value) {
    const auto at = std::find_if(law.parameters.begin(), law.parameters.end(),
                                 [&](const core::LawParameter& p) { return p.name == name; });
    if (at == law.parameters.end())
        qFatal("no such parameter");
    values[static_cast<std::size_t>(at - law.parameters.begin())] = value;
}

} // namespace

/// The law "mesh-contact" as the command line tabulates it.
class TestMeshLaw : public QObject {
    Q_OBJECT

private slots:
    void isListed() {
        QVERIFY(std::any_of(evaluateLaws().begin(), evaluateLaws().end(),
                            [](const core::LawDescription& law) { return law.id == "mesh-contact"; }));
    }

    void ballAndDome() {
        const core::LawDescription law = meshContactLaw();
        std::vector<double> p = defaults(law), out(law.outputs.size());
        for (const char* axis : {"half_axis_x_m", "half_axis_y_m", "half_axis_z_m"})
            set(law, p, axis, 0.020);
        set(law, p, "edge_m", 0.0005);
        const std::vector<double> above{0.0, 0.0, 0.019, 0.0, 0.0, -0.01};
        law.evaluate(p, above, out);
        QVERIFY(std::abs(out[2] - (500.0 * 0.002 + 0.01)) < 0.02); // k d + b v
        QVERIFY(std::abs(out[3] - 0.002) < 2e-5 && std::abs(out[6] - 1.0) < 1e-4 &&
                std::abs(out[7] - 0.001) < 2e-5);
        set(law, p, "dome", 1.0);
        law.evaluate(p, above, out);
        QVERIFY(std::abs(out[3] - 0.002) < 2e-5);
        const std::vector<double> onThePlate{0.050, 0.0, 0.0, 0.0, 0.0, 0.0};
        law.evaluate(p, onThePlate, out);
        QVERIFY(std::abs(out[2] - 0.5) < 1e-9 && std::abs(out[6] - 1.0) < 1e-9);
        const std::vector<double> far{0.0, 0.0, 0.1, 0.0, 0.0, 0.0};
        law.evaluate(p, far, out);
        QVERIFY(out[2] == 0.0 && out[3] == 0.0);
    }

    void aMeshThatCannotBeMadeGivesNoNumbers() {
        const core::LawDescription law = meshContactLaw();
        std::vector<double> p = defaults(law), out(law.outputs.size());
        set(law, p, "bump_height_m", 0.01);
        const std::vector<double> in(6, 0.0);
        law.evaluate(p, in, out);
        QVERIFY(std::all_of(out.begin(), out.end(), [](double x) { return std::isnan(x); }));
    }
};

QTEST_APPLESS_MAIN(TestMeshLaw)
#include "test_mesh_law.moc"
