// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/tissue_content.h"

#include "core/units.h"
#include "simulation/palpation/tissue_surface.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace chiron::catalogue {

namespace {

using Tissue = simulation::TissueParameters;

struct Key {
    const char* name;
    double Tissue::*member;
    double perUnit; ///< content units per SI unit
};

constexpr double kMm = 1e3;
constexpr double kKilo = 1e3;

constexpr Key kKeys[] = {
    {"poisson", &Tissue::poisson, 1.0},
    {"contact_radius_mm", &Tissue::contactRadius_m, kMm},
    {"stiffness_N_per_m", &Tissue::stiffness_N_per_m, 1.0},
    {"tangent_along_N_per_m", &Tissue::tangentAlong_N_per_m, 1.0},
    {"tangent_across_N_per_m", &Tissue::tangentAcross_N_per_m, 1.0},
    {"friction", &Tissue::friction, 1.0},
    {"damping_depth_mm", &Tissue::dampingDepth_m, kMm},
    {"sinkage", &Tissue::sinkage, 1.0},
    {"second_stiffness_N_per_m", &Tissue::secondStiffness_N_per_m, 1.0},
};

constexpr std::array<const char*, 3> kDamping{"damping_along_N_s_per_m", "damping_across_N_s_per_m",
                                              "damping_normal_N_s_per_m"};
constexpr std::array<const char*, 2> kContacts{"anchored", "p3_recast"}; ///< in the order of TissueContactLaw
/// In the order of LumpLaw.
constexpr std::array<const char*, 3> kLumpLaws{"inclusion", "second_surface", "stiffness_times_depth"};

double radians(double degrees) {
    return core::kPi / 180.0 * degrees;
}

double numberOr(const ObjectReader& json, const char* key, double otherwise) {
    return json.has(QLatin1String(key)) ? json.number(QLatin1String(key)) : otherwise;
}

std::string nameOf(const ObjectReader& json) {
    return json.has("name") ? json.text("name") : std::string();
}

template <class Law, std::size_t n>
void readLaw(const ObjectReader& json, const char* key, const std::array<const char*, n>& names, Law& out) {
    if (!json.has(QLatin1String(key)))
        return;
    const std::string given = json.text(QLatin1String(key));
    QStringList known;
    for (std::size_t i = 0; i < n; ++i) {
        known.push_back(QLatin1String(names[i]));
        if (given == names[i]) {
            out = static_cast<Law>(i);
            return;
        }
    }
    json.problems().push_back({memberPath(json.path(), QLatin1String(key)),
                               quoted(QString::fromStdString(given)),
                               QStringLiteral("one of ") + known.join(QStringLiteral(", "))});
}

/// Reads centre, half axes and rotation of an ellipse on the surface, for bumps and distractors.
template <class Ellipse> void readEllipse(const ObjectReader& json, Ellipse& out) {
    out.centre_m = {numberOr(json, "x_mm", 0.0) / kMm, numberOr(json, "y_mm", 0.0) / kMm};
    out.radii_m = {json.number("radius_x_mm") / kMm, json.number("radius_y_mm") / kMm};
    out.turn_rad = radians(numberOr(json, "turn_deg", 0.0));
}

const std::vector<QString> kEllipseKeys{"x_mm", "y_mm", "radius_x_mm", "radius_y_mm", "turn_deg"};

std::vector<QString> ellipseKeysAnd(std::initializer_list<QString> more) {
    std::vector<QString> keys = kEllipseKeys;
    keys.insert(keys.end(), more);
    return keys;
}

void readBumps(const ObjectReader& json, Tissue& out) {
    json.eachObject("bumps", [&](const ObjectReader& one) {
        simulation::SurfaceBump bump;
        readEllipse(one, bump);
        bump.height_m = one.number("height_mm") / kMm;
        refuseUnknownKeys(one, ellipseKeysAnd({"height_mm"}), QStringLiteral("a number of a bump"));
        out.shape.bumps.push_back(bump);
    });
}

void readLayers(const ObjectReader& json, Tissue& out) {
    out.layers.clear();
    json.eachObject("layers", [&](const ObjectReader& one) {
        simulation::TissueLayer layer;
        layer.name = nameOf(one);
        layer.thickness_m = numberOr(one, "thickness_mm", 100.0) / kMm;
        layer.modulus_Pa = one.number("modulus_kPa") * kKilo;
        refuseUnknownKeys(one, {"name", "thickness_mm", "modulus_kPa"},
                          QStringLiteral("a number of a layer"));
        out.layers.push_back(layer);
    });
}

void readDistractors(const ObjectReader& json, Tissue& out) {
    json.eachObject("distractors", [&](const ObjectReader& one) {
        simulation::StiffRegion region;
        region.name = nameOf(one);
        readEllipse(one, region);
        region.gain = one.number("gain");
        refuseUnknownKeys(one, ellipseKeysAnd({"name", "gain"}), QStringLiteral("a number of a distractor"));
        out.regions.push_back(region);
    });
}

} // namespace

Tissue readTissue(const ObjectReader& json) {
    Tissue out;
    std::vector<QString> known{"tissue",         "plane_height_mm", "bumps",    "layers",
                               "fibre_turn_deg", "contact",         "lump_law", "distractors"};
    for (const Key& key : kKeys) {
        known.push_back(QLatin1String(key.name));
        if (json.has(known.back()))
            out.*key.member = json.number(known.back()) / key.perUnit;
    }
    for (std::size_t i = 0; i < kDamping.size(); ++i) {
        known.push_back(QLatin1String(kDamping[i]));
        const auto axis = static_cast<Eigen::Index>(i);
        out.damping_Ns_per_m[axis] = numberOr(json, kDamping[i], out.damping_Ns_per_m[axis]);
    }
    out.shape.planeHeight_m = numberOr(json, "plane_height_mm", 0.0) / kMm;
    const double turn_rad = radians(numberOr(json, "fibre_turn_deg", 0.0));
    out.fibreDirection = {std::cos(turn_rad), std::sin(turn_rad), 0.0};
    readLaw(json, "contact", kContacts, out.contact);
    readLaw(json, "lump_law", kLumpLaws, out.lumps);
    if (json.has("bumps"))
        readBumps(json, out);
    if (json.has("layers"))
        readLayers(json, out);
    if (json.has("distractors"))
        readDistractors(json, out);
    refuseUnknownKeys(json, known, QStringLiteral("a property of a tissue"));
    return out;
}

void checkTissue(const Tissue& tissue, const QString& path, Problems& problems) {
    if (tissue.layers.empty())
        problems.push_back(
            {memberPath(path, "layers"), QStringLiteral("none"), QStringLiteral("one at least")});
    const double unique_m = simulation::TissueSurface(tissue.shape).deepestUnique_m();
    if (unique_m <= tissue.contactRadius_m)
        problems.push_back(
            {memberPath(path, "bumps"),
             QStringLiteral("a surface that bends round %1 mm").arg(kMm * unique_m, 0, 'g', 3),
             QStringLiteral("gentler: more than the finger's own pad, contact_radius_mm = %1 mm")
                 .arg(kMm * tissue.contactRadius_m, 0, 'g', 3)});
}

} // namespace chiron::catalogue
