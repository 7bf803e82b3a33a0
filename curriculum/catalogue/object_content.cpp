// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/object_content.h"

#include "catalogue/parameter_rows.h"
#include "core/units.h"

#include <cmath>

namespace chiron::catalogue {

namespace {

using Object = simulation::ObjectAttributes;

using Row = ParameterRow<Object>;

const std::vector<Row>& objectRows() {
    static const std::vector<Row> kRows{
        Row::identifier(
            "object", &Object::id,
            "Name of the object in content/objects whose attributes hold where none is given here.")
            .withoutDefault(),
        Row::number("stiffness_N_per_m", units::kN_per_m, {0, 2000}, &Object::stiffness_N_per_m,
                    "Elasticity k: what a small press (or stretch, of a tube) meets, f = -k x."),
        Row::number(
            "stiffening_per_m", units::kPer_m, {0, 500}, &Object::stiffening_per_m,
            "Strain stiffening b: f = -(k/b)(e^(bx) - 1); the stiffness doubles every 0.69/b. 0: none."),
        Row::number("mass_g", units::kG, {0, 500}, &Object::mass_kg, "Weight m g, downward, while lifted."),
        Row::number("recovery_s", units::kS, {0, 10}, &Object::recoveryTime_s,
                    "Deformation: time constant tau with which the surface gives way under a lasting press "
                    "and comes back. 0: at once."),
        Row::number("recovery_share", units::kPure, {0, 3}, &Object::recoveryShare,
                    "Deformation: how much stiffer a quick press is than a lasting one, k1/k."),
        Row::number("roughness_um", units::kUm, {0, 300}, &Object::roughness_m,
                    "Roughness: root mean square of the micro-height."),
        Row::number("roughness_wavelength_mm", units::kMm, {1, 50}, &Object::roughnessWavelength_m,
                    "Roughness: shortest wavelength; the micro-height is white up to it and nothing beyond."),
        Row::whole<std::uint64_t>("roughness_seed", {0, 1000000000}, &Object::roughnessSeed,
                                  "Roughness: which of all such surfaces."),
        Row::number("friction", units::kPure, {0, 2}, &Object::friction,
                    "Coulomb coefficient mu of a clipped bristle."),
        Row::number("bristle_stiffness_N_per_m", units::kN_per_m, {100, 5000},
                    &Object::bristleStiffness_N_per_m,
                    "Bristle stiffness, constant: how far a sticking tool gives way sideways."),
        Row::number("viscosity_N_s_per_m", units::kNs_per_m, {0, 20}, &Object::viscosity_Ns_per_m,
                    "Viscosity inside the object, f = -b v in all directions."),
        Row::number("damping_N_s_per_m", units::kNs_per_m, {0, 20}, &Object::damping_Ns_per_m,
                    "Damping along the surface normal, faded in over the first 0.5 mm."),
    };
    return kRows;
}

/// Largest root mean square slope that roughness may have: about a third, so that d + h stays a surface.
constexpr double kSteepest = 0.35;

} // namespace

Object readObject(const ObjectReader& json) {
    Object out;
    readParameters(objectRows(), json, QStringLiteral("an attribute of an object"), out);
    return out;
}

QByteArray objectAttributesSchema() {
    return parametersSchema({"Attributes of an object",
                             "What an object feels like: P2's building blocks (models.md §2.2), each law in "
                             "modules/simulation/attributes. A level names an object of content/objects and "
                             "may change any attribute.",
                             JsonLayout::itemPerLine},
                            objectRows());
}

void checkObject(const Object& object, const QString& path, Problems& problems) {
    if ((object.recoveryShare > 0.0) != (object.recoveryTime_s > 0.0))
        problems.push_back({memberPath(path, "recovery_share"), QString::number(object.recoveryShare),
                            QStringLiteral("above 0 together with recovery_s, or both 0")});
    // RMS slope along one direction of plane waves of one wavelength in all directions: 2π rms/(√3 λ)
    const double slope = 2.0 * core::kPi / std::sqrt(3.0) * object.roughness_m / object.roughnessWavelength_m;
    if (slope > kSteepest)
        problems.push_back({memberPath(path, "roughness_um"),
                            QString::number(object.roughness_m * units::kUm.perSi),
                            QStringLiteral("at most %1 µm at this wavelength: a slope of %2")
                                .arg(std::floor(object.roughness_m * units::kUm.perSi * kSteepest / slope))
                                .arg(kSteepest)});
}

} // namespace chiron::catalogue
