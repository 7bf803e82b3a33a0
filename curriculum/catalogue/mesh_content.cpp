// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/object_content.h"

#include "catalogue/parameter_rows.h"
#include "simulation/geometry/mesh/mesh_import.h"

namespace chiron::catalogue {

namespace {

using simulation::MeshSource;

using Row = ParameterRow<MeshSource>;

const std::vector<Row>& meshRows() {
    using Shape = MeshSource::Shape;
    static const std::vector<Row> kRows{
        Row::identifier("mesh", &MeshSource::id,
                        "Name of the mesh in content/meshes whose shape holds where none is given here.")
            .withoutDefault(),
        Row::choice<Shape>("shape",
                           {{"none", Shape::none},
                            {"dome", Shape::dome},
                            {"ellipsoid", Shape::ellipsoid},
                            {"stored", Shape::stored}},
                           &MeshSource::shape,
                           "dome: a watertight half ball on a plate; ellipsoid: a closed organ; stored: the "
                           "vertices and triangles given; none: no mesh."),
        Row::number("half_axis_x_mm", units::kMm, {2, 100}, &MeshSource::halfAxisX_m,
                    "Half axis along x; of a dome its radius, in all three."),
        Row::number("half_axis_y_mm", units::kMm, {2, 100}, &MeshSource::halfAxisY_m, "Half axis along y."),
        Row::number("half_axis_z_mm", units::kMm, {2, 100}, &MeshSource::halfAxisZ_m, "Half axis along z."),
        Row::number("plate_radius_mm", units::kMm, {10, 200}, &MeshSource::plateRadius_m,
                    "Dome: of the plate round it."),
        Row::number("plate_thickness_mm", units::kMm, {1, 50}, &MeshSource::plateThickness_m,
                    "Dome: of the plate."),
        Row::number("edge_mm", units::kMm, {0.3, 20}, &MeshSource::edge_m, "Mean edge length asked for."),
        Row::number("bump_height_mm", units::kMm, {0, 10}, &MeshSource::bumpHeight_m,
                    "Amplitude of smooth bumps."),
        Row::number("bump_wavelength_mm", units::kMm, {2, 100}, &MeshSource::bumpWavelength_m,
                    "Wavelength of the bumps."),
        Row::whole<std::uint64_t>("seed", {0, 1000000000}, &MeshSource::seed, "Of the bumps."),
        Row::wholes<std::int32_t>("vertices_um", {0, 150000}, {-1000000, 1000000}, &MeshSource::vertices_um,
                                  "One number.", "Stored: x, y, z by turns.", units::kUm.symbol)
            .withoutDefault(),
        Row::wholes<std::uint32_t>(
            "triangles", {0, 300000}, {0, 49999}, &MeshSource::triangles, "One number.",
            "Stored: three vertices a triangle, counted from 0, counter-clockwise from outside.")
            .withoutDefault(),
    };
    return kRows;
}

/// Returns whether an import repairs this problem without changing the surface. Anything else that it would
/// have to change is refused here.
bool isHarmless(simulation::MeshProblem problem) {
    using simulation::MeshProblem;
    return problem == MeshProblem::duplicateVertices || problem == MeshProblem::unusedVertices ||
           problem == MeshProblem::nonManifoldVertex || problem == MeshProblem::severalShells;
}

/// Checks that the triangles form a surface: closed, consistently oriented, each with an area.
void checkSurface(const MeshSource& mesh, const QString& path, Problems& problems) {
    const QString at = memberPath(path, "triangles");
    const auto shape = simulation::makeMeshShape(mesh);
    if (!shape) {
        problems.push_back({at, QString::fromStdString(shape.error().message), QStringLiteral("a mesh")});
        return;
    }
    const std::size_t before = problems.size();
    for (const simulation::MeshFinding& finding : simulation::importMesh(*shape).report.findings)
        if (!finding.repaired || !isHarmless(finding.problem))
            problems.push_back(
                {at, QString::fromStdString(finding.place + ": " + finding.found),
                 QString::fromStdString(finding.expected + " (chiron-cli mesh import writes such)")});
    if (problems.size() > before)
        return;
    if (const auto made = simulation::makeMesh(mesh); !made)
        problems.push_back(
            {at, QString::fromStdString(made.error().message), QStringLiteral("a closed surface")});
}

} // namespace

MeshSource readMesh(const ObjectReader& json) {
    MeshSource out;
    readParameters(meshRows(), json, QStringLiteral("a key of a mesh"), out);
    return out;
}

QByteArray meshSourceSchema() {
    return parametersSchema(
        {"A triangle mesh",
         "A generator with its numbers, or the triangles themselves; the same values give "
         "the same mesh. A level names a mesh of content/meshes and may change any value.",
         JsonLayout::itemPerLine},
        meshRows());
}

void checkMesh(const MeshSource& mesh, const QString& path, Problems& problems) {
    const auto wrong = [&](const char* key, const QString& found, const QString& expected) {
        problems.push_back({memberPath(path, key), found, expected});
    };
    if (mesh.shape != MeshSource::Shape::stored) {
        if (!mesh.vertices_um.empty() || !mesh.triangles.empty())
            wrong("triangles", QStringLiteral("given"),
                  QStringLiteral("none: only a stored mesh has its own"));
        if (mesh.bumpHeight_m > 0.0 && mesh.bumpWavelength_m < 4.0 * mesh.edge_m)
            wrong("bump_wavelength_mm", QString::number(mesh.bumpWavelength_m * units::kMm.perSi),
                  QStringLiteral("at least four edges, %1 mm").arg(4.0 * mesh.edge_m * units::kMm.perSi));
        return;
    }
    const std::size_t before = problems.size();
    if (mesh.vertices_um.size() < 12 || mesh.vertices_um.size() % 3 != 0)
        wrong("vertices_um", QString::number(mesh.vertices_um.size()),
              QStringLiteral("three numbers a vertex, four vertices at least"));
    if (mesh.triangles.size() < 12 || mesh.triangles.size() % 3 != 0)
        wrong("triangles", QString::number(mesh.triangles.size()),
              QStringLiteral("three numbers a triangle, four triangles at least"));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if (mesh.triangles[i] >= mesh.vertices_um.size() / 3) {
            problems.push_back({elementPath(memberPath(path, "triangles"), static_cast<qsizetype>(i)),
                                QString::number(mesh.triangles[i]),
                                QStringLiteral("a vertex, 0 to %1").arg(mesh.vertices_um.size() / 3 - 1)});
            return;
        }
    if (problems.size() == before)
        checkSurface(mesh, path, problems);
}

} // namespace chiron::catalogue
