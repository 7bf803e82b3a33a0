// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/object_content.h"

#include "simulation/geometry/mesh/mesh_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace chiron::catalogue {

namespace {

using simulation::MeshSource;

struct Key {
    const char* name;
    double MeshSource::*member;
};

constexpr double kMm = 1e3;

constexpr Key kKeys[] = {
    {"half_axis_x_mm", &MeshSource::halfAxisX_m},
    {"half_axis_y_mm", &MeshSource::halfAxisY_m},
    {"half_axis_z_mm", &MeshSource::halfAxisZ_m},
    {"plate_radius_mm", &MeshSource::plateRadius_m},
    {"plate_thickness_mm", &MeshSource::plateThickness_m},
    {"edge_mm", &MeshSource::edge_m},
    {"bump_height_mm", &MeshSource::bumpHeight_m},
    {"bump_wavelength_mm", &MeshSource::bumpWavelength_m},
};

/// In the order of MeshSource::Shape.
constexpr std::array<const char*, 4> kShapes{"none", "dome", "ellipsoid", "stored"};

void readShape(const ObjectReader& json, MeshSource& out) {
    const QString name = QString::fromStdString(json.text("shape"));
    for (std::size_t i = 0; i < kShapes.size(); ++i)
        if (name == QLatin1String(kShapes[i])) {
            out.shape = static_cast<MeshSource::Shape>(i);
            return;
        }
    json.problems().push_back(
        {memberPath(json.path(), "shape"), quoted(name), QStringLiteral("none, dome, ellipsoid or stored")});
}

template <class Whole> void readWholes(const ObjectReader& json, const char* key, std::vector<Whole>& out) {
    if (!json.has(key))
        return;
    const QString path = memberPath(json.path(), key);
    if (!json.json()[QLatin1String(key)].isArray()) {
        json.problems().push_back(
            {path, QStringLiteral("another type"), QStringLiteral("an array of whole numbers")});
        return;
    }
    const QJsonArray array = json.json()[QLatin1String(key)].toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const double value = array[i].toDouble(std::numeric_limits<double>::quiet_NaN());
        if (!(value == std::floor(value)) || value < static_cast<double>(std::numeric_limits<Whole>::min()) ||
            value > static_cast<double>(std::numeric_limits<Whole>::max())) {
            json.problems().push_back(
                {elementPath(path, i), QStringLiteral("no whole number"), QStringLiteral("a whole number")});
            return;
        }
        out.push_back(static_cast<Whole>(value));
    }
}

} // namespace

namespace {

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
    std::vector<QString> known{QStringLiteral("mesh"), QStringLiteral("shape"), QStringLiteral("seed"),
                               QStringLiteral("vertices_um"), QStringLiteral("triangles")};
    for (const Key& key : kKeys) {
        known.push_back(QLatin1String(key.name));
        if (json.has(known.back()))
            out.*key.member = json.number(known.back()) / kMm;
    }
    if (json.has("mesh"))
        out.id = json.text("mesh");
    if (json.has("shape"))
        readShape(json, out);
    if (json.has("seed"))
        out.seed = static_cast<std::uint64_t>(std::max(0, json.integer("seed")));
    readWholes(json, "vertices_um", out.vertices_um);
    readWholes(json, "triangles", out.triangles);
    refuseUnknownKeys(json, known, QStringLiteral("a key of a mesh"));
    return out;
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
            wrong("bump_wavelength_mm", QString::number(mesh.bumpWavelength_m * kMm),
                  QStringLiteral("at least four edges, %1 mm").arg(4.0 * mesh.edge_m * kMm));
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
