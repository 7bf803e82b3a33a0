// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "session/session_setup.h"
#include "simulation/scene.h"
#include "sweep/level_numbers.h"
#include "sweep/true_contact.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::tests {

/// A law that a scene of the exercise may render, whatever level does.
struct StatedLaw {
    std::string name;
    bool hasPotential = false; ///< by models.md
    bool told = false;         ///< by the scene: IScene::conservative()
};

/// Paths on which the force once jumped, to be gone again: ten from the first one on.
struct FormerJump {
    std::string name;
    int level = 1;
    std::uint64_t seed = 0;
    int firstPath = 0;
};

/// What the sweep must know of one exercise that its level's common keys do not say. Every exercise has a
/// file tests/exercises/<id>/sweep_facts.cpp with one object of a class of its own, which is known by being
/// made; the file is found by its name.
class SweepFacts {
public:
    SweepFacts(const SweepFacts&) = delete;
    SweepFacts& operator=(const SweepFacts&) = delete;
    virtual ~SweepFacts() = default;

    /// Completes what the common keys of a level say.
    virtual void complete(const catalogue::ExerciseLevel&, LevelNumbers&) const {}
    /// For a scene that was made from this set-up and outlives what is returned.
    virtual std::unique_ptr<TrueContact> trueContact(const session::SessionSetup& setup,
                                                     simulation::IScene& scene) const = 0;
    /// The laws of which some have no potential; empty: all have one.
    virtual std::vector<StatedLaw> laws() const { return {}; }
    virtual std::vector<FormerJump> formerJumps() const { return {}; }

    using ByExercise = std::map<std::string, const SweepFacts*, std::less<>>;
    static const ByExercise& all();
    static const SweepFacts* of(std::string_view exercise); ///< null: nobody wrote them

protected:
    explicit SweepFacts(std::string exercise); ///< before main(): the object lives as long as the program
};

} // namespace chiron::tests
