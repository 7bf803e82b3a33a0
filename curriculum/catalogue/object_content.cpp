// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/object_content.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::catalogue {

namespace {

using Object = simulation::ObjectAttributes;

struct Key {
    const char* name;
    double Object::*member;
    double perUnit; ///< content units per SI unit
};

constexpr double kMm = 1e3;
constexpr double kUm = 1e6;
constexpr double kGrams = 1e3;

constexpr Key kKeys[] = {
    {"stiffness_N_per_m", &Object::stiffness_N_per_m, 1.0},
    {"stiffening_per_m", &Object::stiffening_per_m, 1.0},
    {"mass_g", &Object::mass_kg, kGrams},
    {"recovery_s", &Object::recoveryTime_s, 1.0},
    {"recovery_share", &Object::recoveryShare, 1.0},
    {"roughness_um", &Object::roughness_m, kUm},
    {"roughness_wavelength_mm", &Object::roughnessWavelength_m, kMm},
    {"friction", &Object::friction, 1.0},
    {"bristle_stiffness_N_per_m", &Object::bristleStiffness_N_per_m, 1.0},
    {"viscosity_N_s_per_m", &Object::viscosity_Ns_per_m, 1.0},
    {"damping_N_s_per_m", &Object::damping_Ns_per_m, 1.0},
};

/// Largest root mean square slope that roughness may have: about a third, so that d + h stays a surface.
constexpr double kSteepest = 0.35;

} // namespace

Object readObject(const ObjectReader& json) {
    Object out;
    std::vector<QString> known{QStringLiteral("object"), QStringLiteral("roughness_seed")};
    for (const Key& key : kKeys) {
        known.push_back(QLatin1String(key.name));
        if (json.has(known.back()))
            out.*key.member = json.number(known.back()) / key.perUnit;
    }
    if (json.has("object"))
        out.id = json.text("object");
    if (json.has("roughness_seed"))
        out.roughnessSeed = static_cast<std::uint64_t>(std::max(0, json.integer("roughness_seed")));
    refuseUnknownKeys(json, known, QStringLiteral("an attribute of an object"));
    return out;
}

void checkObject(const Object& object, const QString& path, Problems& problems) {
    if ((object.recoveryShare > 0.0) != (object.recoveryTime_s > 0.0))
        problems.push_back({memberPath(path, "recovery_share"), QString::number(object.recoveryShare),
                            QStringLiteral("above 0 together with recovery_s, or both 0")});
    // RMS slope along one direction of plane waves of one wavelength in all directions: 2π rms/(√3 λ)
    const double slope = 2.0 * core::kPi / std::sqrt(3.0) * object.roughness_m / object.roughnessWavelength_m;
    if (slope > kSteepest)
        problems.push_back({memberPath(path, "roughness_um"), QString::number(object.roughness_m * kUm),
                            QStringLiteral("at most %1 µm at this wavelength: a slope of %2")
                                .arg(std::floor(object.roughness_m * kUm * kSteepest / slope))
                                .arg(kSteepest)});
}

} // namespace chiron::catalogue
